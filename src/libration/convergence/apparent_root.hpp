// Roots of equations at which their solution is regular.
#pragma once

#include <vector>

#include "libration/convergence/vote.hpp"

namespace libration::convergence {

/// Whether the list is regular at the first of some clusters, the nearest one: if equations of one order alone have a root
/// there with an exponent 0, 1, .. and a sharper cluster belongs to several orders, as a singularity does; or if the list,
/// continued by the equations of the sharpest cluster, does not grow as a singularity there requires.
bool is_regular_point(const approximant_family& family, const std::vector<const root_cluster*>& strong);

}  // namespace libration::convergence
