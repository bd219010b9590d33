// The period T and the effective period T* of a motion [paper (T), (Tstar)], dimensionless.
#pragma once

#include <string_view>

#include "libration/elliptic/complete_integral.hpp"
#include "libration/elliptic/complete_integral_series.hpp"
#include "libration/pendulum/energy.hpp"

namespace libration::pendulum {

/// T* = K(k)/rate: a quarter of the period below E = 2, half of it above. A few units in the last place.
template <scalar T>
T effective_period(const energy_level<T>& o) {
    return complete_integral(o.modulus) / o.time_scale;
}

/// T*, from (Kold) truncated after k^(2N).
template <scalar T>
T effective_period_series(const energy_level<T>& o, int order) {
    return complete_integral_series(o.modulus, order) / o.time_scale;
}

/// T*, from (Knew) truncated after k^(2N).
template <scalar T>
T effective_period_resummed(const energy_level<T>& o, int order) {
    return complete_integral_resummed(o.modulus, order) / o.time_scale;
}

/// Methods for T*: the arithmetic-geometric mean, or a partial sum of (Kold) or (Knew) up to k^(2N).
enum class period_method { agm, series, resummed };

/// agm | series | resummed.
constexpr std::string_view name_of(period_method method) {
    return method == period_method::agm ? "agm" : method == period_method::series ? "series" : "resummed";
}

/// A method for T* with its order N, which the mean ignores.
struct period_rule {
    period_method method = period_method::agm;
    int order = 0;
};

/// T* by a rule.
template <scalar T>
T effective_period_by(const period_rule& rule, const energy_level<T>& o) {
    switch (rule.method) {
        case period_method::series: return effective_period_series(o, rule.order);
        case period_method::resummed: return effective_period_resummed(o, rule.order);
        case period_method::agm: break;
    }
    return effective_period(o);
}

/// The number of T* in a period: 4 for libration (and the limit E = 0), 2 for rotation.
constexpr int quarters_per_period(regime r) { return r == regime::rotation ? 2 : 4; }

/// K~' = K'(k)/rate, the height of the singularities above the real time axis. Throws error at E = 0, where
/// it is infinite.
template <scalar T>
T singularity_height(const energy_level<T>& o) {
    return complete_integral(o.modulus.swapped()) / o.time_scale;
}

}  // namespace libration::pendulum
