// The Taylor series of theta about a point of a motion, by the cheapest method for its order and precision.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "libration/pendulum/lattice_coefficients.hpp"
#include "libration/pendulum/theta_series.hpp"
#include "libration/scalar/compiled.hpp"
#include "libration/series/scaled_quotient.hpp"

namespace libration::pendulum {

/// A Taylor series of theta about a point: coefficients a_n scale^n, where the scale is the radius of convergence, or
/// the midpoint if that is a ball (1 if it is infinite), in dimensionless time.
template <scalar T>
struct expansion {
    series::power_series<T> scaled;
    T scale;
    std::optional<T> radius;  ///< std::nullopt if it is infinite
};

/// The radius of convergence about a point; std::nullopt for equilibria, for which it is infinite.
template <scalar T>
std::optional<T> radius_about(const exact_solution<T>& solution, const expansion_point& point) {
    const auto lattice = singularities<T>(solution.of());
    return lattice ? std::optional<T>(lattice->radius(phase_of(point, solution))) : std::nullopt;
}

/// By a recurrence alone: the independent check of expand(). O(N^2) products.
template <scalar T>
expansion<T> expand_by(recurrence by, const exact_solution<T>& solution, const expansion_point& point, int order) {
    auto radius = radius_about(solution, point);
    T scale = midpoint(radius.value_or(T(1)));
    auto scaled = taylor_coefficients(start_at(solution, phase_of(point, solution)), order, scale, by);
    return {std::move(scaled), std::move(scale), std::move(radius)};
}

/// a_n scale^n, n = 0 .. N, about a point: by the recurrence of symmetric squares or, if whole quotients are available,
/// by the quotient of thetas, whose errors are smaller: of 8/n the recurrence loses about 20 bits up to N = 800, the
/// quotient 2. The fixed scalars do not use it.
template <scalar T>
series::power_series<T> head_coefficients(const exact_solution<T>& solution, const expansion_point& point,
                                          const T& scale, int order, head_by head) {
    if constexpr (!fixed_scalar<T>) {
        if (head == head_by::thetas) {
            return taylor_by_thetas(solution, point, order, scale);
        }
    }
    return taylor_coefficients(start_at(solution, phase_of(point, solution)), order, scale);
}

/// The power at which the sums over the singularities begin, and the method for the powers before it.
template <scalar T>
std::pair<long, head_by> start_and_head(const singularity_view<T>& view, long first, long last) {
    const long begin = lattice_begins(view, first, last);
    if constexpr (!fixed_scalar<T>) {
        if (first < begin && series::has_whole_quotients<T>() &&
            thetas_cost_less<T>(view.symmetric(), std::min(begin - 1, last))) {
            return {lattice_begins(view, first, last, head_by::thetas), head_by::thetas};
        }
    }
    return {begin, head_by::recurrence};
}

/// a_n scale^n, n = first .. last, about a point: by head_coefficients() up to the power from which sums over the
/// singularities cost less (lattice_begins), so that powers beyond it cost O(1) each and none before them is needed.
/// a_n does not depend on first and last, up to rounding. Throws error for first < 0, last < first
/// and last > largest_power.
template <scalar T>
std::vector<T> coefficients_about(const exact_solution<T>& solution, const expansion_point& point, const T& scale,
                                  long first, long last) {
    require_powers(first, last);
    const motion& m = solution.of();
    const phase<T> at = phase_of(point, solution);
    const auto view = view_from(m, at);
    const auto [begin, head] = view ? start_and_head(*view, first, last) : std::pair(1L, head_by::recurrence);
    std::vector<T> part;
    if (first < begin) {
        const auto order = static_cast<int>(std::min(begin - 1, last));
        const auto all = head_coefficients(solution, point, scale, order, head);
        part.assign(all.coefficients().begin() + first, all.coefficients().end());
        // Coefficients that vanish by symmetry are 0, on balls too, where the recurrence only encloses 0 at E = 1.
        for (long n = std::max(first, 1L); view && n <= order; ++n) {
            if (!view->powers().has(n)) {
                part[static_cast<std::size_t>(n - first)] = T(0);
            }
        }
    }
    if (!view) {
        part.resize(static_cast<std::size_t>(last - first + 1), T(0));  // an equilibrium is constant
    } else if (last >= begin) {
        auto tail = lattice_coefficients<T>(m, point, scale, last).between(std::max(first, begin), last);
        part.insert(part.end(), std::make_move_iterator(tail.begin()), std::make_move_iterator(tail.end()));
    }
    return part;
}

/// The expansion of order N about a point, by the cheapest method. Throws error when N < 0.
template <scalar T>
expansion<T> expand(const exact_solution<T>& solution, const expansion_point& point, int order) {
    require_taylor_order(order);
    auto radius = radius_about(solution, point);
    T scale = midpoint(radius.value_or(T(1)));
    series::power_series<T> scaled(coefficients_about(solution, point, scale, 0, order));
    return {std::move(scaled), std::move(scale), std::move(radius)};
}

// Compiled once, in libration::libration.
#ifdef LIBRATION_COMPILED
#define LIBRATION_DECLARE(T)                                                                                      \
    extern template expansion<T> expand_by(recurrence, const exact_solution<T>&, const expansion_point&, int);    \
    extern template expansion<T> expand(const exact_solution<T>&, const expansion_point&, int);                   \
    extern template std::vector<T> coefficients_about(const exact_solution<T>&, const expansion_point&, const T&, \
                                                      long, long);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DECLARE)
#undef LIBRATION_DECLARE
#endif

}  // namespace libration::pendulum
