// A series whose radius of convergence is known: the reference for radius tests.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "libration/convergence/coefficient_growth.hpp"

namespace libration::convergence {

/// The nearest singularities of a function, `count` of them at one distance.
struct known_singularity {
    std::function<complex_number<mpfr>()> position;  ///< of smallest argument >= 0, in working precision
    int count = 1;
    singularity_kind kind = singularity_kind::unknown;  ///< of that singularity
    std::optional<rational> exponent = std::nullopt;    ///< nu of (1 - x/x0)^nu there; 0 is a logarithm
};

/// A function given by its coefficients at 0, and everything that a radius test could determine about it, in T.
/// Everything is computed with guard digits beyond those of T, and rounded once.
template <rounding_scalar T>
struct known_series {
    std::string name;  ///< ASCII, no comma
    std::function<series::power_series<mpfr>(int)>
        expand;                                   ///< a_0 .. a_N with the error of a recurrence, in working precision
    growth coefficient_size = growth::geometric;  ///< entire and divergent if the radius is not positive and finite
    std::optional<T> radius = std::nullopt;       ///< std::nullopt for an entire function, 0 for a divergent series
    T radius_error = T(0);                        ///< of the radius, absolute
    std::optional<complex_number<T>> position =
        {};         ///< the nearest singularity of smallest argument >= 0, if there is one
    int count = 0;  ///< singularities on the circle of convergence; 0 if there are none or they fill it
    singularity_kind kind = singularity_kind::unknown;  ///< of the singularity at `position`
    std::optional<rational> exponent = std::nullopt;    ///< nu there

    /// a_n unit^n, n = 0 .. N, each within an eps of its size. Without a unit close to the radius the coefficients
    /// leave the range of double like R^-n. The cost of `expand`, up to O(N^2).
    series::power_series<T> coefficients(int order, const T& unit = T(1)) const {
        constexpr long guard_bits = 100;
        const auto wide = [&] {
            const precision_scope scope(decimal_digits(digits<T>() + guard_bits));
            return rescale(expand(order), widen(unit));
        }();
        auto a = series::power_series<T>::zero(order);
        for (int n = 0; n <= order; ++n) {
            a[n] = narrow<T>(wide[n]);
        }
        return a;
    }
};

/// A function with isolated nearest singularities.
template <rounding_scalar T>
known_series<T> singular_series(std::string name, std::function<series::power_series<mpfr>(int)> expand,
                                const known_singularity& nearest) {
    constexpr long guard_bits = 64;
    const auto [at, radius] = [&] {
        const precision_scope scope(decimal_digits(digits<T>() + guard_bits));
        auto position = nearest.position();
        mpfr distance = modulus_of(position);
        return std::pair{std::move(position), std::move(distance)};
    }();
    known_series<T> series{std::move(name), std::move(expand)};
    series.radius = narrow<T>(radius);
    series.position = complex_number<T>{narrow<T>(at.re), narrow<T>(at.im)};
    series.count = nearest.count;
    series.kind = nearest.kind;
    series.exponent = nearest.exponent;
    return series;
}

/// A function with the unit circle as natural boundary: every point of it is singular.
template <rounding_scalar T>
known_series<T> bounded_series(std::string name, std::function<series::power_series<mpfr>(int)> expand) {
    known_series<T> series{std::move(name), std::move(expand)};
    series.radius = T(1);
    series.kind = singularity_kind::boundary;
    return series;
}

/// An entire function.
template <rounding_scalar T>
known_series<T> entire_series(std::string name, std::function<series::power_series<mpfr>(int)> expand) {
    return {std::move(name), std::move(expand), growth::entire};
}

/// A series of radius 0.
template <rounding_scalar T>
known_series<T> divergent_series(std::string name, std::function<series::power_series<mpfr>(int)> expand) {
    return {std::move(name), std::move(expand), growth::divergent, T(0)};
}

}  // namespace libration::convergence
