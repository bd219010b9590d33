// Solutions that stay at their initial values.
#pragma once

#include <algorithm>
#include <optional>

#include "libration/ode/explicit_system.hpp"

namespace libration::ode {

/// Whether the solution is constant: the derivatives given as initial values are 0, and the right-hand sides vanish
/// identically at these values. False if that does not follow by exact arithmetic, and for a singular initial point.
inline bool is_constant(const explicit_system& system) {
    if (system.singular()) {
        return false;
    }
    const auto places = places_of(system.unknowns());
    const auto start = [&](const expression& leaf) -> std::optional<expression> {
        return leaf.kind() == node_kind::unknown
                   ? std::optional(expression(
                         system.starts()[places.at(leaf.name())][static_cast<std::size_t>(leaf.derivative())]))
                   : std::nullopt;
    };
    const auto is_zero = [](const number& x) { return x.fraction() == rational(0); };
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        const auto& values = system.starts()[i];
        if (!std::all_of(values.begin() + 1, values.end(), is_zero) || !replaced(system.right()[i], start).is(0)) {
            return false;
        }
    }
    return true;
}

}  // namespace libration::ode
