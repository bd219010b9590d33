// The series from the top and its resummation on the fundamental interval, t = x T* with x in [0, 1].
#pragma once

#include <vector>

#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/approximant/truncated_series.hpp"
#include "libration/pendulum/taylor/expansion.hpp"
#include "libration/scalar/compiled.hpp"

namespace libration::pendulum {

/// The canonical motion on its way from the top down to the bottom: libration from (theta_max, 0) to (0, -sqrt(2E)),
/// rotation counterclockwise from (pi, sqrt(2E-4)) to (2 pi, sqrt(2E)). All other motions are its mirror images and
/// shifts [paper (seriesfixed), with the sign of (omegab) as it must be for a bob that falls].
template <scalar T>
struct fundamental_arc {
    energy_level<T> level;
    T effective_period;
    pendulum_state<T> top;
    series::jet<T> bottom;  ///< theta* and omega*
    motion of;              ///< whose fundamental arc it is: what is changed above is seen by the recurrences alone
};

/// With the T* of a rule that is not exact, what is made of the fundamental arc is what the paper's formulas make with
/// that T*: the resummation has theta* and omega* there, though the motion has them at another time.
/// Throws error at E = 2.
template <scalar T>
fundamental_arc<T> arc_of(const motion& m, const period_rule& by = {}) {
    using std::atan2;
    const energy_level<T> o = energy_level_of<T>(m);
    const T duration = effective_period_by(by, o);
    if (m.regime() == regime::rotation) {
        const T slowest = o.time_scale * o.modulus.complement * 2;
        return {o, duration, {pi<T>(), slowest, T(1), T(0)}, {pi<T>() * 2, o.time_scale * 2}, m};
    }
    const T highest = atan2(o.modulus.k, o.modulus.complement) * 2;
    return {o, duration, {highest, T(0), o.modulus.k, o.modulus.complement}, {T(0), -o.modulus.k * 2}, m};
}

/// a_n T*^n, n = 0 .. N, about the top, by a recurrence alone.
template <scalar T>
series::power_series<T> arc_series(const fundamental_arc<T>& d, int order, recurrence by) {
    const series::parity of_theta = d.level.regime == regime::rotation ? series::parity::odd : series::parity::even;
    return taylor_coefficients(taylor_start<T>{d.top, d.level.pair, of_theta}, order, d.effective_period, by);
}

/// a_n T*^n, n = 0 .. N, about the top: in mpfr and on balls by the cheapest way (coefficients_about), which knows them
/// up to the turns and the direction of the motion. The fixed scalars keep to the recurrence, whose rounding is what is
/// asked of them.
template <scalar T>
series::power_series<T> arc_series(const fundamental_arc<T>& d, int order) {
    if constexpr (fixed_scalar<T>) {
        return arc_series(d, order, recurrence::symmetric_squares);
    } else {
        require_taylor_order(order);
        const exact_solution<T> solution(d.of);
        series::power_series<T> a(coefficients_about(solution, expansion_point(), d.effective_period, 0, order));
        a[0] = d.top.theta;
        if (d.level.regime == regime::rotation && d.of.direction() < 0) {
            for (int n = 1; n <= order; ++n) {
                a[n] = -a[n];
            }
        }
        return a;
    }
}

/// The data of the resummation at x = 1: theta* and omega* T*.
template <scalar T>
std::vector<T> arc_endpoint(const fundamental_arc<T>& d) {
    return {d.bottom.value, d.bottom.slope * d.effective_period};
}

/// sigma_N as a function of x [paper (seriesfixed)]: error decays like rho^N, rho = T*/R.
template <scalar T>
truncated_series<T> series_from_top(const fundamental_arc<T>& d, int order) {
    return {arc_series(d, order), T(1)};
}

/// theta_N as a function of x [paper (fullresummation), (efficient)]: theta* + omega*(t-T*) + (t-T*)^2 sum a-hat_n t^n,
/// a polynomial of degree N + 2 that has the value and the slope of theta at T*. Same rate rho as the series; the norm
/// of its error gains about N^2.
template <scalar T>
endpoint_approximant<T> resummation_from_top(const fundamental_arc<T>& d, int order) {
    return {arc_series(d, order), arc_endpoint(d)};
}

// Compiled once, in libration::libration.
#ifdef LIBRATION_COMPILED
#define LIBRATION_DECLARE(T)                                                                        \
    extern template fundamental_arc<T> arc_of(const motion&, const period_rule&);                   \
    extern template series::power_series<T> arc_series(const fundamental_arc<T>&, int, recurrence); \
    extern template series::power_series<T> arc_series(const fundamental_arc<T>&, int);             \
    extern template endpoint_approximant<T> resummation_from_top(const fundamental_arc<T>&, int);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DECLARE)
#undef LIBRATION_DECLARE
#endif

}  // namespace libration::pendulum
