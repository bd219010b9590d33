#include "radial_connection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "enclosed_decimal.hpp"
#include "first_guesses.hpp"
#include "followed_start.hpp"
#include "leaving_side.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "radial_equation.hpp"
#include "single_newton.hpp"

namespace libration::ode {

namespace {

constexpr long least_digits_of_search = 12;
constexpr long more_digits_of_scope = 30;
constexpr long bits_of_radial = 192;
constexpr double log_of_ten = 2.302585;
constexpr double size_of_start = 1. / 8;
constexpr double first_part_of_radial = 1. / 128;
constexpr double least_far_time = 3;
constexpr double more_far_time = 1.3;
constexpr int most_far_times = 8;
constexpr std::size_t terms_of_test = 6;
constexpr int most_radial_steps = 30;
constexpr long bits_beyond_regular_start = 20;
constexpr int log2_of_room = 20;
constexpr double trivial_within = 1e-6;
constexpr long digits_beyond_radial = 5;
constexpr int most_blocks = 8;
constexpr int log2_of_next_block = 6;
constexpr double far_time_step = 3;
constexpr std::array large_first_guesses{15., 22., 32., 50., 80., 120.};  // of centres; as with high powers

class radial_search {
public:
    radial_search(const connection_question& question, radial_equation equation, const proof_route& route,
                  march_watch watch)
        : question_(question),
          equation_(std::move(equation)),
          route_(route),
          watch_(std::move(watch)),
          far_question_(far_question(equation_, question)),
          far_(far_question_.system, far_question_.unknowns, far_question_.limits, route_, watch_) {
        if (equation_.starts_at_zero) {
            const auto regular = regular_question(equation_, question);
            near_.emplace(regular.system, regular.unknowns, regular.limits, route_, watch_);
            far_.begins = [this](const std::vector<ball>& numbers, long bits,
                                 long /*error_bits*/) -> std::optional<differentiable_start> {
                return searches_ ? rough_start(equation_, numbers.front()) : beyond_start(numbers, bits);
            };
        }
    }

    connection result() {
        const precision_scope scope(decimal_digits(bits_of_radial));
        const auto formal = formal_saddle_graph(equation_.at_infinity(), terms_of_test);
        if (!formal) {
            throw error(error_kind::argument, error_subject::conditions, "",
                        "has a limit that is not that of a saddle as 1/t -> 0: choose another limit");
        }
        for (std::size_t i = 1; i < formal->far.rows(); ++i) {
            is_forced_ = is_forced_ || arb_is_zero(formal->far.at(i, 0).handle()) == 0;
        }
        rate_ = std::min(as_double(formal->unstable), -as_double(formal->stable));
        for (const double guess : guesses()) {
            if (const auto x = candidate(guess)) {
                return proved(*x);
            }
        }
        throw error(error_kind::undecided, error_subject::first_guess, "",
                    "is not found: Newton's method does not lead to a solution with this limit: try a better initial "
                    "guess");
    }

private:
    // The state (u, u', 1/t) shortly after t = 0.
    std::optional<differentiable_start> beyond_start(const std::vector<ball>& numbers, long bits) const {
        const precision_scope scope(decimal_digits(bits));
        const manifold_end& end = near_->right();
        const int degree =
            static_cast<int>((bits + bits_beyond_regular_start) / -std::lround(std::log2(size_of_start))) + 1;
        const auto at = end.at(numbers, {exactly(side_ * size_of_start)}, degree, true);
        if (!at) {
            return std::nullopt;
        }
        const ball& g = at->value[0];
        const ball& h = at->value[1];
        const ball w = ball(1) / at->value[2];
        const auto slope = [&](std::size_t i) { return at->by_numbers[i].front(); };
        const ball w_x = -w * w * slope(2);
        if (equation_.power == 0) {
            return differentiable_start{{g, h * w, w}, {{slope(0)}, {slope(1) * w + h * w_x}, {w_x}}};
        }
        const ball t = at->value[2];
        return differentiable_start{{t * g, g + h, w}, {{t * slope(0) + slope(2) * g}, {slope(0) + slope(1)}, {w_x}}};
    }

    // The coordinates of the manifold that leaves t = 0.
    bool choose_start(double x) {
        if (!near_) {
            return true;
        }
        if (!near_->choose({x}, 1) || near_->right().variables() != 1) {
            return false;
        }
        const precision_scope scope(decimal_digits(bits_of_radial));
        side_ = 1;
        const auto at = near_->right().at({exactly(x)}, {exactly(size_of_start)}, 12, false);
        side_ = at && arb_is_negative(at->value[2].handle()) != 0 ? -1 : 1;
        return at.has_value();
    }

    std::vector<double> guesses() {
        const double given = nearest_doubles(far_.open().values).front();
        auto around = question_.open.empty() ? guesses_around(given, first_part_of_radial, 1) : signed_first_guesses();
        if (!question_.open.empty()) {
            around.insert(around.end(), large_first_guesses.begin(), large_first_guesses.end());
        }
        const double limit = as_double(equation_.at_infinity().limit);
        std::vector<double> found;
        if (choose_start(given)) {
            searches_ = true;
            found = changes_of_side(far_, around, 1);
            searches_ = false;
            std::erase_if(found, [&](double x) {
                return std::fabs(x) < trivial_within || std::fabs(x - limit) < trivial_within;
            });
        }
        std::ranges::stable_sort(found, {}, [&](double x) { return std::fabs(x - given); });
        if (question_.open.empty()) {
            found.push_back(given);
        }
        return found;
    }

    std::optional<differentiable_start> at_far_time(const ball& x, long bits, long error_bits) const {
        const auto from = far_.begins ? far_.begins({x}, bits, error_bits) : typed_start(far_.open(), {x});
        return from ? followed_start(far_.open(), *from, time_, bits, error_bits, watch_, route_) : std::nullopt;
    }

    // The slope of the distance from the graph along the solution.
    ball slope_at(const differentiable_start& here) const {
        std::vector<ball> by_x;
        for (const auto& row : here.by_numbers) {
            by_x.push_back(row.front());
        }
        return graph_->slope_along(here.values[0], here.values[1], here.values[2], by_x);
    }

    // F = rho - Phi(w, s) at the far time, with the slopes of Phi; without a block those of the formal graph.
    std::optional<enclosed_map> at(const ball& x, long bits, long error_bits) const {
        const precision_scope scope(decimal_digits(bits));
        const auto here = at_far_time(x, bits, error_bits);
        if (!here) {
            return std::nullopt;
        }
        const ball& w = here->values[2];
        const auto place = graph_->place_of(here->values[0], here->values[1], w);
        const bool is_inside =
            arb_is_positive(w.handle()) != 0 && magnitude(w) <= graph_->w && magnitude(place.s) <= graph_->s;
        if (is_proved_ && !is_inside) {
            return std::nullopt;
        }
        enclosed_map result;
        result.value = {widened(place.rho, graph_->eps)};
        result.derivative = {{slope_at(*here)}};
        return result;
    }

    // Whether the error of the graph is small enough for the digits.
    bool has_digits(const ball& x, const differentiable_start& here) const {
        const ball digits = pow(ball(10), -question_.digits - digits_beyond_radial);
        return certainly_less(graph_->eps.exact(), abs(slope_at(here)) * abs(x) * digits);
    }

    // Between integrations, which call it too.
    void seen(long bits) const {
        if (watch_) {
            watch_(exactly(time_), bits);
        }
    }

    // The block about the solution at the far time: one for all numbers x.
    bool prove_graph(const ball& x, long bits) {
        const precision_scope scope(decimal_digits(bits));
        const auto here = at_far_time(x, bits, run_bits::usual_error_bits);
        if (!here) {
            return false;
        }
        const magnitude w(here->values[2]);
        const magnitude s(graph_->place_of(here->values[0], here->values[1], here->values[2]).s);
        for (int k = 0; k < most_blocks; ++k) {
            seen(bits);
            const auto found = proved_saddle_graph(equation_.at_infinity(), *graph_, w + w.shifted(-log2_of_room),
                                                   s.shifted(1 + k * log2_of_next_block));
            if (found) {
                graph_ = found;
                is_proved_ = true;
                return has_digits(x, *here);
            }
        }
        return false;
    }

    void choose_time(double time, long bits) {
        const precision_scope scope(decimal_digits(bits));
        seen(bits);
        time_ = std::ceil(time * 8) / 8;
        is_proved_ = false;
        graph_ = formal_saddle_graph(equation_.at_infinity(),
                                     static_cast<std::size_t>(std::ceil((is_forced_ ? 1 : 2) * rate_ * time_)) + 2);
    }

    // Newton's method at times that grow.
    std::optional<ball> candidate(double guess) {
        const precision_scope scope(decimal_digits(bits_of_radial));
        if (!choose_start(guess)) {
            return std::nullopt;
        }
        ball x = exactly(guess);
        bool found = false;
        for (const double time : {2., 3., 4.5, 6., 9.}) {
            choose_time(time / rate_, bits_of_radial);
            ball next = x;
            found = improve(next, bits_of_radial) || found;
            x = found ? next : x;
        }
        return found ? std::optional(x) : std::nullopt;
    }

    bool improve(ball& x, long bits) const {
        return improved_by_newton(x, most_radial_steps, 1, long_step::refused,
                                  [&](const ball& at_x) { return at(at_x, bits, run_bits::usual_error_bits); });
    }

    connection proved(ball x) {
        const auto digits = static_cast<double>(question_.digits + digits_beyond_radial);
        const long bits = bits_of_radial + 4 * question_.digits;
        const precision_scope scope(decimal_digits(bits));
        double time = std::max(least_far_time, log_of_ten * digits / (is_forced_ ? 2 : 4)) / rate_;
        for (int k = 0; k < most_far_times; ++k, time *= more_far_time) {
            for (double next = time_; next < time; next = std::min(time, next + far_time_step / rate_)) {
                choose_time(next, bits);
                if (!improve(x, bits)) {
                    break;
                }
            }
            choose_time(time, bits);
            if (!choose_start(as_double(x)) || !improve(x, bits) || !prove_graph(x, bits)) {
                continue;
            }
            try {
                return described(proved_root([&](const std::vector<ball>& box, long more_bits,
                                                 long error_bits) { return at(box.front(), more_bits, error_bits); },
                                             {x}, question_.digits, question_.unknowns));
            } catch (const error& problem) {
                if (problem.kind() != error_kind::undecided) {
                    throw;
                }
            }
        }
        throw error(error_kind::undecided, error_subject::solution, "",
                    "is not proved to tend to the limit at any time up to t = " + to_decimal(mpfr(time_), 6));
    }

    connection described(std::vector<proved_decimal> values) const {
        if (equation_.power == 0 && contains_zero(enclosed(values.front()) - equation_.at_infinity().limit)) {
            throw error(error_kind::undecided, error_subject::first_guess, "",
                        "leads to the constant solution: try another one");
        }
        connection result;
        result.values = std::move(values);
        const std::string& name = question_.unknowns.front();
        result.proved = "exactly one " + name + " near this value for which, from t = " + to_decimal(mpfr(time_), 6) +
                        " on, the solution stays near the graph of solutions that tend to the limit, and tends to it";
        result.not_claimed = "that there is no other value of " + name;
        result.time = time_;
        return result;
    }

    const connection_question& question_;
    radial_equation equation_;
    proof_route route_;
    march_watch watch_;
    connection_question far_question_;
    connection_map far_;
    std::optional<connection_map> near_;
    double side_ = 1, rate_ = 1, time_ = 0;
    std::optional<saddle_graph> graph_;
    bool searches_ = false;   // for a first guess, without proof
    bool is_forced_ = false;  // the far field is not constant
    bool is_proved_ = false;  // the graph has a block and errors
};

}  // namespace

bool is_radial(const connection_question& question) { return radial_equation_in(question).has_value(); }

connection proved_radial(const connection_question& question, const proof_route& route, const march_watch& watch) {
    auto equation = radial_equation_in(question);
    if (!equation) {
        throw error(error_kind::argument, error_subject::conditions, "", "are not those of an equation with 1/t");
    }
    // Few digits leave the far time too early for the graph.
    connection_question finer = question;
    finer.digits = std::max(question.digits, least_digits_of_search);
    connection result = radial_search(finer, *std::move(equation), route, watch).result();
    const precision_scope scope(finer.digits + more_digits_of_scope);
    for (proved_decimal& each : result.values) {
        if (const auto shorter = to_proved_decimal(enclosed(each), question.digits)) {
            each = *shorter;
        }
    }
    return result;
}

}  // namespace libration::ode
