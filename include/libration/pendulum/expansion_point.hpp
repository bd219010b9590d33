// Expansion points of a motion by name: top, bottom, start, or a time.
#pragma once

#include <concepts>
#include <string_view>
#include <utility>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// A point of a motion to expand about. The top is the one from which canonical motions start (+theta_max, or pi after
/// the whole turns), the bottom the passage T* later.
struct expansion_point {
    enum class place { top, bottom, start, time } where = place::top;
    exact time;  ///< for place::time
};

/// Reads top, bottom, start or a time; throws error as read_exact does.
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
        throw error(error_kind::argument, error_subject::point, std::string(text), "is an angle, not a time");
    }
    return {place::time, std::move(time)};
}

/// The phase of a point of a motion; clock(), its phase map, is called for "start" and times alone. Throws
/// error for the top at E = 2, which is reached after infinite time.
template <scalar T, class Clock>
phase<T> phase_of(const expansion_point& point, const motion& m, const Clock& clock) {
    const integer top = exact_solution<T>::top_quarter(m);
    const bool critical = at_critical_energy(m.regime());
    switch (point.where) {
        case expansion_point::place::start: return clock().at(exact{});
        case expansion_point::place::time: return clock().at(point.time);
        case expansion_point::place::bottom: return phase_map<T>::at_quarter(critical ? integer(0) : integer(top + 1));
        case expansion_point::place::top: break;
    }
    if (critical) {
        throw error(error_kind::argument, error_subject::point, "top", "is not a point of a motion with E = 2");
    }
    return phase_map<T>::at_quarter(top);
}

/// phase_of() by the clock of a solution.
template <scalar T>
phase<T> phase_of(const expansion_point& point, const exact_solution<T>& solution) {
    return phase_of<T>(point, solution.of(), [&]() -> const phase_map<T>& { return solution.phases(); });
}

/// The same without a solution.
template <scalar T>
phase<T> phase_of(const expansion_point& point, const motion& m) {
    return phase_of<T>(point, m, [&] { return phase_map<T>(m); });
}

/// The phase at the fraction x of T* after the top at which canonical motions start, 0 <= x <= 1, x a rational or a T.
/// It is counted from the nearer end of the arc, at its midpoint from the top; the offset is one product. Not at E = 2.
template <scalar T, class X>
phase<T> phase_from_top(const motion& m, const X& x, const T& effective_period) {
    const int whole = x * 2 > 1 ? 1 : 0;
    const X rest = x - whole;
    T offset(0);
    if constexpr (std::same_as<X, rational>) {
        offset = from_rational<T>(rest) * effective_period;
    } else {
        offset = rest * effective_period;
    }
    const int side = rest > 0 ? 1 : rest < 0 ? -1 : 0;
    return {integer(exact_solution<T>::top_quarter(m) + whole), std::move(offset), side};
}

}  // namespace libration::pendulum
