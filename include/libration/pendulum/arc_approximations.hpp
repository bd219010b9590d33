// The approximations of theta on [0, T*], compared at the same number of coefficients.
//
// Every number that is nonzero by symmetry and belongs to a power of t is counted: Taylor coefficients at the top and,
// for those that use derivatives at the bottom, also these. Constants are not counted, nor are T* and K~', which every
// use needs (series and resummations T*, the uniform one both).
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "libration/pendulum/arc_pade.hpp"
#include "libration/pendulum/endpoint_resummation.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/uniform_convergence_rate.hpp"
#include "libration/pendulum/uniform_resummation.hpp"

namespace libration::pendulum {

enum class approximation { series, resummed, fourth, eighth, two_point, pade, uniform };

inline constexpr std::array all_approximations{approximation::series, approximation::resummed,  approximation::fourth,
                                               approximation::eighth, approximation::two_point, approximation::pade,
                                               approximation::uniform};

constexpr std::string_view name_of(approximation a) {
    switch (a) {
        case approximation::series: return "series";
        case approximation::resummed: return "resummed";
        case approximation::fourth: return "resummed_4";
        case approximation::eighth: return "resummed_8";
        case approximation::two_point: return "two_point";
        case approximation::pade: return "pade";
        case approximation::uniform: break;
    }
    return "uniform";
}

/// The last power N from the top and the number m of conditions at the bottom.
struct approximation_size {
    int order;
    int conditions;
};

/// The number of conditions at the bottom, for the approximations with a fixed number of them.
constexpr int fixed_conditions(approximation a) {
    switch (a) {
        case approximation::resummed: return 2;
        case approximation::fourth: return 4;
        case approximation::eighth: return 8;
        case approximation::series:
        case approximation::two_point:
        case approximation::pade:
        case approximation::uniform: break;
    }
    return 0;
}

/// The size that uses `count` coefficients, theta's parity about the top being 0 (libration) or 1; std::nullopt if
/// there is none. At the bottom the m/2 odd derivatives count; the two-point expansion of rotation uses equally many at
/// both ends.
constexpr std::optional<approximation_size> size_for(approximation a, int count, int parity) {
    if (a == approximation::two_point) {
        const bool possible = count >= 1 && (parity == 0 || count % 2 == 0);
        return possible ? std::optional(approximation_size{count - parity, count - parity + 1}) : std::nullopt;
    }
    const int conditions = fixed_conditions(a);
    const int from_top = count - conditions / 2;
    return from_top >= 1 ? std::optional(approximation_size{2 * from_top - parity, conditions}) : std::nullopt;
}

/// The exact asymptotic factor by which one more coefficient multiplies the error (for the two-point expansion: the
/// square root of the factor of two more); std::nullopt for Pade, which has no closed form.
template <scalar T>
std::optional<T> convergence_rate(approximation a, const top_bounds<T>& b) {
    const T by_power = a == approximation::uniform ? uniform_convergence_rate(b, 1) : b.rho;
    switch (a) {
        case approximation::pade: return std::nullopt;
        case approximation::two_point: return two_point_rate(b);
        case approximation::series:
        case approximation::resummed:
        case approximation::fourth:
        case approximation::eighth:
        case approximation::uniform: break;
    }
    return by_power * by_power;
}

/// Its proved bound: theorem A for the series, A2 and its generalisation for those with conditions at the bottom, U for
/// the uniform one. std::nullopt for Pade, and below the orders where the theorems hold.
template <scalar T>
std::optional<T> proved_norm(approximation a, const approximation_size& size, const top_bounds<T>& b) {
    if (a == approximation::uniform) {
        return uniform_bounds<T>{b.parity, 1}.norm(size.order);
    }
    if (a == approximation::pade) {
        return std::nullopt;
    }
    if (a == approximation::series) {
        return b.first_omitted(size.order) >= 4 ? std::optional(b.series_norm(size.order)) : std::nullopt;
    }
    return size.order + 1 + size.conditions >= 4 ? std::optional(endpoint_norm(b, size.order, size.conditions))
                                                 : std::nullopt;
}

/// Calls use(f) with the approximation as a function of x, at the current working precision.
template <class Use>
auto with_approximation(approximation a, const motion& m, const fundamental_arc<mpfr>& arc, int count, const Use& use) {
    const int parity = parity_from_top(m.regime());
    const approximation_size size = size_for(a, count, parity).value();
    switch (a) {
        case approximation::series: return use(series_from_top(arc, size.order));
        case approximation::pade: return use(pade_from_top(arc, count));
        case approximation::uniform: return use(uniform_from_top<mpfr>(m, size.order));
        case approximation::resummed:
        case approximation::fourth:
        case approximation::eighth:
        case approximation::two_point: break;
    }
    return use(endpoint_from_top(arc, size.order, size.conditions));
}

}  // namespace libration::pendulum
