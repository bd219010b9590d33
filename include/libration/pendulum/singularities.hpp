// The singularities of theta(t) in the complex t-plane and the radius of convergence of its Taylor series.
#pragma once

#include <optional>

#include "libration/elliptic/jacobi.hpp"
#include "libration/pendulum/phase.hpp"

namespace libration::pendulum {

/// Logarithmic branch points of theta, simple poles of omega with residue +-2i, at 2 p T* +- i (2 q + 1) K~' from a
/// passage through the bottom, p any integer, q >= 0; from the top, odd multiples of T* [paper (libratingpoles),
/// (rotatingpoles)]. On the separatrix one column remains, K~' = pi/2.
template <scalar T>
struct singularity_lattice {
    T effective_period;  ///< T*; unused on the separatrix
    T height;            ///< K~'
    bool single_column = false;

    /// Distance from a phase to the nearest column: |offset| next to the bottom, T* - |offset| next to the top.
    T distance_to_column(const phase<T>& p) const {
        const T away = p.offset * p.side;
        return single_column || elliptic::quarter_of_four(p.quarter) % 2 == 0 ? away : T(effective_period - away);
    }

    /// Radius of convergence of the Taylor series about a phase: the distance to the nearest singularity
    /// [paper (librationROC), (rotationROCgood)].
    T radius(const phase<T>& p) const {
        using std::sqrt;
        const T along = distance_to_column(p);
        return sqrt(along * along + height * height);
    }
};

/// The lattice of a motion; std::nullopt for the equilibria, whose theta is entire.
template <scalar T>
std::optional<singularity_lattice<T>> singularities(const motion& m) {
    switch (m.regime()) {
        case regime::stable_equilibrium:
        case regime::unstable_equilibrium: return std::nullopt;
        case regime::separatrix: return singularity_lattice<T>{T(0), pi<T>() / 2, true};
        case regime::libration:
        case regime::rotation: break;
    }
    const energy_level<T> o = energy_level_of<T>(m);
    return singularity_lattice<T>{effective_period(o), singularity_height(o)};
}

}  // namespace libration::pendulum
