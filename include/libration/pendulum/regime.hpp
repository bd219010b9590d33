// The kinds of motion of theta'' + sin theta = 0.
#pragma once

#include <string_view>

namespace libration::pendulum {

/// By the energy E = omega^2/2 + 1 - cos theta: libration below 2, rotation above; at 2 the separatrix or, at rest on
/// top, the unstable equilibrium; at 0 the stable one.
enum class regime { libration, rotation, separatrix, stable_equilibrium, unstable_equilibrium };

inline std::string_view name_of(regime r) {
    switch (r) {
        case regime::libration: return "libration";
        case regime::rotation: return "rotation";
        case regime::separatrix: return "separatrix";
        case regime::stable_equilibrium: return "stable-equilibrium";
        case regime::unstable_equilibrium: break;
    }
    return "unstable-equilibrium";
}

/// E = 2 exactly: the period is infinite and there is no top to expand about.
constexpr bool at_critical_energy(regime r) { return r == regime::separatrix || r == regime::unstable_equilibrium; }

/// theta is constant: its Taylor series converge everywhere.
constexpr bool at_rest(regime r) { return r == regime::stable_equilibrium || r == regime::unstable_equilibrium; }

}  // namespace libration::pendulum
