// Tubes around approximate solutions, in moving frames: theorem K.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/integration/lohner_set.hpp"

namespace libration::ode {

/// Coefficients of 1, x, x^2, ...; empty for the polynomial 0.
using ball_polynomial = std::vector<ball>;

/// From `start`, over a length of either sign, which is exact; a start that is a ball represents each of its times. On
/// it t = start + (1 + x) length/2, -1 <= x <= 1.
struct step_interval {
    ball start, length;
};

/// A set at the end of a tube.
struct tube_set : state_set {
    std::size_t slow = 0;  ///< the number of leading columns of the error set that follow the flow
};

/// Theorem K. Let f be continuous with a continuous derivative f_y, on a step s <= t <= u let p(t) and V(t) be
/// continuously differentiable, V invertible, its columns in blocks b of one or two, and r_b(t) >= 0 continuous and
/// piecewise differentiable. Let U(t) = { p + V e : |e_b| <= r_b for all b } be in the domain of f, and
///     B(t, y) = V^-1 (f_y(t, y) V - V'),    d(t) = V^-1 (p' - f(t, p)),
///     a_bb(t) >= mu(B_bb(t, y)), a_bc(t) >= ||B_bc(t, y)|| for b != c, y in U(t),    delta_b(t) >= |d_b(t)|,
/// mu(M) the largest eigenvalue of (M + M^T)/2 with its sign. If
///     r_b' >= sum_c a_bc r_c + delta_b    at all t but finitely many, for all b,
/// every solution of y' = f(t, y) with y(s) in U(s) exists on the whole step and is in U(t) for all t of it. a_bb may
/// be negative, so that fast decaying modes make the tube narrow.
///
/// Proof. y = p + V e solves the equation iff e' = F(t, e) = V^-1 (f(t, p + V e) - V' e - p'). For |e_b| <= r_b the
/// segment from p to p + V e is in U(t), so F(t, e) = M e - d with M = int_0^1 B(t, p + x V e) dx; mu and norms are
/// convex, so mu(M_bb) <= a_bb and ||M_bc|| <= a_bc. Let c(t, e) shorten each e_b to the length r_b(t) if it is longer.
/// By Peano e' = F(t, c(t, e)), continuous and bounded, has a solution on the step with the given initial value. Where
/// |e_b| > r_b, with w = e_b/|e_b| and c_b = r_b w,
///     |e_b|' = r_b <w, M_bb w> + sum_(c != b) <w, M_bc c_c> - <w, d_b> <= sum_c a_bc r_c + delta_b <= r_b',
/// so |e_b| - r_b does not grow while it is positive; it begins at 0 or below, and is never positive. So c(t, e) = e, p
/// + V e solves the equation, and it is the only solution. []
///
/// K1. With constant a_bc and delta_b and r affine in t both sides of the inequality are affine: it holds on the step
/// if it does at both ends.
///
/// K2. Let W be polynomials with W V = 1 + Z, |Z| <= z entry by entry, q < 1 a bound of the row sums of z. Then V^-1 =
/// (1 + N) W with |N| <= n = z + (row sums of z^2)/(1 - q). With J = f_y(t, p) and |f_y(t, y) - J| <= D on U(t)
///     |B - W (J V - V')| <= n |W (J V - V')| + (1 + n) |W| D |V|,    |d| <= (1 + n) |W (p' - f(t, p))|.
/// On polynomials |.| is a bound on [-1, 1]: the sum of |Chebyshev coefficients|, or the largest |value| at M nodes times
/// 1/cos(pi m/(2M)), m < M at least the degree [EhlichZeller1964]. W (p' - f) is multiplied out before bounds are taken,
/// so that the slow rows are not affected by the stiffness of the fast ones.
class solution_tube {
public:
    step_interval on;
    /// y_i = 2^scales_i p_i(x), exact polynomials, and V of the scaled unknowns, by rows.
    std::vector<long> scales;
    std::vector<ball_polynomial> curve, frame;
    std::vector<std::size_t> blocks;
    std::size_t slow = 0;
    /// r at both ends.
    std::vector<magnitude> first, last;

    /// The unknowns at a distance from the beginning of the step, within it.
    std::vector<ball> values_at(const ball& distance) const;
    /// Their derivatives, with bounds of |y' - P'| over the step, P the curve (tube_proof::slope_errors).
    std::vector<ball> slopes_at(const ball& distance, const std::vector<magnitude>& errors) const;
    /// The set at the end, rounded to so many bits.
    tube_set end(long bits, long frame_bits) const;

private:
    ball place_of(const ball& distance) const;
};

/// The end of a curve of scaled unknowns (solution_tube), each unknown rounded to the working precision.
std::vector<ball> end_of(const std::vector<ball_polynomial>& curve, const std::vector<long>& scales);

}  // namespace libration::ode
