// Remainder bounds of Taylor polynomials of differential equations: theorem T.
#pragma once

#include <optional>
#include <vector>

#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/function_kernel.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// The solution is analytic in |s| < radius, s the distance from the point, and there
///     |y_i(s) - p_i(s)| <= error[i] (|s|/radius)^(degree + 1),
/// p_i the exact Taylor polynomial, for all initial values and constants in the balls that p was computed from.
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

/// Bounds of |coefficient n| of the steps of a tape, for all initial values and constants of a set.
struct series_sizes {
    int degree = 0;
    /// [step][n], n < degree; of the steps of unknowns n = degree too.
    std::vector<std::vector<magnitude>> of_steps;
    std::vector<magnitude> constants;  ///< of the tape
    magnitude point;
    /// [step]; of a quotient only its reach, the least size of the divisor.
    std::vector<function_kernel> kernels = {};
};

/// Those of an expansion up to a degree; it has as many more terms as the maximum lag of the steps of the tape.
template <field R>
series_sizes sizes_of(const tape& of, const taylor_expansion<R>& expansion, const R& point, int degree);

/// Theorem T [THEOREMS: Banach's fixed point in the norm ||a|| = sum |a_n| rho^n]. For a polynomial system y' = f(t, y)
/// of first order, rho = radius, p the exact polynomials of degree N = sizes.degree: if for some s >= 0 and all i
///     rho/(N+1) ||f_i(p), degrees >= N|| + rho/(N+2) G_i(s) <= s_i,
/// G_i(s) a bound of ||f_i(p + e) - f_i(p)|| for ||e_j|| <= s_j, the map e -> D + int(f(p+e) - f(p)) maps {e =
/// O(t^(N+1)), ||e_i|| <= s_i} into itself, and the solution is p + e there. The tape must be one that
/// norms_of_steps bounds (src/libration/expansion/step_norms.hpp): of products, quotients, powers and functions with a
/// function_kernel; and be made by tape::about_points; the coefficients are those about a point. Returns std::nullopt if no
/// s was found: rho is too close to the radius of convergence, or the balls are too wide. The image of s under the map
/// bounds e as well. O(N) per product, O(N^2) per function, with 30-bit multiplications.
std::optional<tail_bound> bounded_tail(const tape& of, const series_sizes& sizes, const magnitude& radius);
template <field R>
std::optional<tail_bound> bounded_tail(const tape& of, const taylor_expansion<R>& expansion, const R& point,
                                       const magnitude& radius) {
    return bounded_tail(of, sizes_of(of, expansion, point, expansion.order()), radius);
}

/// On 0 <= s <= length |y_i(s) - p_i(s)| <= error[i] and |y_i'(s) - p_i'(s)| <= slope_error[i].
struct remainder_bound {
    std::vector<magnitude> error, slope_error;
};

/// The bounds of y - p and y' - p' of a known unknown.
struct known_remainder {
    int unknown = 0;
    magnitude error;
};

/// Theorem M: as theorem T, on a real interval, for a system in which some functions are known (known_series) as
/// polynomials of degree N - 1 plus continuous functions of at most known.error [THEOREMS: Schauder's theorem in the
/// norm max |a(s)|]. If, with norms for rho = length, for some s >= 0 and all other i
///     length/(N+1) ||f_i(p), degrees >= N|| + length G_i(s) <= s_i,
/// G_i(s) a bound of |f_i(p + e) - f_i(p)| for |e_j| <= s_j, |e_j| <= error for known j, then |y_i - p_i| <= s_i for
/// 0 <= s <= length, and |y_i' - p_i'| <= ||f_i(p), degrees >= N|| + G_i(s). Returns std::nullopt if no s was found.
std::optional<remainder_bound> bounded_remainder(const tape& of, const taylor_expansion<ball>& expansion,
                                                 const ball& point, const magnitude& length,
                                                 const std::vector<known_remainder>& known);

/// Theorem S, the same as theorem T about a regular singular initial point, in powers of the distance t itself: a tape of root 1,
/// made by tape::about_start, with the same operations, in unknowns and first derivatives; N =
/// degree; the expansion must be longer by the maximum lag of the steps of the tape.
///
/// t^q_i y_i^(q_i) = F_i(t, y, y'), where coefficient n of F_i depends on y_n only through sum_l w_il n .. (n-l+1)
/// y_{i,n}, w the weights of the tape. Let p be the polynomials of degree N > q_i with the coefficients of the
/// solution. If for some u >= 0 and all i
///     ||F_i(p), degrees > N|| + G_i(u) <= u_i,
/// G_i(u) a bound of ||F_i(p + e) - F_i(p)|| for e = O(t^(N+1)) with ||t^q_j e_j^(q_j)|| <= u_j, hence ||e_j^(l)|| <=
/// u_j (N+1) .. (N+2-l)/((N+1) .. (N+2-q_j)) rho^-l (that quotient decreases with n), the map from t^q e^(q) to the
/// terms of F(p + e) of degree > N maps that set into itself. The set is convex, and compact in the norm of any smaller
/// rho, in which the map is continuous: by Schauder's theorem it has a fixed point, a solution p + e in |t| < rho. If n
/// .. (n-q_i+1) - sum_l w_il n .. (n-l+1) > 0 for all n > N, which is so if it holds for n = N + 1 and |w|, the
/// coefficients beyond N are determined by those before: that solution is the one whose series begins with p. `error`
/// bounds ||e||.
std::optional<tail_bound> bounded_singular_tail(const tape& of, const taylor_expansion<ball>& expansion, int degree,
                                                const magnitude& radius);

}  // namespace libration::ode
