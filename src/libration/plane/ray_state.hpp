// The state of a solution on a ray from its initial point.
#pragma once

#include <complex>
#include <vector>

#include "libration/plane/chart_atlas.hpp"

namespace libration::ode {

// The unknowns of chart 0 at t0 + base, by discs along the straight line. Throws precision_exhausted if it is not reached.
std::vector<complex_ball> state_on_ray(const explicit_system& system, const chart_atlas& atlas,
                                       std::complex<double> base, int order);

}  // namespace libration::ode
