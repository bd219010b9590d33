#include "motion_series.hpp"

#include <limits>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/exponent_range.hpp"

namespace libration {

using namespace pendulum;

static_assert(largest_power_of_series == largest_power);

namespace {

template <class T>
std::vector<wide_t<T>> coefficients_in(const motion& m, const expansion_point& point, const series_request& of) {
    const precision_scope wider(working_digits() + (rounding_scalar<T> ? 20 : 0));
    return point_coefficients<T>(m, point, of.first, of.order);
}

}  // namespace

std::vector<printed_number> printed_coefficients(const motion& m, const expansion_point& point,
                                                 const series_request& of, const request& how) {
    const whole_exponent_range exponents;  // of a_n ~ R^-n
    return printed(
        how.scalar, how.printed_digits(), [&]<class T>() { return coefficients_in<T>(m, point, of); },
        [&] { return vanishing_at(m, point, of.first, of.order); });
}

std::vector<mpfr> coefficient_values(const motion& m, const expansion_point& point, const series_request& of,
                                     const scalar_spec& scalar) {
    return rounded_values(
        scalar, [&]<class T>() { return coefficients_in<T>(m, point, of); },
        [&] { return vanishing_at(m, point, of.first, of.order); });
}

mpfr radius_to_digits(const motion& m, const expansion_point& point, long digits) {
    const precision_scope outer(digits + 20);
    if (!singularities<mpfr>(m)) {
        return std::numeric_limits<mpfr>::infinity();
    }
    const auto compute = [&](long guard) {
        const precision_scope scope(digits + guard);
        return std::vector<mpfr>{*radius_about(exact_solution<mpfr>(m), point) * time_unit<mpfr>(m)};
    };
    return agreed_values(digits, compute).front();
}

ode::proved_radius radius_bounds(const motion& m, const expansion_point& point, long digits) {
    ode::proved_radius bounds;
    bounds.infinite = true;
    proved_decimals(digits + 1, [&] {
        const auto found = radius_about(exact_solution<ball>(m), point);
        bounds.infinite = !found;
        if (found) {
            const ball radius = *found * time_unit<ball>(m);
            bounds.lower = lower_bound(radius);
            bounds.upper = upper_bound(radius);
        }
        return bounds.infinite ? std::vector<ball>{} : std::vector{bounds.lower, bounds.upper};
    });
    return bounds;
}

}  // namespace libration
