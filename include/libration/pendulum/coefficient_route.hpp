// The recurrences for the Taylor coefficients of theta by name, for comparisons of their rounding.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "libration/pendulum/other_recurrences.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// How coefficients are computed.
enum class coefficient_route {
    printed,  ///< (pendseries) as the paper prints it: two products a coefficient, no symmetry used
    squares,  ///< cos theta - cos theta_0 and omega, with the zeros of a symmetry left out (coefficients.hpp)
    omega,    ///< omega'' = (E - 1) omega - omega^3/2 (other_recurrences.hpp)
    lattice   ///< each coefficient by itself, as a sum over the singularities (lattice_coefficients.hpp)
};

inline constexpr std::array<std::pair<std::string_view, coefficient_route>, 4> coefficient_routes{
    {{"printed", coefficient_route::printed},
     {"squares", coefficient_route::squares},
     {"omega", coefficient_route::omega},
     {"lattice", coefficient_route::lattice}}};

/// printed | squares | omega | lattice.
inline std::string name_of(coefficient_route route) {
    return std::string(coefficient_routes.at(static_cast<std::size_t>(route)).first);
}

/// Throws error of the kind argument, with the names, for another one.
inline coefficient_route coefficient_route_named(const std::string& name) {
    for (const auto& [known, route] : coefficient_routes) {
        if (known == name) {
            return route;
        }
    }
    throw error(error_kind::argument, "recurrence", name, "is not printed, squares, omega or lattice");
}

/// a_n scale^n, n = 0 .. N, by one of the three recurrences in the arithmetic T alone. O(N^2). Throws error for lattice,
/// which is not a recurrence, and when N < 0.
template <scalar T>
series::power_series<T> taylor_coefficients_by(coefficient_route route, const taylor_start<T>& start, int order,
                                               const T& scale) {
    taylor_start<T> blind = start;
    blind.of_theta = series::parity::any;
    switch (route) {
        case coefficient_route::printed: return taylor_by_sine_cosine(blind, order, scale);
        case coefficient_route::squares: return taylor_by_symmetric_squares(start, order, scale);
        case coefficient_route::omega: return taylor_by_speed(start, order, scale);
        case coefficient_route::lattice: break;
    }
    throw error(error_kind::argument, "recurrence", name_of(route), "is not a recurrence");
}

/// a_n T*^n, n = 0 .. N, about the top. By lattice a fixed scalar has the coefficients of the mpfr precision in force,
/// rounded to it.
template <scalar T>
series::power_series<T> arc_series_by(coefficient_route route, const fundamental_arc<T>& arc, int order) {
    if (route != coefficient_route::lattice) {
        return taylor_coefficients_by(route, arc.start(), order, arc.effective_period());
    }
    if constexpr (fixed_scalar<T>) {
        const auto wide = arc_series(arc_of<mpfr>(arc.of()), order);
        auto a = series::power_series<T>::zero(order);
        for (int n = 0; n <= order; ++n) {
            a[n] = narrow<T>(wide[n]);
        }
        return a;
    } else {
        return arc_series(arc, order);
    }
}

}  // namespace libration::pendulum
