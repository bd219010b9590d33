// Power series in the variable w of a conformal map x(w) that moves a singularity of f at -R to w = -1 or to infinity:
//     Euler's    x = R w/(1-w),       f analytic in the half-plane Re x > -R/2: |w| < 1,
//     cut        x = 4 R w/(1-w)^2,   f analytic except on the ray from -R to -infinity: |w| < 1,
// for x R > 0. Each coefficient depends on those up to the same power only, so that the partial sums of shorter lists are
// partial sums of the same series [LeGuillouZinnJustin1980].
#pragma once

#include <span>
#include <vector>

#include "libration/scalar/mpfr.hpp"

namespace libration {

/// c_0 .. c_N of f = sum a_n x(w)^n = sum c_n w^n: c_m = sum_{n=1}^m a_n R^n binomial(m-1, n-1). O(N^2).
std::vector<mpfr> in_euler_variable(std::span<const mpfr> a, const mpfr& R);

/// c_m = sum_{n=1}^m a_n (4R)^n binomial(m+n-1, 2n-1). O(N^2).
std::vector<mpfr> in_cut_variable(std::span<const mpfr> a, const mpfr& R);

/// w = x/(x+R).
mpfr euler_variable(const mpfr& x, const mpfr& R);

/// w = (sqrt(1 + x/R) - 1)/(sqrt(1 + x/R) + 1), for x/R > -1.
mpfr cut_variable(const mpfr& x, const mpfr& R);

}  // namespace libration
