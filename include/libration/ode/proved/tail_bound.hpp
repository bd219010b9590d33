// What a Taylor polynomial of a differential equation leaves out: theorem T.
#pragma once

#include <optional>
#include <vector>

#include "libration/ode/ball/taylor_expansion.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// The solution is analytic in |s| < radius, s the distance from the point, and there
///     |y_i(s) - p_i(s)| <= error[i] (|s|/radius)^(degree + 1),
/// p_i the exact Taylor polynomial, for every start and every constant of the balls that p was computed from.
struct tail_bound {
    magnitude radius;
    int degree = 0;
    std::vector<magnitude> error;

    /// The bound at a distance of at most `distance` < radius.
    magnitude at(std::size_t unknown, const magnitude& distance) const {
        return error[unknown] * pow(distance / radius, static_cast<unsigned long>(degree) + 1);
    }
};

/// A bound of |x| in the norm of the series.
inline magnitude size_of(const ball& x) { return magnitude(x); }
inline magnitude size_of(const complex_number<ball>& x) { return hypotenuse(magnitude(x.re), magnitude(x.im)); }

/// Theorem T [THEOREMS: Banach's fixed point in the norm ||a|| = sum |a_n| rho^n]. For a polynomial system y' = f(t, y)
/// of first order, rho = radius, p the exact polynomials of degree N = expansion.order(): where for some s >= 0 and all
/// i
///     rho/(N+1) ||f_i(p), degrees >= N|| + rho/(N+2) G_i(s) <= s_i,
/// G_i(s) a bound of ||f_i(p + e) - f_i(p)|| for ||e_j|| <= s_j, the map e -> D + int(f(p+e) - f(p)) takes {e =
/// O(t^(N+1)), ||e_i|| <= s_i} into itself, and the solution is p + e there. The tape has to be one of products,
/// squares and what is linear, made by tape::about_points; the coefficients those about a point. Nothing where no s was
/// found: rho is too near to the radius of convergence, or the balls are too wide. What the map makes of s bounds e as
/// well. O(N) a product, with products of 30 bits.
template <field R>
std::optional<tail_bound> bounded_tail(const tape& of, const taylor_expansion<R>& expansion, const R& point,
                                       const magnitude& radius);

}  // namespace libration::ode
