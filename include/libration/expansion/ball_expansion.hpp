// Taylor coefficients of differential equations in balls: each contains the exact coefficient.
#pragma once

#include "libration/expansion/taylor_expansion.hpp"
#include "libration/function/ball_values.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

#ifdef LIBRATION_COMPILED
extern template class taylor_expansion<ball>;
extern template class taylor_expansion<complex_number<ball>>;
#endif

}  // namespace libration::ode
