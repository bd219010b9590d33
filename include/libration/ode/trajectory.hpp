// The solution of any system at a list of times, to correct digits.
#pragma once

#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/taylor_expansion.hpp"

namespace libration::ode {

/// The states at times in any order, each value with `digits` correct digits: two marches (taylor_march) that differ in
/// precision and in order agree to them; as many digits more are taken as the flow loses. Nothing is proved. A value
/// that is exactly 0 at a time that is not the start has no digits, and takes long (agreed_values). Throws error where
/// a time is not reached, and of the kind undecided where no precision within the limits does. A fast product of whole
/// sequences (ode/ball/fast_product.hpp) serves beyond some hundred digits.
std::vector<solution_state<mpfr>> trajectory(const explicit_system& system, const std::vector<number>& times,
                                             long digits, const series::block_product<mpfr>* fast = nullptr);

/// The states at points of the complex plane of time, each by the same corners and then straight to it (complex_path):
/// two such ways that differ in precision and in order agree to `digits` digits of each part (agreed_complex_values).
/// Nothing is proved. Throws error where a point is not reached, and of the kind undecided where no precision within
/// the limits does.
std::vector<solution_state<complex_number<mpfr>>> trajectory_along(const explicit_system& system,
                                                                   const std::vector<complex_constant>& corners,
                                                                   const std::vector<complex_constant>& times,
                                                                   long digits);

}  // namespace libration::ode
