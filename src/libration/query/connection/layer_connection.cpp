#include "layer_connection.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "first_guesses.hpp"
#include "followed_start.hpp"
#include "layer_text.hpp"
#include "libration/algebra/krawczyk.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "single_newton.hpp"

namespace libration::ode {

namespace {

constexpr double digits_per_exponent = 2.302585;
constexpr double digits_beyond_layer = 5;
constexpr long bits_of_layer = 192;
constexpr int most_layer_steps = 25;
constexpr double latest_time = 1000;
constexpr double time_step = 0.25;
constexpr double side_step = 0.05;
constexpr double upper_side = 1.5;
constexpr double lower_side = 0.3;
constexpr double least_digits_of_layer = 9;
constexpr double more_digits_of_layer = 15;
constexpr int most_layers = 5;
constexpr int log2_of_least_contraction = 2;
constexpr long least_digits_of_time = 18;
constexpr double most_growth = 100;
constexpr double large_argument = 12;
constexpr int most_side_bisections = 52;
constexpr double first_width = 0.02;
constexpr double last_width = 2;

class layer_search {
public:
    layer_search(const connection_question& question, layer_text text, const proof_route& route, march_watch watch)
        : question_(question), text_(std::move(text)), route_(route), watch_(std::move(watch)) {}

    connection result() {
        const precision_scope scope(decimal_digits(bits_of_layer));
        const layer_equation equation = equation_here();
        require_exponential(equation);
        for (const double guess : improved_guesses()) {
            if (const auto x = candidate(guess)) {
                return proved(*x);
            }
        }
        throw error(error_kind::undecided, error_subject::first_guess, "",
                    "is not found: Newton's method does not lead to a solution with this limit: try a better initial "
                    "guess");
    }

private:
    layer_equation equation_here() const {
        layer_equation result{number_in(text_.a), number_in(text_.limit), {}};
        for (const expression& each : text_.k) {
            result.k.push_back(number_in(each));
        }
        return result;
    }

    void require_exponential(const layer_equation& equation) const {
        const limit_condition& asked = question_.limits.front();
        if (asked.exponentially || equation.k.empty() || arb_is_positive(equation.k.front().handle()) != 0) {
            return;
        }
        throw error(error_kind::argument, error_subject::condition, asked.text,
                    "does not determine a solution: solutions near one that satisfies it tend to the limit too, like a "
                    "power of the time: write \"" +
                        asked.text + " exponentially\"");
    }

    std::vector<double> guesses() const {
        if (question_.open.empty()) {
            return nearest_doubles(text_.open.values);
        }
        return signed_first_guesses();
    }

    double limit() const { return as_double(equation_here().limit); }
    double a_over_limit() const {
        const layer_equation equation = equation_here();
        return as_double(equation.a) / as_double(equation.limit);
    }

    // The time at which f is so large that the graph has so many digits. False if f does not become so large.
    bool choose_time(double x, double digits) {
        far_ = std::sqrt(digits_per_exponent * (digits + digits_beyond_layer) / a_over_limit());
        terms_ = static_cast<std::size_t>(std::ceil(a_over_limit() * far_ * far_ / 2)) + 2;
        time_ = 0;
        follow(x, time_step, [&](double time, double f, double slope) {
            if (std::fabs(slope) > most_growth * limit()) {
                return false;
            }
            time_ = f >= far_ ? time : 0;
            return f < far_;
        });
        return time_ > 0;
    }

    // Calls seen(t, f, f') along the solution in double until it returns false, or the solution ends.
    template <class Seen>
    void follow(double x, double step, const Seen& seen) const {
        try {
            taylor_march<double> march(text_.open.system);
            const double point = constant_value<double>::of(text_.open.system.point());
            expression_values<double> values(text_.open.leaves, 0);
            values.push_back(x);
            solution_state<double> start;
            std::size_t next = 0;
            for (const unknown_function& each : text_.open.system.unknowns()) {
                auto& of = start.emplace_back();
                for (int order = 0; order < each.order; ++order) {
                    of.push_back(values.of(text_.open.starts[next++]));
                }
            }
            march.begin_at(point, start);
            for (double time = 0; time < latest_time; time += step) {
                const auto& state = march.advance_to(point + time);
                const double f = value_of(state, 0);
                const double slope = value_of(state, 1);
                if (!std::isfinite(f) || !std::isfinite(slope) || !seen(time, f, slope)) {
                    return;
                }
            }
        } catch (const error&) {
            // the solution ends before
        }
    }

    // On which side of the limit f' ends.
    int side_of(double x) const {
        int side = 0;
        std::optional<double> lowest;
        const double large = large_argument / std::sqrt(a_over_limit());
        follow(x, side_step, [&](double /*time*/, double f, double slope) {
            side = slope > limit() ? 1 : -1;
            lowest = lowest ? *lowest : std::min(slope, 0.) - lower_side * limit();
            return slope < upper_side * limit() && slope > *lowest && f < large;
        });
        return side;
    }

    // The value between two at which the side changes.
    double between(double a, double b) const {
        const int side = side_of(a);
        for (int k = 0; k < most_side_bisections; ++k) {
            const double middle = (a + b) / 2;
            (side_of(middle) == side ? a : b) = middle;
        }
        return (a + b) / 2;
    }

    // First guesses at changes of the side around those that are given, then these themselves.
    std::vector<double> improved_guesses() const {
        const auto given = guesses();
        auto around = given.size() == 1 ? guesses_around(given.front(), first_width, last_width) : given;
        std::ranges::sort(around);
        std::vector<double> result;
        for (std::size_t i = 0; i + 1 < around.size(); ++i) {
            if (side_of(around[i]) != side_of(around[i + 1])) {
                result.push_back(between(around[i], around[i + 1]));
            }
        }
        std::ranges::stable_sort(result, {}, [&](double x) { return std::fabs(x - given.front()); });
        result.insert(result.end(), given.begin(), given.end());
        return result;
    }

    double value_of(const solution_state<double>& state, std::size_t order) const {
        std::size_t place = text_.places[order];
        for (const auto& each : state) {
            if (place < each.size()) {
                return each[place];
            }
            place -= each.size();
        }
        return NAN;
    }

    // Newton's method at times that grow with the digits.
    std::optional<double> candidate(double guess) {
        const precision_scope scope(decimal_digits(bits_of_layer));
        ball x = exactly(guess);
        bool found = false;  // at the last times, or before they are too far for double
        for (const double digits : {1., 4., 10., 14., 25., 40.}) {
            ball next = x;
            if (choose_time(as_double(x), digits) && improve(next)) {
                x = next;
                found = digits > least_digits_of_layer;
            }
        }
        return found ? std::optional(as_double(x)) : std::nullopt;
    }

    bool improve(ball& x) const {
        return improved_by_newton(x, most_layer_steps, 0.5, long_step::shortened, [&](const ball& at_x) {
            return at({at_x}, bits_of_layer, run_bits::usual_error_bits, false);
        });
    }

    // F = f'' - f u Phi(1/f^2, u), with the slopes of Phi.
    std::optional<enclosed_map> at(const std::vector<ball>& x, long bits, long error_bits, bool proving) const {
        const precision_scope scope(decimal_digits(bits));
        const auto here =
            followed_start(text_.open, typed_start(text_.open, x), time_, bits, error_bits, watch_, route_);
        return here ? on_graph(here->values, here->by_numbers, proving) : std::nullopt;
    }

    std::optional<enclosed_map> on_graph(const std::vector<ball>& state, const ball_matrix& slopes,
                                         bool proving) const {
        const layer_equation equation = equation_here();
        const ball& f = state[text_.places[0]];
        const ball u = state[text_.places[1]] - equation.limit;
        if (arb_is_positive(f.handle()) == 0) {
            return std::nullopt;
        }
        const ball sigma = ball(1) / (f * f);
        const auto graph = proved_layer_graph(equation, terms_, magnitude(sigma), magnitude(u).shifted(1));
        if (!graph && proving) {
            return std::nullopt;
        }
        const auto used = graph ? graph : formal(equation, sigma, u);
        if (!used) {
            return std::nullopt;
        }
        const ball& f_x = slopes[text_.places[0]].front();
        const ball& u_x = slopes[text_.places[1]].front();
        const ball phi = widened(used->phi.value(sigma, u), used->eps);
        const ball sigma_x = sigma * f_x * -2 / f;
        const ball along = used->by_sigma.value(sigma, u) * sigma_x + used->by_u.value(sigma, u) * u_x;
        const magnitude beside = used->slope * (magnitude(sigma_x) / used->sigma + magnitude(u_x) / used->u);
        enclosed_map result;
        result.value = {state[text_.places[2]] - f * u * phi};
        result.derivative = {
            {slopes[text_.places[2]].front() - (f_x * u + f * u_x) * phi - f * u * widened(along, beside)}};
        return result;
    }

    // Without errors, for Newton's method far from the solution.
    std::optional<layer_graph> formal(const layer_equation& equation, const ball& sigma, const ball& /*u*/) const {
        auto graph = proved_layer_graph(equation, terms_, magnitude(sigma), magnitude::of(1, -60));
        if (graph) {
            graph->eps = magnitude();
            graph->slope = magnitude();
        }
        return graph;
    }

    connection proved(double x) {
        // The farther, the better the graph: until the theorems hold, and such that it has the digits.
        for (int k = 0; k < most_layers; ++k) {
            if (!choose_time(x, static_cast<double>(std::max(question_.digits, least_digits_of_time)) +
                                    k * more_digits_of_layer)) {
                throw error(error_kind::undecided, error_subject::solution, "", "is not followed far enough");
            }
            const precision_scope scope(decimal_digits(bits_of_layer));
            ball nearer = exactly(x);                    // at far times u is not known from x in double
            if (!improve(nearer) || !improve(nearer)) {  // again, for twice the digits
                continue;
            }
            const auto here = at({nearer}, bits_of_layer, run_bits::usual_error_bits, true);
            if (here && contracts(*here) && is_followed(nearer, *here)) {
                return described(nearer);
            }
        }
        throw error(error_kind::undecided, error_subject::solution, "",
                    "is not proved to tend to the limit at any time up to t = " + to_decimal(mpfr(time_), 6));
    }

    // Whether the slope of F is known so well that Krawczyk's test can hold.
    static bool contracts(const enclosed_map& here) {
        const ball& slope = here.derivative.front().front();
        return magnitude::radius_of(slope).shifted(log2_of_least_contraction) < magnitude::below(slope);
    }

    // Whether a box that contains the zeros reaches the far time, which no precision decides.
    bool is_followed(const ball& x, const enclosed_map& here) const {
        const magnitude reach = magnitude(here.value.front()) / magnitude::below(here.derivative.front().front());
        const auto box = at({widened(x, reach.shifted(1))}, bits_of_layer + 4 * question_.digits,
                            2 * run_bits::usual_error_bits, true);
        return box && contracts(*box);
    }

    connection described(const ball& x) const {
        connection result;
        result.values = proved_root(
            [&](const std::vector<ball>& box, long bits, long error_bits) { return at(box, bits, error_bits, true); },
            {x}, question_.digits, question_.unknowns);
        const std::string& name = question_.unknowns.front();
        const bool said = question_.limits.front().exponentially;
        result.proved = "one " + name + " within these digits for which " + question_.limits.front().text +
                        (said ? "" : ", exponentially") +
                        ", and no other one near it for which the solution decays at that rate from t = " +
                        to_decimal(mpfr(time_), 6) + " on";
        result.not_claimed = "that there is no other value of " + name;
        result.time = time_;
        return result;
    }

    const connection_question& question_;
    layer_text text_;
    proof_route route_;
    march_watch watch_;
    double far_ = 0, time_ = 0;
    std::size_t terms_ = 0;
};

}  // namespace

bool is_layer(const connection_question& question) { return layer_in(question).has_value(); }

connection proved_layer(const connection_question& question, const proof_route& route, const march_watch& watch) {
    auto text = layer_in(question);
    if (!text) {
        throw error(error_kind::argument, error_subject::conditions, "", "are not those of a boundary layer");
    }
    if (question.unknowns.size() != 1) {
        throw error(error_kind::argument, error_subject::unknowns, std::to_string(question.unknowns.size()),
                    "is not the number that this limit determines, 1: give one --unknown");
    }
    return layer_search(question, *std::move(text), route, watch).result();
}

}  // namespace libration::ode
