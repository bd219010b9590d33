// The Taylor series of theta about a point of a motion, by the way that is cheapest for its order and precision.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "libration/pendulum/lattice_coefficients.hpp"

namespace libration {

/// A Taylor series of theta about a point: coefficients a_n scale^n, the scale being the radius of convergence, of a
/// ball its midpoint (1 where that is infinite), in dimensionless time.
template <scalar T>
struct expansion {
    power_series<T> scaled;
    T scale;
    std::optional<T> radius;  ///< nothing where it is infinite
};

/// The radius of convergence about a point; nothing for equilibria, where it is infinite.
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

/// a_n scale^n, n = first .. last, about a point: by the recurrence of symmetric squares up to the power from which
/// sums over the singularities cost less (lattice_begins), so that powers beyond it cost O(1) each and need none
/// before them. What a_n is does not depend on first and last, up to rounding. Throws std::invalid_argument for first
/// < 0, last < first and last > largest_power.
template <scalar T>
std::vector<T> coefficients_about(const exact_solution<T>& solution, const expansion_point& point, const T& scale,
                                  long first, long last) {
    require_powers(first, last);
    const motion& m = solution.of();
    const phase<T> at = phase_of(point, solution);
    const auto view = view_from(m, at);
    const long begin = view ? lattice_begins(*view, first, last) : 1;
    std::vector<T> part;
    if (first < begin) {
        const auto order = static_cast<int>(std::min(begin - 1, last));
        const auto head = taylor_coefficients(start_at(solution, at), order, scale);
        part.assign(head.coefficients().begin() + first, head.coefficients().end());
        // What symmetry makes 0 is 0, on balls too, where the recurrence only contains it at E = 1.
        for (long n = std::max(first, 1L); view && n <= order; ++n) {
            if (!view->powers().has(n)) {
                part[static_cast<std::size_t>(n - first)] = T(0);
            }
        }
    }
    if (!view) {
        part.resize(static_cast<std::size_t>(last - first + 1), T(0));  // an equilibrium stays where it is
    } else if (last >= begin) {
        auto tail = lattice_coefficients<T>(m, point, scale, last).between(std::max(first, begin), last);
        part.insert(part.end(), std::make_move_iterator(tail.begin()), std::make_move_iterator(tail.end()));
    }
    return part;
}

/// The expansion of order N about a point, by the cheapest way. Throws std::invalid_argument when N < 0.
template <scalar T>
expansion<T> expand(const exact_solution<T>& solution, const expansion_point& point, int order) {
    require_taylor_order(order);
    auto radius = radius_about(solution, point);
    T scale = midpoint(radius.value_or(T(1)));
    power_series<T> scaled(coefficients_about(solution, point, scale, 0, order));
    return {std::move(scaled), std::move(scale), std::move(radius)};
}

}  // namespace libration
