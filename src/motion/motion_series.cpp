#include "motion/motion_series.hpp"

#include "libration/pendulum/taylor/point_coefficients.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

namespace {

template <class T>
std::vector<wide_t<T>> coefficients_in(const series_request& request) {
    const precision_scope wider(working_digits() + (rounding_scalar<T> ? 20 : 0));
    return point_coefficients<T>(request.chosen.of, request.at, request.first, request.order);
}

std::vector<bool> vanishing(const series_request& request) {
    return vanishing_at(request.chosen.of, request.at, request.first, request.order);
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
    if (critical && point.time.has_periods()) {
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
