#include "trajectory_points.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libration/digits/printed_values.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/numerical_solution.hpp"
#include "libration/pendulum/periodic_extension.hpp"
#include "libration/pendulum/proved_motion.hpp"
#include "libration/pendulum/proved_states.hpp"
#include "libration/pendulum/uniform_resummation.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "run/parallel.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace series;
using namespace elliptic;
using namespace pendulum;

namespace {

// The digits that the latest of the times requires.
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

// Calls work(i) for every time, on all threads, in blocks, so that threads are not scheduled for single times.
template <class Work>
void at_every_time(const trajectory_request& request, const std::string& what, const Work& work) {
    constexpr std::size_t block = 64;
    const std::size_t count = request.times.size();
    const std::size_t blocks = (count + block - 1) / block;
    progress shown("trajectory, " + what + ", blocks of times", blocks);
    on_threads(blocks, blocks > 1 ? request.jobs : 1, [&](std::size_t number) {
        for (std::size_t i = number * block; i < std::min(count, (number + 1) * block); ++i) {
            work(i);
        }
        shown.step();
    });
}

// theta and omega, in the motion's units, at every time, one after the other, from function(i) at the i-th; omega is
// divided with more digits if they round.
template <class T, class Function>
std::vector<wide_t<T>> follow(const trajectory_request& request, const Function& function) {
    const long own_digits = working_digits();
    const long more_digits = rounding_scalar<T> ? decimal_digits(digits<T>()) + 25 : own_digits;
    const wide_t<T> seconds = widen(time_unit<T>(request.chosen.of));
    std::vector<wide_t<T>> values(2 * request.times.size());
    at_every_time(request, "values", [&](std::size_t i) {
        const precision_scope more(more_digits);
        jet<wide_t<T>> at = [&] {
            const precision_scope scope(own_digits);
            return widened(function(i));
        }();
        values[2 * i] = std::move(at.value);
        values[2 * i + 1] = at.slope / seconds;
    });
    return values;
}

template <class T, class Function>
std::vector<wide_t<T>> follow_extension(const trajectory_request& request, Function on_arc) {
    const periodic_extension<T, Function> function(request.chosen.of, std::move(on_arc));
    return follow<T>(request, [&](std::size_t i) { return function(request.times[i]); });
}

// The exact solution in balls.
std::vector<ball> enclosed(const trajectory_request& request, const std::string& what = "values") {
    const long own_digits = working_digits();
    const proved_motion solution(request.chosen.of);
    std::vector<ball> values(2 * request.times.size());
    at_every_time(request, what, [&](std::size_t i) {
        const precision_scope scope(own_digits);
        enclosed_state at = solution.at(request.times[i]);
        values[2 * i] = std::move(at.theta);
        values[2 * i + 1] = std::move(at.omega);
    });
    return values;
}

// A number as T; throws if its conversion to T is 0 or infinite.
template <class T>
T held_by(const mpfr& value, const std::string& option, const std::string& text, const scalar_spec& scalar) {
    const long exponent = binary_exponent(value);
    if (exponent != exponent_of_zero && !holds_exponent<T>(exponent)) {
        throw input_error(option, text, "is outside the range of " + scalar.name(), "use --scalar mpfr:DIGITS");
    }
    return narrow<T>(value);
}

// The numerical solution; its error names the time that would take too many steps.
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
        jet<T> state = reading("--times", request.times[i].text, "choose times closer to 0 or a larger --step",
                               [&] { return arc.advance_to(times[i]); });
        shown.step();
        return state;
    });
    return follow<T>(request, [&](std::size_t i) { return states[i]; });
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
            // Balls of the sum itself, without a bound of its remainder.
            if constexpr (proved_scalar<T>) {
                return follow_extension<T>(request, uniform_from_top<T>(m, request.order).partial_sum());
            } else {
                return follow_extension<T>(request, uniform_from_top<T>(m, request.order));
            }
        default: break;
    }
    if constexpr (proved_scalar<T>) {
        if (request.method == trajectory_method::rk4) {
            throw std::logic_error("a step-by-step integration has no proof");
        }
        return enclosed(request);
    } else if (request.method == trajectory_method::rk4) {
        return follow_runge_kutta<T>(request);
    } else {
        const exact_solution<T> solution(m);
        return follow<T>(request, [&](std::size_t i) { return solution(request.times[i]); });
    }
}

// Values that are 0 by symmetry: omega at the turning points, by every method, because each is even about the top;
// theta at the bottom by the exact solution and by the resummation, which has its value there.
std::vector<bool> vanishing(const trajectory_request& request) {
    const auto is_zero = [](const ball& x) { return is_exact(x) && contains_zero(x); };
    const auto values = enclosed(request);
    const bool exact_bottom =
        request.method == trajectory_method::exact || request.method == trajectory_method::resummed;
    std::vector<bool> zeros;
    zeros.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool is_theta = i % 2 == 0;
        zeros.push_back((!is_theta || exact_bottom) && is_zero(values[i]));
    }
    return zeros;
}

// theta where it is known to be a fraction: the initial angle, again after whole periods of libration, and with
// opposite sign about the bottom theta = 0 half a period later. Elsewhere no decimal value of it is known.
std::optional<rational> rational_theta(const motion& m, const exact& time) {
    const auto& start = m.theta0();
    if (!start || start->measure != unit::one) {
        return std::nullopt;
    }
    if (time.is_zero() || m.regime() == regime::stable_equilibrium) {
        return start->coefficient;
    }
    const rational halves = time.coefficient * 2;
    if (m.regime() != regime::libration || !time.only_periods() || denominator(halves) != 1) {
        return std::nullopt;
    }
    const bool whole = numerator(halves) % 2 == 0;
    if (!whole && m.turns() != 0) {
        return std::nullopt;
    }
    return whole ? start->coefficient : rational(-start->coefficient);
}

// |theta as printed - the exact solution| at every time, six proved digits of it, with as many working digits as
// needed.
std::vector<printed_number> errors_of(const trajectory_request& request, const std::vector<printed_number>& printed,
                                      long before) {
    std::vector<exact> thetas;
    thetas.reserve(request.times.size());
    for (std::size_t i = 0; i < request.times.size(); ++i) {
        thetas.push_back(read_exact(printed[2 * i].text));
    }
    return proved_decimals(error_digits, [&] {
        const precision_scope wider(working_digits() - error_digits + request.numbers.digits + before);
        const auto truth = enclosed(request, "errors");
        std::vector<ball> differences;
        differences.reserve(thetas.size());
        for (std::size_t i = 0; i < thetas.size(); ++i) {
            const bool is_exact = rational_theta(request.chosen.of, request.times[i]) == thetas[i].coefficient;
            differences.push_back(is_exact ? ball(0) : abs(from_exact<ball>(thetas[i]) - truth[2 * i]));
        }
        return differences;
    });
}

// theta and omega at every time as they are printed.
std::vector<printed_number> values_of(const trajectory_request& request, long before) {
    const auto& [scalar, digits] = request.numbers;
    const auto compute = [&]<class T>() {
        const precision_scope wider(working_digits() + (proved_scalar<T> ? before : 0));
        return values_in<T>(request);
    };
    // An integration of millions of steps is not repeated; its rounding is far below its error.
    if (request.method == trajectory_method::rk4) {
        return printed(one_run(scalar, compute), digits);
    }
    const auto zeros = [&] { return vanishing(request); };
    if (scalar.kind != scalar_kind::arbitrary) {
        return printed(scalar, digits, compute, zeros);
    }
    // The correct digits that mpfr guarantees are computed by enclosures, which need one run where rounding needs two.
    // Values that enclosures of a partial sum leave undecided, an unknown exact 0, may be determined by two runs that
    // agree.
    try {
        return printed({scalar_kind::proved, scalar.digits}, digits, compute, zeros);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided || request.method == trajectory_method::exact) {
            throw;
        }
    }
    return printed(scalar, digits, compute, zeros);
}

// All times in the same runs.
std::vector<trajectory_point> points_together(const trajectory_request& request) {
    const long before = digits_before_point(request);
    const auto values = values_of(request, before);
    const auto errors = errors_of(request, values, before);
    std::vector<trajectory_point> points;
    points.reserve(errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        points.push_back({values[2 * i].text, values[2 * i + 1].text, errors[i].text, ""});
    }
    return points;
}

// Whether a time has no digits: no precision decides them, or omega on the separatrix is too small for all exponents.
bool has_no_digits(const error& problem, const trajectory_request& request) {
    return problem.kind() == error_kind::undecided ||
           (problem.kind() == error_kind::range && request.chosen.of.regime() == regime::separatrix);
}

// Each time separately, so that one without digits does not affect the others.
std::vector<trajectory_point> points_apart(const trajectory_request& request) {
    std::vector<trajectory_point> points;
    points.reserve(request.times.size());
    for (const exact& time : request.times) {
        trajectory_request alone = request;
        alone.times = {time};
        try {
            points.push_back(points_together(alone).front());
        } catch (const error& problem) {
            if (!has_no_digits(problem, request)) {
                throw;
            }
            const bool open = problem.kind() == error_kind::undecided;
            points.push_back({"", "", "", open ? problem.what() : "omega is too small to be printed"});
        }
    }
    return points;
}

}  // namespace

std::vector<trajectory_point> trajectory_points(const trajectory_request& request) {
    const whole_exponent_range exponents;  // of omega on the separatrix, exp(-t)
    try {
        return points_together(request);
    } catch (const error& problem) {
        if (!has_no_digits(problem, request) || request.method == trajectory_method::rk4) {
            throw;
        }
    }
    return points_apart(request);
}

}  // namespace libration
