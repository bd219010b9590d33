// Taylor coefficients of theta(t) about any point of a motion, a_n scale^n, by recurrence.
#pragma once

#include <string>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/symmetric_squares.hpp"
#include "libration/scalar/compiled.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/kernel.hpp"

namespace libration::pendulum {

/// The initial values of the recurrences. The parity is that of theta - theta_0 about the point.
template <scalar T>
struct taylor_start {
    pendulum_state<T> state;
    energy_pair<T> pair;
    series::parity of_theta = series::parity::any;
};

/// The recurrence by which coefficients are computed; the results agree up to rounding.
enum class recurrence {
    symmetric_squares,  ///< cos theta - cos theta_0 and omega: one square and one product
    sine_cosine         ///< sin theta and cos theta [paper (pendseries)]: two products
};

/// The symmetry of theta about a phase: even about the top of libration, odd about every other symmetric point.
template <scalar T>
series::parity parity_about(const motion& m, const phase<T>& p) {
    if (p.side != 0) {
        return series::parity::any;
    }
    const bool at_top = elliptic::quarter_of_four(p.quarter) % 2 != 0;
    return m.regime() == regime::libration && at_top ? series::parity::even : series::parity::odd;
}

/// The initial values at a phase of an exact solution.
template <scalar T>
taylor_start<T> start_at(const exact_solution<T>& solution, const phase<T>& p) {
    return {solution.at(p), energies<T>(solution.of()), parity_about(solution.of(), p)};
}

/// Throws error for a negative order of a Taylor series.
inline void require_taylor_order(int order) {
    if (order < 0) {
        throw error(error_kind::argument, "order", std::to_string(order), "of a Taylor series is negative");
    }
}

/// By (pendseries): a_{n+2} = -s_n / ((n+1)(n+2)) with s = sin theta, c = cos theta from their recurrences, in the
/// variable t/scale. O(N^2) products.
template <scalar T>
series::power_series<T> taylor_by_sine_cosine(const taylor_start<T>& start, int order, const T& scale) {
    require_taylor_order(order);
    const pendulum_state<T>& at = start.state;
    const T scale_squared = scale * scale;
    const series::parity of_slope = opposite(start.of_theta);
    auto a = series::power_series<T>::zero(order);
    auto slope = a;
    auto s = a;
    auto c = a;
    s[0] = at.sine();
    c[0] = at.cosine();
    a[0] = at.theta;
    if (order >= 1) {
        a[1] = at.omega * scale;
    }
    for (int n = 0; n + 2 <= order; ++n) {
        series::slope_kernel(a.data(), slope.data(), n);
        sine_cosine_kernel(slope.data(), s.data(), c.data(), n, of_slope);
        a[n + 2] = -s[n] * scale_squared / (n + 1) / (n + 2);
    }
    return a;
}

/// By symmetric_squares.hpp, in the variable t/scale: a_n = w_{n-1}/n. About a symmetric point D is even and w has one
/// parity: D and w, or w/t, are series in t^2, a quarter of the products of a Cauchy square for D^2 and half of one for
/// D w. O(N^2) products.
template <scalar T>
series::power_series<T> taylor_by_symmetric_squares(const taylor_start<T>& start, int order, const T& scale) {
    require_taylor_order(order);
    const pendulum_state<T>& at = start.state;
    const T sine = at.sine();
    const T cosine = at.cosine();
    const T h = scale * scale;
    const T constant = (sine * sine - cosine * at.omega * at.omega) * h;
    const T linear = (start.pair.gap - start.pair.energy - cosine * 6) * h;
    symmetric_squares<T> squares(order, start.of_theta);
    squares.w[0] = start.of_theta == series::parity::even ? T(-sine * h) : T(at.omega * scale);
    if (start.of_theta == series::parity::any) {
        squares.d[1] = -sine * at.omega * scale;
        squares.w[1] = -sine * h;
    }
    squares.solve(constant, linear, cosine, h);
    auto a = series::power_series<T>::zero(order);
    a[0] = at.theta;
    for (int j = 0, n = squares.first() + 1; n <= order; ++j, n += squares.step()) {
        a[n] = squares.w[j] / n;
    }
    return a;
}

/// The coefficients a_n scale^n, n = 0 .. N, of theta from its initial values. With a scale near the radius of
/// convergence they remain between powers of n; a_n itself leaves the range of double before N = 1000. Relative to
/// 8/(n R^n) the error grows slowly with n: about 20 bits by N = 4000. Throws error when N < 0.
template <scalar T>
series::power_series<T> taylor_coefficients(const taylor_start<T>& start, int order, const T& scale,
                                            recurrence by = recurrence::symmetric_squares) {
    return by == recurrence::sine_cosine ? taylor_by_sine_cosine(start, order, scale)
                                         : taylor_by_symmetric_squares(start, order, scale);
}

// Compiled once, in libration::libration.
#ifdef LIBRATION_COMPILED
#define LIBRATION_DECLARE(T)                                                                                    \
    extern template series::power_series<T> taylor_by_sine_cosine(const taylor_start<T>&, int, const T&);       \
    extern template series::power_series<T> taylor_by_symmetric_squares(const taylor_start<T>&, int, const T&); \
    extern template taylor_start<T> start_at(const exact_solution<T>&, const phase<T>&);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DECLARE)
#undef LIBRATION_DECLARE
#endif

}  // namespace libration::pendulum
