// An exact time as a number.
#pragma once

#include "libration/pendulum/period.hpp"

namespace libration::pendulum {

/// t sqrt(gravity/length): the given time in units of sqrt(length/gravity), which are 1 if no units were given; T in
/// it is the exact period. A few units in the last place. Throws error for a multiple of T at E = 2.
template <scalar T>
T dimensionless_time(const motion& m, const exact& time) {
    if (!time.has_periods()) {
        return from_exact<T>(time) / time_unit<T>(m);
    }
    if (time.is_zero()) {
        return T(0);
    }
    const rational quarters = time.periods() * quarters_per_period(m.regime());
    const T whole = effective_period(energy_level_of<T>(m)) * from_rational<T>(quarters);
    return time.only_periods() ? whole : T(whole + from_exact<T>(time.without_periods()) / time_unit<T>(m));
}

/// t/T, exact if the time was given as a multiple of T. Throws error at E = 2.
template <scalar T>
T elapsed_periods(const motion& m, const exact& time) {
    if (time.only_periods()) {
        return from_rational<T>(time.coefficient);
    }
    if (time.has_periods()) {
        return from_rational<T>(time.periods()) + elapsed_periods<T>(m, time.without_periods());
    }
    return dimensionless_time<T>(m, time) / (effective_period(energy_level_of<T>(m)) * quarters_per_period(m.regime()));
}

}  // namespace libration::pendulum
