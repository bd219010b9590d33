// The final state of an SIR epidemic.
#pragma once

#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// The susceptibles left by an SIR epidemic S' = -r S I, I' = r S I - a I: S(inf) for S(0), I(0) > 0 and rho = a/r.
///
/// Lemma. S and S + I decrease and are positive, so S, I have limits; int a I dt <= S(0) + I(0), hence I(inf) = 0, and
/// S(inf) <= rho, since I would grow otherwise. S + I - rho log S is constant: S(inf) is the root in (0, rho) of S -
/// rho log S = S(0) + I(0) - rho log S(0), which is
///     -rho W_0(-(S(0)/rho) exp(-(S(0) + I(0))/rho))
/// with Lambert's function [Arb, arb_lambertw]. In the working precision.
ball epidemic_remainder(const ball& susceptible, const ball& infected, const ball& rho);

}  // namespace libration::ode
