#include "power_connection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "power_equation.hpp"
#include "searched_connection.hpp"

namespace libration::ode {

namespace {

constexpr long digits_of_scale = 30;
constexpr double largest_log2_time = 60;
constexpr double log2_of_first_part = 3;

rational power_of_two_fraction(long exponent) {
    const rational power(integer(1) << static_cast<unsigned>(std::labs(exponent)));
    return exponent < 0 ? rational(1 / power) : power;
}

// y' at 0, for y'(0): a name that is not read as an initial value.
std::string name_of_parameter(const std::string& unknown) {
    const auto open = unknown.find('(');
    return open == std::string::npos
               ? unknown
               : unknown.substr(0, open) + " at " + unknown.substr(open + 1, unknown.size() - open - 2);
}

std::string text_of_exponent(const rational& q) {
    return denominator(q) == 1 ? numerator(q).str() : numerator(q).str() + "/" + denominator(q).str();
}

class power_search {
public:
    power_search(const connection_question& question, power_equation equation, const proof_route& route,
                 march_watch watch)
        : question_(question), equation_(std::move(equation)), route_(route), watch_(std::move(watch)) {
        for (const std::string& each : question.unknowns) {
            names_.push_back(name_of_parameter(each));
        }
    }

    connection result() {
        const expression& value = equation_.open.starts[0];
        const expression& slope = equation_.open.starts[1];
        const number& point = equation_.open.system.point();
        if (equation_.is_autonomous() || point.sign() > 0) {
            if (value.is(0)) {
                refuse_start("begins with " + equation_.name + " = 0: choose another initial point");
            }
            if (equation_.is_autonomous()) {
                time_ = expression(power_of_two_fraction(std::lround(log2_of_scale()) - 1));
            } else {
                time_ = expression(point);
            }
            return found(logarithmic_question(equation_, names_, time_, value, slope), {});
        }
        require_regular_start();
        const long root = equation_.root();
        root_of_time_ =
            power_of_two_fraction(std::lround((log2_of_scale() - log2_of_first_part) / static_cast<double>(root)));
        time_ = pow(expression(root_of_time_), static_cast<int>(root));
        make_first_part();
        return found(logarithmic_question(equation_, names_, time_, 1, 0),
                     [&](const std::vector<ball>& numbers, long bits, long error_bits) {
                         return after_first_part(numbers, bits, error_bits);
                     });
    }

private:
    [[noreturn]] static void refuse_start(const std::string& reason) {
        throw error(error_kind::undecided, error_subject::problem, "", reason);
    }

    void require_regular_start() const {
        if (equation_.open.system.point().sign() < 0) {
            refuse_start(
                "begins before t = 0, where its powers of the time are not continued: choose another initial point");
        }
        for (const power_term& each : equation_.terms) {
            if (!(each.time > -1)) {
                refuse_start("has the term t^(" + text_of_exponent(each.time) +
                             ") at its initial point, where only powers larger than -1 are supported for limits at "
                             "infinity: choose another initial point");
            }
        }
    }

    // log2 of the time at which the leading term has the size that it tends to, for the first value.
    double log2_of_scale() const {
        const precision_scope scope(digits_of_scale);
        expression_values<double> values(equation_.open.leaves, 0);
        for (const number& each : equation_.open.values) {
            values.push_back(constant_value<double>::of(each));
        }
        const double v = values.of(equation_.terms[equation_.leading].at(1, equation_.open.starts[0]));
        const auto weight = static_cast<double>(equation_.terms[equation_.leading].weight_of_time());
        const double found = std::log2(std::fabs(values.of(equation_.limit) / v)) / weight;
        return std::isfinite(found) ? std::clamp(found, -largest_log2_time, largest_log2_time) : 0;
    }

    // y' = d w^(d-1) u, u' = d sum c w^(d (p+1) - 1) y^q u^r for t = w^d.
    void make_first_part() {
        const rational root(equation_.root());
        const expression w = variable();
        const expression value = unknown("y at the start");
        const expression slope = unknown("u at the start");
        const auto in_parameters = [&](const expression& e) {
            return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
                const auto same = std::ranges::find_if(equation_.open.leaves,
                                                       [&](const expression& each) { return same_form(each, leaf); });
                return same == equation_.open.leaves.end()
                           ? std::nullopt
                           : std::optional(
                                 parameter(names_[static_cast<std::size_t>(same - equation_.open.leaves.begin())]));
            });
        };
        const auto power = [](const expression& base, const rational& exponent) {
            return exponent == 0 ? expression(1) : pow(base, expression(exponent));
        };
        expression sum(0);
        for (const power_term& each : equation_.terms) {
            sum = sum + in_parameters(each.factor) * power(w, rational(root * (each.time + 1) - 1)) *
                            power(value, each.value) * power(slope, each.slope);
        }
        equation_system system;
        system.variable = "w";
        system.add(derivative(value), expression(root) * power(w, rational(root - 1)) * slope);
        system.add(derivative(slope), expression(root) * sum);
        system.begin(value, in_parameters(equation_.open.starts[0]));
        system.begin(slope, in_parameters(equation_.open.starts[1]));
        for (std::size_t i = 0; i < names_.size(); ++i) {
            system.set(names_[i], expression(equation_.open.values[i]));
        }
        first_.emplace(opened(system, names_));
        leaves_ = {unknown("value"), unknown("slope")};
        leaves_.insert(leaves_.end(), equation_.open.leaves.begin(), equation_.open.leaves.end());
        after_ = logarithmic_state(equation_, time_, leaves_[0], leaves_[1]);
    }

    std::optional<differentiable_start> after_first_part(const std::vector<ball>& numbers, long bits,
                                                         long error_bits) const {
        const precision_scope scope(decimal_digits(bits));
        expression_values<ball> at_start(first_->leaves, ball(0));
        for (const ball& each : numbers) {
            at_start.push_back(each);
        }
        std::vector<ball> start;
        ball_matrix by_numbers;
        for (const expression& each : first_->starts) {
            start.push_back(at_start.of(each));
            auto& row = by_numbers.emplace_back();
            for (const expression& leaf : first_->leaves) {
                row.push_back(at_start.of(partial(each, leaf)));
            }
        }
        proved_march march(first_->system, start, bits, error_bits, watch_, route_);
        march.keep_derivative();
        const ball end = from_rational<ball>(root_of_time_);
        const auto state = march.at(end);
        if (!state) {
            return std::nullopt;
        }
        const ball_matrix flow = product(march.derivative_at(end), by_numbers);
        expression_values<ball> values(leaves_, ball(0));
        values.push_back((*state)[0]);
        values.push_back((*state)[1]);
        for (const ball& each : numbers) {
            values.push_back(each);
        }
        differentiable_start result;
        for (const expression& each : after_) {
            result.values.push_back(values.of(each));
            auto& row = result.by_numbers.emplace_back();
            const ball by_value = values.of(partial(each, leaves_[0]));
            const ball by_slope = values.of(partial(each, leaves_[1]));
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                row.push_back(values.of(partial(each, leaves_[i + 2])) + by_value * flow[0][i] + by_slope * flow[1][i]);
            }
        }
        return result;
    }

    connection found(connection_question in_log_time, const start_rule& begins) {
        in_log_time.digits = question_.digits;
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (std::ranges::find(question_.open, question_.unknowns[i]) != question_.open.end()) {
                in_log_time.open.push_back(names_[i]);
            }
        }
        connection result = searched_decay(in_log_time, begins, route_, watch_);
        const precision_scope scope(digits_of_scale);
        result.time = std::exp(result.time) * expression_values<double>({}, 0).of(time_);
        if (!first_) {
            result.time -= expression_values<double>({}, 0).of(time_);
        }
        const std::string decay = text_of_exponent(rational(-equation_.decay));
        const std::string& y = equation_.name;
        result.proved = "exactly one " + question_.unknowns.front() + " near this value for which t*" + primed(y, 1) +
                        "/" + y + " tends to " + decay + ", so that " + y + " decays like t^(" + decay + ")";
        if (equation_.is_monotone()) {
            result.proved += "; no other positive solution with these initial values has the limit 0";
            result.not_claimed = "that there is no other value of " + question_.unknowns.front() + " for which " + y +
                                 " tends to 0 and is not positive";
        } else {
            result.not_claimed = "that there is no other value of " + question_.unknowns.front() +
                                 ", or that solutions that tend to 0 in another way are excluded";
        }
        result.more.clear();
        return result;
    }

    const connection_question& question_;
    power_equation equation_;
    proof_route route_;
    march_watch watch_;
    std::vector<std::string> names_;
    expression time_;
    rational root_of_time_ = 0;
    std::optional<parametric_system> first_;  // up to time_, in the root of the time
    std::vector<expression> leaves_, after_;  // y, y' there and the numbers; z and v
};

}  // namespace

bool is_power_decay(const connection_question& question) { return power_equation_in(question).has_value(); }

connection proved_power_decay(const connection_question& question, const proof_route& route, const march_watch& watch) {
    auto equation = power_equation_in(question);
    if (!equation) {
        throw error(error_kind::argument, error_subject::conditions, "", "are not those of a decay like a power");
    }
    return power_search(question, *std::move(equation), route, watch).result();
}

}  // namespace libration::ode
