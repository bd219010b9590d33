#include "motion/trajectory_points.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libration/ode/numerical_solution.hpp"
#include "libration/pendulum/arc/periodic_extension.hpp"
#include "libration/pendulum/arc/uniform_resummation.hpp"
#include "libration/pendulum/proved/proved_motion.hpp"
#include "libration/pendulum/proved/proved_states.hpp"
#include "libration/pendulum/solution/critical_formula.hpp"
#include "libration/pendulum/solution/exact_solution.hpp"
#include "libration/pendulum/solution/separatrix_sum.hpp"
#include "run/digits.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace series;
using namespace elliptic;
using namespace pendulum;

namespace {

// What the latest of the times needs.
long digits_before_point(const trajectory_request& request) {
    long most = 0;
    for (const exact& time : request.times) {
        most = std::max(most, digits_before_point(request.chosen.of, time));
    }
    return most;
}

// theta and omega of either form of state.
template <class T>
jet<wide_t<T>> widened(const jet<T>& at) {
    return {widen(at.value), widen(at.slope)};
}
template <class T>
jet<wide_t<T>> widened(const pendulum_state<T>& at) {
    return {widen(at.theta), widen(at.omega)};
}

// theta and omega, in the motion's units, at every time, one after the other; omega is divided in more digits where
// they round.
template <class T, class Function>
std::vector<wide_t<T>> follow(const trajectory_request& request, const Function& function) {
    const long own_digits = working_digits();
    const wide_t<T> seconds = widen(time_unit<T>(request.chosen.of));
    const precision_scope more(rounding_scalar<T> ? decimal_digits(digits<T>()) + 25 : own_digits);
    std::vector<wide_t<T>> values;
    values.reserve(2 * request.times.size());
    for (const exact& time : request.times) {
        jet<wide_t<T>> at = [&] {
            const precision_scope scope(own_digits);
            return widened(function(time));
        }();
        values.push_back(std::move(at.value));
        values.push_back(at.slope / seconds);
    }
    return values;
}

template <class T, class Function>
std::vector<wide_t<T>> follow_extension(const trajectory_request& request, Function on_arc) {
    return follow<T>(request, periodic_extension<T, Function>(request.chosen.of, std::move(on_arc)));
}

std::vector<ball> followed_exactly(const trajectory_request& request) {
    const proved_motion solution(request.chosen.of);
    std::vector<ball> values;
    values.reserve(2 * request.times.size());
    for (const exact& time : request.times) {
        enclosed_state at = solution.at(time);
        values.push_back(std::move(at.theta));
        values.push_back(std::move(at.omega));
    }
    return values;
}

// A number as T; refuses what T rounds to 0 or infinity.
template <class T>
T held_by(const mpfr& value, const std::string& option, const std::string& text, const scalar_spec& scalar) {
    const long exponent = binary_exponent(value);
    if (exponent != exponent_of_zero && !holds_exponent<T>(exponent)) {
        throw input_error(option, text, "is outside the range of " + scalar.name(), "use --scalar mpfr:DIGITS");
    }
    return narrow<T>(value);
}

// The numerical solution, which names the time that takes too many steps.
template <class T>
std::vector<mpfr> follow_runge_kutta(const trajectory_request& request) {
    const motion& m = request.chosen.of;
    const scalar_spec& scalar = request.numbers.scalar;
    const pendulum_state<T> start = exact_solution<T>(m)(exact{});
    std::vector<mpfr> exact_times;
    mpfr exact_step;
    {
        const precision_scope more(decimal_digits(digits<T>()) + 20);
        exact_step = from_exact<mpfr>(request.step);
        for (const exact& time : request.times) {
            exact_times.push_back(dimensionless_time<mpfr>(m, time));
        }
    }
    const T step = held_by<T>(exact_step, "--step", request.step.text, scalar);
    std::vector<T> times;
    for (std::size_t i = 0; i < exact_times.size(); ++i) {
        times.push_back(held_by<T>(exact_times[i], "--times", request.times[i].text, scalar));
    }
    progress shown("rk4, times", times.size());
    const jet<T> at_zero{start.theta, start.omega};
    const auto states = numerical_solution(at_zero, times, step, [&](runge_kutta_march<T>& arc, std::size_t i) {
        jet<T> state = reading("--times", request.times[i].text, "choose nearer times or a larger --step",
                               [&] { return arc.advance_to(times[i]); });
        shown.step();
        return state;
    });
    std::size_t next = 0;
    return follow<T>(request, [&](const exact& /*time*/) { return states[next++]; });
}

template <class T>
std::vector<wide_t<T>> values_in(const trajectory_request& request) {
    const motion& m = request.chosen.of;
    switch (request.method) {
        case trajectory_method::series:
            return follow_extension<T>(request, series_from_top(arc_of<T>(m), request.order));
        case trajectory_method::resummed:
            return follow_extension<T>(request, resummation_from_top(arc_of<T>(m), request.order));
        case trajectory_method::uniform:
            // Balls of the sum itself, without the bound of what it leaves out.
            if constexpr (proved_scalar<T>) {
                return follow_extension<T>(request, uniform_from_top<T>(m, request.order).partial_sum());
            } else {
                return follow_extension<T>(request, uniform_from_top<T>(m, request.order));
            }
        default: break;
    }
    if constexpr (proved_scalar<T>) {
        if (request.method == trajectory_method::rk4) {
            throw std::logic_error("a march of steps has no proof");
        }
        return followed_exactly(request);
    } else if (request.method == trajectory_method::rk4) {
        return follow_runge_kutta<T>(request);
    } else {
        return follow<T>(request, exact_solution<T>(m));
    }
}

// theta by a route other than the Jacobi functions, in more digits.
mpfr second_route(const motion& m, const exact& time, const std::optional<separatrix_sum<mpfr>>& sum,
                  const exact_solution<mpfr>& solution) {
    if (sum) {
        return (*sum)(time).value;
    }
    return m.regime() == regime::separatrix ? critical_formula(m, from_exact<mpfr>(time) / time_unit<mpfr>(m))
                                            : solution(time).theta;
}

// What symmetry makes 0: omega at the turning points, by every method, because each is even about the top; theta at the
// bottom by the exact solution.
std::vector<bool> vanishing(const trajectory_request& request) {
    const proved_motion solution(request.chosen.of);
    const auto is_zero = [](const ball& x) { return is_exact(x) && contains_zero(x); };
    std::vector<bool> zeros;
    zeros.reserve(2 * request.times.size());
    for (const exact& time : request.times) {
        const enclosed_state at = solution.at(time);
        zeros.push_back(request.method == trajectory_method::exact && is_zero(at.theta));
        zeros.push_back(is_zero(at.omega));
    }
    return zeros;
}

// theta where it is known to be a fraction: that of the start, and of opposite sign half a period of libration later.
// Elsewhere it is no decimal, as far as anybody knows.
std::optional<rational> rational_theta(const motion& m, const exact& time) {
    const auto& start = m.theta0();
    if (!start || start->measure != unit::one) {
        return std::nullopt;
    }
    if (time.is_zero() || m.regime() == regime::stable_equilibrium) {
        return start->coefficient;
    }
    const rational halves = time.coefficient * 2;
    if (m.regime() != regime::libration || m.turns() != 0 || time.measure != unit::period || denominator(halves) != 1) {
        return std::nullopt;
    }
    return numerator(halves) % 2 == 0 ? start->coefficient : rational(-start->coefficient);
}

// The errors of rounded thetas: the truth by another route than theirs, in so many digits.
std::vector<std::string> rounded_errors(const trajectory_request& request, const std::vector<printed_number>& printed,
                                        long digits) {
    const motion& m = request.chosen.of;
    const precision_scope more(digits);
    const exact_solution<mpfr> truth(m);
    const bool judges_exact = request.method == trajectory_method::exact;
    std::optional<separatrix_sum<mpfr>> sum;
    if (judges_exact && !at_critical_energy(m.regime()) && m.regime() != regime::stable_equilibrium) {
        sum.emplace(m);
    }
    std::vector<std::string> errors;
    for (std::size_t i = 0; i < request.times.size(); ++i) {
        const exact& time = request.times[i];
        const mpfr theta = judges_exact ? second_route(m, time, sum, truth) : truth(time).theta;
        const precision_scope own(decimal_digits(mpfr_get_prec(handle(theta))));
        const mpfr difference = abs(from_exact<mpfr>(read_exact(printed[2 * i].text)) - theta);
        errors.push_back(to_decimal(difference, error_digits));
    }
    return errors;
}

// The errors of all proved thetas, in as many digits as it takes.
std::vector<std::string> proved_errors(const trajectory_request& request, const std::vector<printed_number>& printed,
                                       long before) {
    const motion& m = request.chosen.of;
    const auto errors = proved_decimals(error_digits, [&] {
        const precision_scope wider(working_digits() - error_digits + request.numbers.digits + before);
        const proved_motion solution(m);
        std::vector<ball> differences;
        for (std::size_t i = 0; i < request.times.size(); ++i) {
            const exact theta = read_exact(printed[2 * i].text);
            const bool is_exact = rational_theta(m, request.times[i]) == theta.coefficient;
            differences.push_back(is_exact ? ball(0)
                                           : abs(from_exact<ball>(theta) - solution.at(request.times[i]).theta));
        }
        return differences;
    });
    std::vector<std::string> texts;
    for (const printed_number& error : errors) {
        texts.push_back(error.text);
    }
    return texts;
}

}  // namespace

std::vector<trajectory_point> trajectory_points(const trajectory_request& request) {
    const auto& [scalar, digits] = request.numbers;
    const bool proved = scalar.kind == scalar_kind::proved;
    const long before = proved ? digits_before_point(request) : 0;
    long digits_of_truth = 0;
    const auto compute = [&]<class T>() {
        const precision_scope wider(working_digits() + before);
        if constexpr (rounding_scalar<T>) {
            digits_of_truth = decimal_digits(libration::digits<T>()) + 25;
        }
        return values_in<T>(request);
    };
    // A march of millions of steps is not repeated; its rounding is far below its error.
    const auto values = request.method == trajectory_method::rk4
                            ? printed(one_run(scalar, compute), digits)
                            : printed(scalar, digits, compute, [&] { return vanishing(request); });
    const auto errors =
        proved ? proved_errors(request, values, before) : rounded_errors(request, values, digits_of_truth);
    std::vector<trajectory_point> points;
    points.reserve(errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        points.push_back({values[2 * i].text, values[2 * i + 1].text, errors[i]});
    }
    return points;
}

}  // namespace libration
