// Elliptic orbits of the two-body problem in closed form, by Kepler's equation.
#pragma once

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::ode {

/// Position and velocity in the plane.
struct planar_state {
    ball x, y, vx, vy;
};

/// F(u) = u + S (1 - cos u) - C sin u - M, with C^2 + S^2 < 1 and a lower bound of F' = 1 - C cos u + S sin u, positive
/// and exact: Kepler's equation in the difference of the eccentric anomalies.
struct kepler_equation {
    ball c, s, mean, least_slope;

    /// The root of F, from any number near it: it is within |F(near)|/least_slope, the mean value theorem, and by a step
    /// of the interval Newton method from there in near - F(near)/F' over that interval. Throws precision_exhausted if
    /// F' over it contains 0.
    ball root_from(const mpfr& near) const;
};

/// The orbit of x'' = -m x/r^3, y'' = -m y/r^3, r^2 = x^2 + y^2, through a state at time 0, in the working precision.
///
/// Theorem. Let m > 0, and for the state at time 0 let r0 = r,
///     1/a = 2/r0 - (x'^2 + y'^2)/m > 0,  L = x y' - y x' != 0,
///     n = sqrt(m/a^3),  C = 1 - r0/a,  S = (x x' + y y')/sqrt(m a).
/// Then C^2 + S^2 = e^2 = 1 - L^2/(m a) < 1; the solution exists for all times; at each time t Kepler's equation
///     F(u) = u + S (1 - cos u) - C sin u - n t = 0
/// has exactly one root u, with F' = r/a >= 1 - e >= L^2/(2 m a); and with r = a (1 - C cos u + S sin u)
///     x(t) = f x(0) + g x'(0),    f = 1 - (a/r0) (1 - cos u),        g = (S (1 - cos u) + (r0/a) sin u)/n,
///     x'(t) = f' x(0) + g' x'(0), f' = -sqrt(m a)/(r r0) sin u,      g' = 1 - (a/r) (1 - cos u),
/// and likewise y, y'; n t may be reduced by multiples of 2 pi. Proof: docs/theorems/equations.md, elliptic orbits.
/// Nothing is divided by e: circles are included.
class kepler_orbit {
public:
    /// Throws precision_exhausted if the state is not proved to be on an elliptic orbit: 1/a > 0, L != 0.
    kepler_orbit(const ball& m, planar_state start);

    /// The state at a time; the root is approximated in floating-point arithmetic and enclosed by root_from(). Throws
    /// precision_exhausted if the precision does not suffice. Cost: O(log of the precision) sines of floating-point
    /// numbers, and 6 of balls.
    planar_state after(const ball& time) const;

private:
    ball anomaly(const ball& time) const;

    planar_state start_;
    ball distance_;                 // r0
    ball inverse_axis_;             // 1/a
    ball mean_motion_;              // n
    ball root_;                     // sqrt(m a)
    ball cosine_part_, sine_part_;  // C, S
    ball least_slope_;              // of F
};

}  // namespace libration::ode
