// The series from the top and its resummation on the fundamental interval, t = x T* with x in [0, 1].
#pragma once

#include <vector>

#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/approximant/truncated_series.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/scalar/compiled.hpp"

namespace libration::pendulum {

/// The canonical motion from the top down to the bottom: libration from (theta_max, 0) to (0, -sqrt(2E)),
/// rotation counterclockwise from (pi, sqrt(2E-4)) to (2 pi, sqrt(2E)). All other motions are its mirror images and
/// shifts [paper (seriesfixed), with the sign of (omegab) corrected for a falling bob].
///
/// With the T* of a rule that is not exact, the results are those of the paper's formulas with that T*: the resummation
/// has theta* and omega* there, though the motion has them at another time.
template <scalar T>
class fundamental_arc {
public:
    /// Throws error at E = 2.
    explicit fundamental_arc(const motion& m, const period_rule& by = {})
        : of_(m), level_(energy_level_of<T>(m)), effective_period_(effective_period_by(by, level_)) {
        using std::atan2;
        const T& k = level_.modulus.k;
        const T& complement = level_.modulus.complement;
        if (m.regime() == regime::rotation) {
            top_ = {pi<T>(), level_.time_scale * complement * 2, T(1), T(0)};
            bottom_ = {pi<T>() * 2, level_.time_scale * 2};
        } else {
            top_ = {atan2(k, complement) * 2, T(0), k, complement};
            bottom_ = {T(0), -k * 2};
        }
    }

    /// The motion whose arc it is.
    const motion& of() const { return of_; }
    const energy_level<T>& level() const { return level_; }
    /// T*, dimensionless.
    const T& effective_period() const { return effective_period_; }
    const pendulum_state<T>& top() const { return top_; }
    /// theta* and omega*.
    const series::jet<T>& bottom() const { return bottom_; }

    /// The initial values of the recurrences about the top.
    taylor_start<T> start() const {
        const bool rotates = level_.regime == regime::rotation;
        return {top_, level_.pair, rotates ? series::parity::odd : series::parity::even};
    }

private:
    motion of_;
    energy_level<T> level_;
    T effective_period_;
    pendulum_state<T> top_;
    series::jet<T> bottom_;
};

template <scalar T>
fundamental_arc<T> arc_of(const motion& m, const period_rule& by = {}) {
    return fundamental_arc<T>(m, by);
}

/// a_n T*^n, n = 0 .. N, about the top, by a recurrence alone.
template <scalar T>
series::power_series<T> arc_series(const fundamental_arc<T>& arc, int order, recurrence by) {
    return taylor_coefficients(arc.start(), order, arc.effective_period(), by);
}

/// a_n T*^n, n = 0 .. N, about the top: in mpfr and on balls by the cheapest method (coefficients_about), which
/// computes them up to the turns and the direction of the motion. The fixed scalars use the recurrence, whose rounding
/// is the object of study there.
template <scalar T>
series::power_series<T> arc_series(const fundamental_arc<T>& arc, int order) {
    if constexpr (fixed_scalar<T>) {
        return arc_series(arc, order, recurrence::symmetric_squares);
    } else {
        require_taylor_order(order);
        const exact_solution<T> solution(arc.of());
        series::power_series<T> a(coefficients_about(solution, expansion_point(), arc.effective_period(), 0, order));
        a[0] = arc.top().theta;
        if (arc.level().regime == regime::rotation && arc.of().direction() < 0) {
            for (int n = 1; n <= order; ++n) {
                a[n] = -a[n];
            }
        }
        return a;
    }
}

/// The data of the resummation at x = 1: theta* and omega* T*.
template <scalar T>
std::vector<T> arc_endpoint(const fundamental_arc<T>& arc) {
    return {arc.bottom().value, arc.bottom().slope * arc.effective_period()};
}

/// sigma_N as a function of x [paper (seriesfixed)]: the error decreases like rho^N, rho = T*/R.
template <scalar T>
truncated_series<T> series_from_top(const fundamental_arc<T>& arc, int order) {
    return {arc_series(arc, order), T(1)};
}

/// theta_N as a function of x [paper (fullresummation), (efficient)]: theta* + omega*(t-T*) + (t-T*)^2 sum a-hat_n t^n,
/// a polynomial of degree N + 2 that has the value and the slope of theta at T*. Same rate rho as the series; the norm
/// of its error gains about N^2.
template <scalar T>
endpoint_approximant<T> resummation_from_top(const fundamental_arc<T>& arc, int order) {
    return {arc_series(arc, order), arc_endpoint(arc)};
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
