// Solutions on the stable and unstable manifolds of an equilibrium, to be drawn.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// A solution that leaves the equilibrium (unstable) or arrives there (stable).
struct manifold_branch {
    bool stable = false;
    int number = 1;                           ///< among those of its manifold
    std::vector<double> times;                ///< increasing; nearer to the equilibrium than at 0 by the series
    std::vector<std::vector<double>> states;  ///< the unknowns and their lower derivatives
    bool leaves = false;                      ///< whether it was cut where it leaves the region of the others
};

/// The manifolds that are drawn.
struct equilibrium_manifolds {
    std::vector<std::string> names;   ///< of the unknowns and their lower derivatives
    std::vector<double> equilibrium;  ///< exactly an equilibrium, rounded
    std::size_t stable_dimension = 0, unstable_dimension = 0;
    std::vector<manifold_branch> branches;
};

/// The equilibrium of an autonomous system with these values of unknowns, exactly; others, such as derivatives, follow (far_state_of). Each
/// branch begins at a point of the manifold that theorem W proves, near to the equilibrium, and is integrated in double: of a curve both
/// branches, of a manifold of more dimensions several solutions. A branch ends where it comes to rest, after a length of many diameters,
/// or, if it leaves the region of those that remain bounded, at its border. Nothing is proved of the integration. Throws error of the subject
/// "conditions" if there is no such equilibrium, or, of the kind undecided, no manifold that is proved.
equilibrium_manifolds manifolds_of(const equation_system& system,
                                   const std::vector<std::pair<std::string, expression>>& equilibrium, bool stable,
                                   bool unstable);

}  // namespace libration::ode
