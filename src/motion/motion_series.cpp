#include "motion/motion_series.hpp"

#include <algorithm>

#include "libration/pendulum/taylor/coefficients.hpp"
#include "libration/pendulum/taylor/vanishing_coefficients.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

// Fractions of N digits cost too much beyond.
constexpr long longest_exact_series = 1000;

// The scaled coefficients are rounded in T, and leave its range only here, in its wide arithmetic.
template <class T>
std::vector<wide_t<T>> coefficients_in(const series_request& request) {
    using W = wide_t<T>;
    const precision_scope wider(working_digits() + (rounding_scalar<T> ? 20 : 0));
    const exact_solution<T> solution(request.chosen.of);
    const T scale = midpoint(radius_about(solution, request.at).value_or(T(1)));
    const auto scaled = coefficients_about(solution, request.at, scale, request.first, request.order);
    const W unit = widen(scale) * time_unit<W>(request.chosen.of);
    std::vector<W> values;
    values.reserve(scaled.size());
    W power = pow(unit, request.first);
    for (const T& a : scaled) {
        values.push_back(W(widen(a) / power));
        power *= unit;
    }
    return values;
}

// Which coefficients are exactly 0, as far as fractions tell; nothing where they do not.
std::vector<bool> vanishing(const series_request& request) {
    const motion& m = request.chosen.of;
    const phase<ball> at = phase_of(request.at, exact_solution<ball>(m));
    const bool from_start = request.at.where == expansion_point::place::start;
    const auto cosine = at.side == 0 ? rational_cosine_at(m, at.quarter)
                        : from_start ? rational_cosine_at_start(m)
                                     : std::nullopt;
    // Beyond, only what symmetry makes 0 is known to be, and that is no ball with a radius.
    const auto order = static_cast<int>(std::min(request.order, longest_exact_series));
    if (!cosine || request.first > order) {
        return {};
    }
    const auto all = vanishing_coefficients(*m.energy(), *cosine, order);
    return {all.begin() + request.first, all.end()};
}

}  // namespace

expansion_point point_of(const std::optional<std::string>& at, const chosen_motion& chosen) {
    const bool critical = at_critical_energy(chosen.of.regime());
    const char* const remedy = "write top, bottom, start or a time such as 1.1 or T/8";
    if (!at) {
        return read_expansion_point(chosen.by_state ? "start" : critical ? "bottom" : "top");
    }
    expansion_point point = reading("--at", *at, remedy, [&] { return read_expansion_point(*at); });
    if (critical && point.where == expansion_point::place::top) {
        throw input_error("--at", *at, "is not a point of a motion with E = 2", "write bottom, start or a time");
    }
    if (critical && point.time.measure == unit::period) {
        throw input_error("--at", *at, "is a multiple of an infinite period", "write a time without T");
    }
    return point;
}

std::vector<mpfr> coefficient_values(const series_request& request) {
    return rounded_values(
        request.scalar, [&]<class T>() { return coefficients_in<T>(request); }, [&] { return vanishing(request); });
}

std::vector<printed_number> printed_coefficients(const series_request& request, long digits) {
    return printed(
        request.scalar, digits, [&]<class T>() { return coefficients_in<T>(request); },
        [&] { return vanishing(request); });
}

std::optional<mpfr> exact_radius(const series_request& request, long digits) {
    const motion& m = request.chosen.of;
    const precision_scope outer(digits + 20);
    if (!singularities<mpfr>(m)) {
        return std::nullopt;
    }
    const auto compute = [&](long guard) {
        const precision_scope scope(digits + guard);
        const exact_solution<mpfr> solution(m);
        const auto lattice = singularities<mpfr>(m);
        return std::vector<mpfr>{lattice->radius(phase_of(request.at, solution)) * time_unit<mpfr>(m)};
    };
    return agreed_values(digits, compute).front();
}

}  // namespace libration
