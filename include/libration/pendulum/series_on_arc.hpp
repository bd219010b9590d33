// The Taylor coefficients of theta about a point between the top and the bottom, as a list for radius tests: each
// correct up to one rounding of its scalar, and exactly known facts about their ratios.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "libration/pendulum/expansion_coverage.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration::pendulum {

/// a_n unit^n about a point, each within a unit in the last place of T.
template <rounding_scalar T>
struct arc_list {
    series::power_series<T> scaled;
    T unit;  ///< dimensionless time
};

/// The list about the fraction x of T*, in a unit of `radii` radii of convergence; a value not equal to 1 hides the
/// radius from the tests. The coefficients are computed by the recurrence in more digits than those of T, so that
/// rounding them is their only noise. O(N^2) products. Throws error at E = 0 and 2, and for a negative order.
template <rounding_scalar T>
arc_list<T> series_on_arc(const motion& m, const rational& x, int order, const rational& radii = 1) {
    constexpr long guard_digits = 25;
    series::power_series<mpfr> wide;
    mpfr unit;
    {
        const precision_scope scope(decimal_digits(digits<T>() + m.condition_bits()) + guard_digits);
        const expansion_coverage<mpfr> cover = coverage_from<mpfr>(m, x);
        unit = cover.radius * from_rational<mpfr>(radii);
        wide = taylor_coefficients(start_at(exact_solution<mpfr>(m), cover.place), order, unit);
    }
    std::vector<T> rounded;
    rounded.reserve(wide.coefficients().size());
    for (const mpfr& a : wide.coefficients()) {
        rounded.push_back(narrow<T>(a));
    }
    return {series::power_series<T>(std::move(rounded)), narrow<T>(unit)};
}

/// The nearest singularity (of least argument) to the fraction x of T*, relative to it: (1-x) T* + i K~'.
template <scalar T>
complex_number<T> nearest_on_arc(const expansion_coverage<T>& cover, const rational& x) {
    return {from_rational<T>(rational(1 - x)) * cover.effective_period, cover.height};
}

/// The number of nearest singularities: four about the top, two elsewhere. Each pair R e^(+-i phi) of logarithms 2i
/// contributes (4/n) R^-n sin(n phi + const) to a_n, so that |a_n| R^n n is at most twice this number, up to (R/R2)^n
/// for the next ones at a distance R2.
inline int nearest_count_on_arc(const rational& x) { return x == 0 ? 4 : 2; }

/// The limit of a_n/a_{n-p} R^p, the ratios of the series in t^p: 1 or -1 if all nearest singularities R e^(i phi)
/// are one in t^p; std::nullopt if they are a pair there, whose ratios scatter forever. They are one about the bottom,
/// where phi = +-pi/2, in t^2, and about the top at E = 1, where phi is an odd multiple of pi/4, in t^4; nowhere else
/// for any of the powers 1, 2 and 4 that symmetry leaves.
inline std::optional<int> limit_of_ratios(const motion& m, const rational& x, int power) {
    const bool square = m.energy() && *m.energy() == 1;
    if (x == 1 && power % 2 == 0) {
        return power % 4 == 0 ? 1 : -1;
    }
    if (x == 0 && square && power % 4 == 0) {
        return power % 8 == 0 ? 1 : -1;
    }
    return std::nullopt;
}

}  // namespace libration::pendulum
