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

/// Theorem S, the same about a regular singular start, in powers of the distance s itself (a tape of root 1, made by
/// tape::about_start, of products, squares and what is linear, without derivatives of the unknowns; N = degree; the
/// expansion longer by as much as steps of the tape lag behind).
///
/// With D_i(n) = n (n-1) .. (n-q_i+1) - sum_l w_il n .. (n-l+1), w the weights of the tape, the coefficients are
/// D_i(n) y_{i,n} = [F_i(y)]_n, where [F_i]_n reads y_0 .. y_{n-1} alone. For n > N > q_i, D_i(n) >= d_i, the value at N +
/// 1 with |w| for w: n .. (n-q+1) grows, and so does its quotient with n .. (n-l+1), l < q. Where d_i > 0 and for some
/// s >= 0 and all i
///     ||F_i(p), degrees >= N||/d_i + G_i(s)/d_i <= s_i,
/// the map that takes e = O(t^(N+1)) to the coefficients beyond N of F(p + e), divided by D, takes {||e_i|| <= s_i} into
/// itself. From e = 0 its j-th iterate has the right coefficients up to N + j: so every partial sum of the norm of the
/// solution's remainder is at most s_i, the series converges in |t| < rho, and solves the equation there. `error` is s.
std::optional<tail_bound> bounded_singular_tail(const tape& of, const taylor_expansion<ball>& expansion, int degree,
                                                const magnitude& radius);

}  // namespace libration::ode
