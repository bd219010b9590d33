// Right-hand sides with roots of t - tau, which are not analytic at the time tau, as analytic functions of a root of it.
#pragma once

#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

/// A time tau with roots of t - tau, and w with
///     t = tau + side w^degree,
/// in which they are integer powers: real for w of both signs if only cube roots occur, which are real on both sides of
/// tau, otherwise for w >= 0, on the side of tau where the roots are real.
struct root_time {
    number time;
    int degree = 1;  ///< least common denominator of the exponents
    int side = 1;    ///< 1 after tau, -1 before it; 1 if both
    bool both = false;
};

/// The times of sqrt(u), cbrt(u) and u^(p/q) in the right-hand sides, u linear in t with constant coefficients, each
/// once. One with roots that are real on different sides is not contained: no solution is there.
std::vector<root_time> root_times(const explicit_system& system);

/// An expression with t = tau + side w^degree, in which w is the variable: each root about tau as a power of w.
expression in_root(const expression& e, const root_time& about);

/// The system in w, dy/dw = degree side w^(degree-1) dy/dt, about points given with their states. The unknowns are the
/// leaves of the form.
explicit_system in_root(const first_order_form& form, const root_time& about, const number& point);

/// The system from its initial point t0, at which it is singular with a series in powers of w = (t - t0)^(1/degree), in
/// w from 0 on. Its initial point may be singular again, without roots.
explicit_system in_root_of_start(const explicit_system& system);

}  // namespace libration::ode
