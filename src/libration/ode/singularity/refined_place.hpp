// A singularity that was found in double precision, in many digits.
#pragma once

#include <vector>

#include "libration/ode/singularity/singularity_map.hpp"
#include "singularity_search.hpp"

namespace libration::ode {

inline plane_point rounded_point(const complex_number<mpfr>& z) {
    return {static_cast<double>(z.re), static_cast<double>(z.im)};
}

inline double rounded_size(const complex_number<mpfr>& z) { return static_cast<double>(mpfr(modulus_of(z))); }

/// Walks the path of a candidate in mpfr and halves it towards the singularity that the unknowns of a group show; the
/// place, its uncertainty, and exponents and coefficient of the most singular function of the group. Leaves are indices
/// of the system of the paths; exponents of leaves outside of the group, and of those whose ratios of coefficients do
/// not settle, are 0. Throws error of the kind undecided where no singularity of the group comes out.
found_singularity refined_place(const path_system& of, const candidate& from, const leaf_group& group, long digits);

}  // namespace libration::ode
