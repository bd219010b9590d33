// Two more methods for the Taylor coefficients of theta, whose cost is compared with coefficients.hpp: through the
// Jacobi function under the arcsine of the closed solution [paper (subcritical), (supercritical)], and through omega.
#pragma once

#include "libration/pendulum/coefficients.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/square_root.hpp"

namespace libration::pendulum {

/// Through y = sin(theta/2), which is k cd(t, k) from the top of libration and sn(t sqrt(E/2), sqrt(2/E)) from the
/// bottom of rotation: y'^2 = (1 - y^2)(E/2 - y^2), so
///     y'' = -(1 + E/2) y + 2 y^3,   theta = 2 arcsin y,   theta' = 2 y'/sqrt(1 - y^2);
/// a square, a product, a square root and a quotient of series in the variable t/scale: O(N^2) products, 3/2 of those
/// of (pendseries). It is exponentially unstable: sqrt(1 - y^2) is 0 at +-i K~' about the top, closer than the
/// singularities of theta, and there the quotient is 0/0; rounding errors do not cancel in it and grow by R/K~' per
/// power. Throws error where cos(theta/2) = 0, at the top of rotation: y = 1 is the branch point of the arcsine,
/// and the quotient is 0/0 there.
template <scalar T>
series::power_series<T> taylor_by_arcsine(const taylor_start<T>& start, int order, const T& scale) {
    require_taylor_order(order);
    const pendulum_state<T>& at = start.state;
    if (binary_exponent(at.half_cosine) == exponent_of_zero) {
        throw error(error_kind::argument, "sin(theta/2)", "",
                    "= 1 at the expansion point: the branch point of the arcsine");
    }
    const series::parity of_y = start.of_theta;
    const series::parity of_even = of_y == series::parity::any ? series::parity::any : series::parity::even;
    const T h = scale * scale;
    const T linear = -(start.pair.energy / 2 + 1) * h;
    const T cubic = h * 2;
    auto y = series::power_series<T>::zero(order + 1);
    auto square = series::power_series<T>::zero(order);
    y[0] = of_y == series::parity::odd ? T(0) : at.half_sine;
    y[1] = of_y == series::parity::even ? T(0) : T(at.half_cosine * at.omega * scale / 2);
    for (int n = 0; n <= order; ++n) {
        if (of_y == series::parity::any || n % 2 == 0) {
            square[n] = square_coefficient(y, n, of_y);
        }
        if (n + 2 <= order && (of_y == series::parity::any || (n % 2 == 0) == (of_y == series::parity::even))) {
            y[n + 2] = (linear * y[n] + cubic * product_coefficient(square, y, n, of_even)) / (n + 1) / (n + 2);
        }
    }
    for (int n = 0; n <= order; ++n) {
        square[n] = -square[n];
    }
    const auto cosine = square_root(square, at.half_cosine, of_even);  // its constant term is not used
    auto a = series::power_series<T>::zero(order);
    auto speed = series::power_series<T>::zero(order);
    a[0] = at.theta;
    for (int n = 0; n + 1 <= order; ++n) {
        if (of_y == series::parity::any || (n % 2 == 0) == (of_y == series::parity::odd)) {
            speed[n] = (y[n + 1] * (2 * (n + 1)) - convolution(cosine, speed, n, 1, n, of_even)) / at.half_cosine;
            a[n + 1] = speed[n] / (n + 1);
        }
    }
    return a;
}

/// Through w = omega, itself a Jacobi function (2k cn or sqrt(2E) dn since the bottom), so that no arcsine is needed:
///     w'' = (E - 1) w - w^3/2,   a_n = w_(n-1)/n.
/// A square and a product: as many as the recurrence of symmetric squares. O(N^2) products.
template <scalar T>
series::power_series<T> taylor_by_speed(const taylor_start<T>& start, int order, const T& scale) {
    require_taylor_order(order);
    const pendulum_state<T>& at = start.state;
    const series::parity of_theta = start.of_theta;
    const series::parity of_even = of_theta == series::parity::any ? series::parity::any : series::parity::even;
    const series::parity of_w = of_theta == series::parity::any   ? series::parity::any
                                : of_theta == series::parity::odd ? series::parity::even
                                                                  : series::parity::odd;
    const T h = scale * scale;
    const T linear = (start.pair.energy - start.pair.gap) / 2 * h;
    auto w = series::power_series<T>::zero(order + 1);
    auto square = series::power_series<T>::zero(order + 1);
    w[0] = of_w == series::parity::odd ? T(0) : T(at.omega * scale);
    w[1] = of_w == series::parity::even ? T(0) : T(-at.sine() * h);
    for (int n = 0; n + 2 <= order; ++n) {
        if (of_w == series::parity::any || n % 2 == 0) {
            square[n] = square_coefficient(w, n, of_w);
        }
        if (of_w == series::parity::any || (n % 2 == 0) == (of_w == series::parity::even)) {
            w[n + 2] = (linear * w[n] - product_coefficient(square, w, n, of_even) / 2) / (n + 1) / (n + 2);
        }
    }
    auto a = series::power_series<T>::zero(order);
    a[0] = at.theta;
    for (int n = 1; n <= order; ++n) {
        a[n] = w[n - 1] / n;
    }
    return a;
}

}  // namespace libration::pendulum
