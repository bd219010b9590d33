// The variables and terms of the expansion at a movable singularity.
#pragma once

#include <vector>

#include "libration/plane/balance/movable_point.hpp"
#include "local_solution.hpp"

namespace libration::ode {

// The polydisc that contains the variables for |x| <= reach, wide enough that the resonant terms are small.
std::vector<movable_variable> polydisc_for(const local_solution& local, const local_model& model, const complex_row& x,
                                           double reach, const weighted_monomials& monomials);

// A bound of the degrees of their logarithms, relative to their rates. Throws error of the kind undecided if one is too high for monotonic bounds.
rational degrees_of_logarithms(const std::vector<movable_variable>& variables, const weighted_monomials& monomials);

// The terms of an unknown, by the real parts of their exponents.
std::vector<movable_term> terms_of(const local_solution& local, const local_model& model, const complex_row& box,
                                   const weighted_monomials& monomials, std::size_t shown);

}  // namespace libration::ode
