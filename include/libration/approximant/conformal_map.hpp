// Power series in the variable w of a conformal map x(w) that moves a singularity of f at -R to w = -1 or to infinity:
//     Euler's    x = R w/(1-w),       f analytic in the half-plane Re x > -R/2: |w| < 1,
//     cut        x = 4 R w/(1-w)^2,   f analytic except on the ray from -R to -infinity: |w| < 1,
// for x R > 0. Each coefficient depends on those up to the same power only, so that the partial sums of shorter lists are
// partial sums of the same series [LeGuillouZinnJustin1980].
#pragma once

#include <span>
#include <vector>

#include "libration/scalar/mpfr.hpp"
#include "libration/series/power_series.hpp"

namespace libration {

/// The series in w of f with the series a in x = R w/(1-w), to the same order: c_m = sum_{n=1}^m a_n R^n
/// binomial(m-1, n-1), by Horner's rule, each product with w/(1-w) being partial sums. O(N^2), over any field.
template <field T>
series::power_series<T> in_euler_variable(const series::power_series<T>& a, const T& R) {
    const int order = a.order();
    auto c = series::power_series<T>::zero(order);
    for (int n = order; n > 0; --n) {
        T sum = T(c[0] + a[n]);
        c[0] = T(0);
        for (int m = 1; m <= order - n + 1; ++m) {
            const T next = T(sum + c[m]);
            c[m] = T(R * sum);
            sum = next;
        }
    }
    c[0] = a[0];
    return c;
}

/// c_m = sum_{n=1}^m a_n (4R)^n binomial(m+n-1, 2n-1). O(N^2).
std::vector<mpfr> in_cut_variable(std::span<const mpfr> a, const mpfr& R);

/// w = x/(x+R).
template <field T>
T euler_variable(const T& x, const T& R) {
    return T(x / (x + R));
}

/// w = (sqrt(1 + x/R) - 1)/(sqrt(1 + x/R) + 1), for x/R > -1.
mpfr cut_variable(const mpfr& x, const mpfr& R);

}  // namespace libration
