// Roots of equations at which their solution is regular.
#pragma once

#include <vector>

#include "libration/convergence/vote.hpp"

namespace libration::convergence {

enum class nature_of_root { regular, singular, undecided };

/// What the list is at the first of some clusters, the nearest one. Regular if equations of one order alone have a root
/// there with an exponent 0, 1, .. and a sharper cluster belongs to several orders, as a singularity does; or if the list,
/// continued by the equations of the sharpest cluster, does not grow as a singularity there requires. Undecided where a
/// root may be regular, but the next one is too near for the growth to distinguish them.
nature_of_root nature_of_nearest(const approximant_family& family, const std::vector<const root_cluster*>& strong);

}  // namespace libration::convergence
