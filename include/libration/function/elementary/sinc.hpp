// sin x / x.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// s = sin(x)/x, 1 at x = 0: x s' = (cos x - s) x'.
struct sinc_function {
    static constexpr auto kind = function_kind::sinc;
    static constexpr std::string_view name = "sinc";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static constexpr singular_points without_polynomial_form{
        1, {0}, "takes sinc of 0, where it has no polynomial form"};
    static exact_value exact(const plain_number& x) { return at_zero(x, 1); }
    static range bounds(const number_bounds& x) { return by_balls(kind, x); }

    template <class E>
    static E derivative(const E& x, const E& w) {
        return (cos(x) - w) / x;
    }

    static constexpr bool odd = false;
    /// Stores sin x and cos x, and divides; if x_0 = 0 and x_m is the first nonzero coefficient,
    /// (n + m) x_m w_n = m x_m c_n + sum_{j=m+1}^{n} x_j (j c_{n+m-j} - (n + m) w_{n+m-j}), by x w' + w x' = c x'.
    static constexpr int kept = 2;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        const R* const c = of.kept[1];
        series::sine_cosine_kernel(of.slope, of.kept[0], of.kept[1], n, of.of_slope, sums);
        if (n == 0) {
            return;
        }
        int m = 0;
        while (m <= n && is_zero(of.x[m])) {
            ++m;
        }
        if (m == 0) {
            series::quotient_kernel(of.kept[0], of.x, of.result, n, series::parity::any, sums);
        } else if (m > n) {
            of.result[n] = R(0);
        } else {
            R sum = of.x[m] * c[n] * m;
            for (int j = m + 1; j <= n; ++j) {
                sum += of.x[j] * (c[n + m - j] * j - of.result[n + m - j] * (n + m));
            }
            of.result[n] = sum / (of.x[m] * (n + m));
        }
    }
    /// The sine and the cosine.
    static constexpr int values_kept = 2;
    template <class E, class Call>
    static E first_kept(int which, const E& x, const Call& call) {
        return call(which == 0 ? function_kind::sin : function_kind::cos, x);
    }

    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_sinc(y, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_sinc(y, x, bits);
    }
};

}  // namespace libration::function
