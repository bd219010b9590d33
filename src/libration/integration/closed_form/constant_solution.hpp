// Solutions that stay at their initial values.
#pragma once

#include <algorithm>
#include <optional>

#include "libration/equation/defined_zero.hpp"
#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// How far a solution is known to be constant.
enum class constancy {
    none,        ///< not at all
    as_defined,  ///< as long as it is proved to exist: some function, power or divisor ends it where it has no value
    everywhere   ///< for all times
};

/// Whether the solution is constant: the derivatives given as initial values are 0, and the right-hand sides vanish
/// identically at these values. `none` if that does not follow by exact arithmetic, and for a singular initial point.
inline constancy constancy_of(const explicit_system& system) {
    if (system.singular()) {
        return constancy::none;
    }
    const auto places = places_of(system.unknowns());
    const auto start = [&](const expression& leaf) -> std::optional<expression> {
        return leaf.kind() == node_kind::unknown
                   ? std::optional(expression(
                         system.starts()[places.at(leaf.name())][static_cast<std::size_t>(leaf.derivative())]))
                   : std::nullopt;
    };
    const auto is_zero = [](const number& x) { return x.fraction() == rational(0); };
    constancy result = constancy::everywhere;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        const auto& values = system.starts()[i];
        const auto zero = std::all_of(values.begin() + 1, values.end(), is_zero)
                              ? zero_with_domain(system.right()[i], start)
                              : std::nullopt;
        if (!zero) {
            return constancy::none;
        }
        result = zero->empty() ? result : constancy::as_defined;
    }
    return result;
}

}  // namespace libration::ode
