#include "motion/rounded_trajectory.hpp"

#include <optional>
#include <string>
#include <utility>

#include "libration/ode/numerical_solution.hpp"
#include "libration/pendulum/arc/periodic_extension.hpp"
#include "libration/pendulum/arc/uniform_resummation.hpp"
#include "libration/pendulum/solution/critical_formula.hpp"
#include "libration/pendulum/solution/exact_solution.hpp"
#include "libration/pendulum/solution/separatrix_sum.hpp"
#include "run/agreement.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

// theta by a route other than the Jacobi functions, in more digits.
mpfr second_route(const motion& m, const exact& time, const std::optional<separatrix_sum<mpfr>>& sum,
                  const exact_solution<mpfr>& solution) {
    if (sum) {
        return (*sum)(time).value;
    }
    return m.regime() == regime::separatrix ? critical_formula(m, from_exact<mpfr>(time) / time_unit<mpfr>(m))
                                            : solution(time).theta;
}

// The values of any route that gives a jet at a time, against the truth in `digits` digits.
template <class T, class Route>
trajectory_values follow(const trajectory_request& request, const Route& route) {
    const motion& m = request.chosen.of;
    const mpfr seconds = widen(time_unit<T>(m));
    const precision_scope more(decimal_digits(digits<T>()) + 25);
    const exact_solution<mpfr> truth(m);
    std::optional<separatrix_sum<mpfr>> sum;
    const bool judged_by_sum = request.method == trajectory_method::exact && !at_critical_energy(m.regime()) &&
                               m.regime() != regime::stable_equilibrium;
    if (judged_by_sum) {
        sum.emplace(m);
    }
    trajectory_values result;
    for (const exact& time : request.times) {
        const jet<mpfr> at = route(time);
        result.motion.push_back(at.value);
        result.motion.push_back(at.slope / seconds);
        result.truth.push_back(request.method == trajectory_method::exact ? second_route(m, time, sum, truth)
                                                                          : truth(time).theta);
    }
    return result;
}

// theta and omega of either form of state.
template <class T>
jet<mpfr> widened(const jet<T>& at) {
    return {widen(at.value), widen(at.slope)};
}
template <class T>
jet<mpfr> widened(const pendulum_state<T>& at) {
    return {widen(at.theta), widen(at.omega)};
}

// A function of exact times, evaluated in the precision that is in force now.
template <class T, class Function>
trajectory_values follow_function(const trajectory_request& request, const Function& function) {
    const long own_digits = working_digits();
    return follow<T>(request, [&](const exact& time) {
        const precision_scope scope(own_digits);
        return widened(function(time));
    });
}

template <class T, class Function>
trajectory_values follow_extension(const trajectory_request& request, Function on_descent) {
    return follow_function<T>(request, periodic_extension<T, Function>(request.chosen.of, std::move(on_descent)));
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
trajectory_values follow_runge_kutta(const trajectory_request& request) {
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
    const auto states = numerical_solution(at_zero, times, step, [&](runge_kutta_march<T>& way, std::size_t i) {
        jet<T> state = reading("--times", request.times[i].text, "choose nearer times or a larger --step",
                               [&] { return way.advance_to(times[i]); });
        shown.step();
        return state;
    });
    std::size_t next = 0;
    return follow<T>(request, [&](const exact& /*time*/) { return widened(states[next++]); });
}

template <class T>
trajectory_values follow_in(const trajectory_request& request) {
    const motion& m = request.chosen.of;
    switch (request.method) {
        case trajectory_method::series:
            return follow_extension<T>(request, series_from_top(descent_of<T>(m), request.order));
        case trajectory_method::resummed:
            return follow_extension<T>(request, resummation_from_top(descent_of<T>(m), request.order));
        case trajectory_method::uniform: return follow_extension<T>(request, uniform_from_top<T>(m, request.order));
        case trajectory_method::rk4: return follow_runge_kutta<T>(request);
        default: return follow_function<T>(request, exact_solution<T>(m));
    }
}

}  // namespace

trajectory_values rounded_trajectory(const trajectory_request& request) {
    const scalar_spec& scalar = request.numbers.scalar;
    const auto compute = [&](long guard) {
        return with_scalar(scalar, guard, [&]<class T>() { return follow_in<T>(request); });
    };
    // A march of millions of steps is not repeated; its rounding is far below its error.
    if (scalar.kind != scalar_kind::arbitrary || request.method == trajectory_method::rk4) {
        return compute(20);
    }
    trajectory_values result;
    result.motion = agreed_values(scalar.digits, [&](long guard) {
        result = compute(guard);
        return result.motion;
    });
    return result;
}

}  // namespace libration
