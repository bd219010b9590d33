// Expansion points of a motion by name: top, bottom, start, or a time.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "libration/pendulum/coefficients.hpp"
#include "libration/pendulum/singularities.hpp"

namespace libration {

/// A point of a motion to expand about. The top is the one that canonical motions start from (+theta_max, or pi after the
/// whole turns), the bottom the passage T* later.
struct expansion_point {
    enum class place { top, bottom, start, time } where = place::top;
    exact time;  ///< for place::time
};

/// Reads top, bottom, start or a time; throws std::invalid_argument as read_exact does.
inline expansion_point read_expansion_point(std::string_view text) {
    using place = expansion_point::place;
    if (text == "top") {
        return {place::top, {}};
    }
    if (text == "bottom") {
        return {place::bottom, {}};
    }
    if (text == "start") {
        return {place::start, {}};
    }
    exact time = read_exact(text);
    if (time.measure == unit::degree) {
        throw std::invalid_argument("is an angle, not a time");
    }
    return {place::time, std::move(time)};
}

/// The phase of a point. Throws std::domain_error for the top at E = 2, which is reached after infinite time.
template <scalar T>
phase<T> phase_of(const expansion_point& point, const exact_solution<T>& solution) {
    const motion& m = solution.of();
    const integer top = exact_solution<T>::top_quarter(m);
    const bool critical = at_critical_energy(m.regime());
    switch (point.where) {
        case expansion_point::place::start: return solution.clock().at(exact{});
        case expansion_point::place::time: return solution.clock().at(point.time);
        case expansion_point::place::bottom: return timeline<T>::at_quarter(critical ? integer(0) : integer(top + 1));
        default: break;
    }
    if (critical) {
        throw std::domain_error("is not a point of a motion with E = 2");
    }
    return timeline<T>::at_quarter(top);
}

/// A Taylor series of theta about a point: coefficients a_n scale^n, the scale being the radius of convergence, of a ball
/// its midpoint (1 where that is infinite), in dimensionless time.
template <scalar T>
struct expansion {
    power_series<T> scaled;
    T scale;
    std::optional<T> radius;  ///< nothing where it is infinite
};

/// The expansion of order N about a point.
template <scalar T>
expansion<T> expand(const exact_solution<T>& solution, const expansion_point& point, int order,
                    recurrence by = recurrence::symmetric_squares) {
    const phase<T> at = phase_of(point, solution);
    std::optional<T> radius;
    if (const auto lattice = singularities<T>(solution.of())) {
        radius = lattice->radius(at);
    }
    const T scale = midpoint(radius.value_or(T(1)));
    return {taylor_coefficients(start_at(solution, at), order, scale, by), scale, radius};
}

}  // namespace libration
