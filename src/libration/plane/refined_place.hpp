// Refinement in high precision of a singularity found in double precision.
#pragma once

#include <vector>

#include "libration/plane/singularity_map.hpp"
#include "singularity_search.hpp"

namespace libration::ode {

inline plane_point rounded_point(const complex_number<mpfr>& z) {
    return {static_cast<double>(z.re), static_cast<double>(z.im)};
}

inline double rounded_size(const complex_number<mpfr>& z) { return static_cast<double>(mpfr(modulus_of(z))); }

/// Follows the path of a candidate in mpfr and approaches the singularity of the unknowns of a group; returns the
/// location, its uncertainty, and the exponents and the coefficient of the most singular function of the group. Leaves
/// are indices of the system of the paths; exponents of leaves outside the group, and of those whose ratios of
/// coefficients do not converge, are 0. Throws error of the kind undecided if no singularity of the group is found.
found_singularity refined_place(const path_system& of, const candidate& from, const leaf_group& group, long digits);

}  // namespace libration::ode
