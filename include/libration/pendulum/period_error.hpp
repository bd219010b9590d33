// The truncation error of the partial sums (Kold) and (Knew) of T*: proved bounds, and the digits needed to resolve it.
#pragma once

#include <algorithm>

#include "libration/pendulum/period.hpp"

namespace libration::pendulum {

/// Bound of T* - effective_period_by(rule, o), which is never negative: the bounds of complete_integral_series.hpp over
/// the rate; 0 for the mean, which has no order. At most 1.4 times the truncation error. O(N).
template <scalar T>
T effective_period_bound(const period_rule& rule, const energy_level<T>& o) {
    switch (rule.method) {
        case period_method::series: return complete_integral_series_bound(o.modulus, rule.order) / o.time_scale;
        case period_method::resummed: return complete_integral_resummed_bound(o.modulus, rule.order) / o.time_scale;
        case period_method::agm: break;
    }
    return T(0);
}

/// Decimal digits by which the error of (Knew), the smaller of the two, is below T* at this order: the digits that a
/// computation must carry in addition to those wanted in the error. Two more cover the ratio of bound to error and
/// rounding.
inline long period_digits_below(const motion& m, int order) {
    const precision_scope scope(20);
    const energy_level<mpfr> o = energy_level_of<mpfr>(m);
    const mpfr bound = effective_period_bound(period_rule{period_method::resummed, order}, o);
    return std::max(0L, 2 + static_cast<long>(nearest_integer(mpfr(log10(effective_period(o) / bound)))));
}

}  // namespace libration::pendulum
