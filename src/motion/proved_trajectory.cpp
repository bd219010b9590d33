#include "motion/proved_trajectory.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libration/pendulum/arc/periodic_extension.hpp"
#include "libration/pendulum/arc/uniform_resummation.hpp"
#include "libration/pendulum/proved/proved_motion.hpp"
#include "motion/proved_states.hpp"
#include "run/proofs.hpp"

namespace libration {

namespace {

// What the latest of the times needs.
long digits_before_point(const trajectory_request& request) {
    long most = 0;
    for (const exact& time : request.times) {
        most = std::max(most, digits_before_point(request.chosen.of, time));
    }
    return most;
}

// theta and omega at every time, one after the other.
template <class Function>
std::vector<ball> followed(const trajectory_request& request, Function on_descent) {
    const motion& m = request.chosen.of;
    const ball seconds = time_unit<ball>(m);
    const periodic_extension<ball, Function> extension(m, std::move(on_descent));
    std::vector<ball> values;
    values.reserve(2 * request.times.size());
    for (const exact& time : request.times) {
        jet<ball> at = extension(time);
        values.push_back(std::move(at.value));
        values.push_back(at.slope / seconds);
    }
    return values;
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

std::vector<ball> values_of(const trajectory_request& request) {
    const motion& m = request.chosen.of;
    switch (request.method) {
        case trajectory_method::series: return followed(request, series_from_top(descent_of<ball>(m), request.order));
        case trajectory_method::resummed:
            return followed(request, resummation_from_top(descent_of<ball>(m), request.order));
        case trajectory_method::uniform:
            return followed(request, uniform_from_top<ball>(m, request.order).partial_sum());
        case trajectory_method::exact: return followed_exactly(request);
        default: throw std::invalid_argument("a march of steps has no proof");
    }
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

std::string error_of(const std::string& theta, const proved_motion& solution, const exact& time) {
    const ball truth = solution.at(time).theta;
    const auto error = to_proved_decimal(abs(from_exact<ball>(read_exact(theta)) - truth), error_digits);
    if (!error) {
        throw precision_exhausted("an error");
    }
    return error->text;
}

// The errors of all printed thetas, in as many digits as it takes.
std::vector<std::string> errors_of(const trajectory_request& request, const std::vector<proved_decimal>& printed,
                                   long before) {
    const motion& m = request.chosen.of;
    std::vector<std::string> errors(request.times.size());
    for (long guard = 20; guard <= most_guard_digits; guard *= 2) {
        const precision_scope scope(request.numbers.digits + before + guard);
        try {
            const proved_motion solution(m);
            for (std::size_t i = 0; i < errors.size(); ++i) {
                const std::string& theta = printed[2 * i].text;
                const bool is_exact = rational_theta(m, request.times[i]) == read_exact(theta).coefficient;
                errors[i] = is_exact ? "0" : error_of(theta, solution, request.times[i]);
            }
            return errors;
        } catch (const precision_exhausted&) {
            continue;
        }
    }
    throw std::runtime_error("a proof is impossible: an error is not decided with " +
                             std::to_string(most_guard_digits) + " more digits");
}

}  // namespace

std::vector<proved_point> proved_trajectory(const trajectory_request& request) {
    const long before = digits_before_point(request);
    const auto compute = [&] {
        const precision_scope wider(working_digits() + before);
        return values_of(request);
    };
    const auto printed = proved_decimals(request.numbers.digits, compute, [&] { return vanishing(request); });
    const auto errors = errors_of(request, printed, before);
    std::vector<proved_point> points;
    points.reserve(errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        points.push_back({printed[2 * i].text, printed[2 * i + 1].text, errors[i]});
    }
    return points;
}

}  // namespace libration
