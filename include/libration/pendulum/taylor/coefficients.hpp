// Taylor coefficients of theta(t) about any point of a motion, a_n scale^n, by recurrence.
#pragma once

#include <string>

#include "libration/pendulum/solution/exact_solution.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/exponential.hpp"

namespace libration {

/// What the recurrences start from. The parity is that of theta - theta_0 about the point.
template <scalar T>
struct taylor_start {
    pendulum_state<T> state;
    energy_pair<T> pair;
    parity of_theta = parity::any;
};

/// Which recurrence makes the coefficients; the results agree to rounding.
enum class recurrence {
    symmetric_squares,  ///< cos theta - cos theta_0 and omega: one square and one product
    sine_cosine         ///< sin theta and cos theta [paper (pendseries)]: two products
};

/// The symmetry of theta about a phase: even about the top of libration, odd about every other symmetric point.
template <scalar T>
parity parity_about(const motion& m, const phase<T>& p) {
    if (p.side != 0) {
        return parity::any;
    }
    const bool at_top = quarter_of_four(p.quarter) % 2 != 0;
    return m.regime() == regime::libration && at_top ? parity::even : parity::odd;
}

/// The start at a phase of an exact solution.
template <scalar T>
taylor_start<T> start_at(const exact_solution<T>& solution, const phase<T>& p) {
    return {solution.at(p), energies<T>(solution.of()), parity_about(solution.of(), p)};
}

/// Refuses a negative order of a Taylor series.
inline void require_taylor_order(int order) {
    if (order < 0) {
        throw error(error_kind::argument, "order", std::to_string(order), "of a Taylor series is negative");
    }
}

/// By (pendseries): a_{n+2} = -s_n / ((n+1)(n+2)) with s = sin theta, c = cos theta from their recurrences, in the
/// variable t/scale. O(N^2) products.
template <scalar T>
power_series<T> taylor_by_sine_cosine(const taylor_start<T>& start, int order, const T& scale) {
    require_taylor_order(order);
    const pendulum_state<T>& at = start.state;
    const T scale_squared = scale * scale;
    sine_cosine_recurrence<T> recurrence(at.sine(), at.cosine(), start.of_theta);
    auto a = power_series<T>::zero(order);
    a[0] = at.theta;
    if (order >= 1) {
        a[1] = at.omega * scale;
    }
    for (int n = 0; n + 2 <= order; ++n) {
        recurrence.next(a[n]);
        a[n + 2] = -recurrence.sine()[n] * scale_squared / (n + 1) / (n + 2);
    }
    return a;
}

/// With D = cos theta - cos theta_0 and w = omega (both in the variable t/scale):
///     D'' = A + B D - 3 D^2,  A = sin^2 theta_0 - cos theta_0 omega_0^2,  B = 2(1-E) - 6 cos theta_0,
///     w'' = -(cos theta_0 + D) w,   a_n = w_{n-1}/n.
/// D'' follows from omega^2 = 2(E - 1 + cos theta); the shift by cos theta_0 keeps the digits that 1 - 2(E-1)C - 3C^2
/// cancels near E = 0 and 2. About a symmetric point D is even and w has one parity: D and w, or w/t, are series in
/// t^2, a quarter of the products of a Cauchy square for D^2 and half of one for D w. O(N^2) products.
template <scalar T>
power_series<T> taylor_by_symmetric_squares(const taylor_start<T>& start, int order, const T& scale) {
    require_taylor_order(order);
    const pendulum_state<T>& at = start.state;
    const T sine = at.sine();
    const T cosine = at.cosine();
    const T h = scale * scale;
    const T constant = (sine * sine - cosine * at.omega * at.omega) * h;
    const T linear = (start.pair.gap - start.pair.energy - cosine * 6) * h;
    const int step = start.of_theta == parity::any ? 1 : 2;    // coefficient j of D is that of t^(step j)
    const int first = start.of_theta == parity::even ? 1 : 0;  // and j of w that of t^(first + step j)
    const int second = 2 / step;                               // how far the second derivative is ahead

    auto d = power_series<T>::zero(order / step + second);
    auto w = power_series<T>::zero(order / step + second);
    w[0] = first == 1 ? T(-sine * h) : T(at.omega * scale);
    if (step == 1) {
        d[1] = -sine * at.omega * scale;
        w[1] = -sine * h;
    }
    for (int j = 0, n = 0; n + 2 <= order; ++j, n += step) {
        const T forcing = n == 0 ? constant : T(0);
        d[j + second] = (forcing + linear * d[j] - square_coefficient(d, j) * 3 * h) / (n + 1) / (n + 2);
    }
    for (int j = 0, n = first; n + 2 <= order; ++j, n += step) {
        w[j + second] = -(cosine * w[j] + product_coefficient(d, w, j)) * h / (n + 1) / (n + 2);
    }
    auto a = power_series<T>::zero(order);
    a[0] = at.theta;
    for (int j = 0, n = first + 1; n <= order; ++j, n += step) {
        a[n] = w[j] / n;
    }
    return a;
}

/// The coefficients a_n scale^n, n = 0 .. N, of theta about a start. A scale next to the radius of convergence keeps
/// them between powers of n; a_n itself leaves the range of double before N = 1000. Relative to 8/(n R^n) the error
/// grows slowly with n: about 20 bits by N = 4000. Throws error when N < 0.
template <scalar T>
power_series<T> taylor_coefficients(const taylor_start<T>& start, int order, const T& scale,
                                    recurrence by = recurrence::symmetric_squares) {
    return by == recurrence::sine_cosine ? taylor_by_sine_cosine(start, order, scale)
                                         : taylor_by_symmetric_squares(start, order, scale);
}

}  // namespace libration
