// The recurrence of cos theta and omega, over any field: the scalars, and the fractions that decide which terms vanish.
//
// With D = cos theta - cos theta_0 and w = omega, both in the variable t/scale, and h = scale^2:
//     D'' = h (A + B D - 3 D^2),  A = sin^2 theta_0 - cos theta_0 omega_0^2,  B = 2(1-E) - 6 cos theta_0,
//     w'' = -h (cos theta_0 + D) w.
// D'' follows from omega^2 = 2(E - 1 + cos theta); the shift by cos theta_0 preserves the digits that 1 - 2(E-1)C -
// 3C^2 cancels near E = 0 and 2.
#pragma once

#include "libration/series/convolution.hpp"

namespace libration::pendulum {

/// The coefficients of D and w as far as needed for theta of a given order. About a symmetric point D is even and w has
/// one parity: coefficient j of D is that of t^(step j), and j of w that of t^(first + step j).
template <field R>
class symmetric_squares {
public:
    series::power_series<R> d;  ///< d_0 = 0; d_1 to be set before solve(), if the step is 1
    series::power_series<R> w;  ///< w_0 to be set, and w_1 if the step is 1

    /// For theta up to t^order, with this parity of theta - theta_0.
    symmetric_squares(int order, series::parity of_theta)
        : d(series::power_series<R>::zero(order / step_of(of_theta) + 2 / step_of(of_theta))),
          w(d),
          order_(order),
          step_(step_of(of_theta)),
          first_(of_theta == series::parity::even ? 1 : 0) {}

    int step() const { return step_; }
    int first() const { return first_; }

    /// All other coefficients, from hA, hB, cos theta_0 and h. O((N/step)^2): a square and a product of series.
    void solve(const R& constant, const R& linear, const R& cosine, const R& h) {
        const int second = 2 / step_;  // the offset of the second derivative
        for (int j = 0, n = 0; n + 2 <= order_; ++j, n += step_) {
            const R forcing = n == 0 ? constant : R(0);
            d[j + second] = (forcing + linear * d[j] - square_coefficient(d, j) * 3 * h) / (n + 1) / (n + 2);
        }
        for (int j = 0, n = first_; n + 2 <= order_; ++j, n += step_) {
            w[j + second] = -(cosine * w[j] + product_coefficient(d, w, j)) * h / (n + 1) / (n + 2);
        }
    }

private:
    static int step_of(series::parity p) { return p == series::parity::any ? 1 : 2; }

    int order_;
    int step_;
    int first_;
};

}  // namespace libration::pendulum
