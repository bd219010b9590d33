// The solution of the linear differential equation of a differential approximant, continued along the real axis.
//
// With S(k,i) the Stirling numbers of the second kind, (x d/dx)^k = sum_i S(k,i) x^i (d/dx)^i, so that the equation is
//     sum_{i <= M} C_i(x) f^(i)(x) = P(x),   C_i = x^i sum_k S(k,i) Q_k.
// About x = t, with C_i = sum_j c_ij h^j, f = sum_m f_m h^m and h = x - t, its coefficient of h^m gives f_{m+M}:
//     sum_{i,j} c_ij (m-j+i)!/(m-j)! f_{m-j+i} = p_m.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libration/approximant/differential.hpp"

namespace libration {

/// The accuracy of solution_along_axis relative to the function near 0, as an exponent of 2.
inline constexpr long solution_bits = 200;

/// f at each target, for the solution f of the equation whose series at 0 is a_0 .. a_length, continued by the
/// recurrence of the equation, in the variable of that series. The targets have one sign and are sorted by modulus.
/// Taylor polynomials of degree 130; the length of a step follows from its last coefficients, without the roots of Q_M.
/// std::nullopt for targets at or beyond a singularity of the solution on the real axis, at which steps become shorter
/// than 2^-12 of the distance from 0, and after 150 steps. Heuristic: truncation errors are estimated.
std::vector<std::optional<mpfr>> solution_along_axis(const differential_relation& relation, std::span<const mpfr> a,
                                                     int length, std::span<const mpfr> targets);

}  // namespace libration
