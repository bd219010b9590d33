// The Blasius boundary layer at infinity: a lemma for f''' + f f''/2 = 0.
#pragma once

#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// f'(inf) of f''' + f f''/2 = 0, f(0) = f'(0) = 0, f''(0) = 1, in the working precision.
///
/// Lemma. 0 <= f'(inf) - f'(t) <= 2 f''(t)/f(t) for t > 0. Proof: f'' = exp(-int f/2) > 0, so f' and f increase and are
/// positive; for s > t f(s) >= f(t), hence f''(s) <= f''(t) exp(-f(t) (s-t)/2), and f'(inf) - f'(t) = int_t^inf f'' is
/// at most 2 f''(t)/f(t). The integration continues until that is below the precision (f'' falls like exp(-f'(inf)
/// t^2/4)). Every other f''(0) = k > 0 follows exactly: k^(1/3) f(k^(1/3) t) solves the equation with it, f'(inf; k) =
/// k^(2/3) f'(inf).
ball blasius_velocity();

/// k = f''(0) with f'(inf) = value > 0: (value/f'(inf; 1))^(3/2).
ball blasius_shear(const ball& value);

}  // namespace libration::ode
