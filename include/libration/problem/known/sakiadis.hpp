// The boundary layer of Sakiadis predicted from its coefficients alone.
#pragma once

#include "libration/equation/equation_system.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// The predictions of the approximant of the Sakiadis layer from `known` coefficients, where f''(0) and f(inf) are both
/// unknown: with n = known - 2 exponentials as many conditions are left [Barlow2017].
struct sakiadis_prediction {
    mpfr wall_shear;  ///< f''(0)
    mpfr limit;       ///< f(inf)
    mpfr amplitude;   ///< G of f ~ f(inf) + G e^(-f(inf) t/2)
};

/// By Newton's method from (-0.45, 1.6), in the working precision. Throws error for known < 4.
sakiadis_prediction predicted_sakiadis(const ode::equation_system& given, int known);

}  // namespace libration
