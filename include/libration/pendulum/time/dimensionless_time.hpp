// An exact time as a number.
#pragma once

#include "libration/pendulum/energy/period.hpp"

namespace libration {

/// t sqrt(gravity/length): the typed time in units of sqrt(length/gravity), which are 1 where no units were given; T in
/// it is the exact period. A few units in the last place. Throws error for a multiple of T at E = 2.
template <scalar T>
T dimensionless_time(const motion& m, const exact& time) {
    if (time.measure != unit::period) {
        return from_exact<T>(time) / time_unit<T>(m);
    }
    if (time.is_zero()) {
        return T(0);
    }
    const rational quarters = time.coefficient * quarters_per_period(m.regime());
    return effective_period(orbit_of<T>(m)) * from_rational<T>(quarters);
}

/// t/T, exact where the time was typed as a multiple of T. Throws error at E = 2.
template <scalar T>
T elapsed_periods(const motion& m, const exact& time) {
    if (time.measure == unit::period) {
        return from_rational<T>(time.coefficient);
    }
    return dimensionless_time<T>(m, time) / (effective_period(orbit_of<T>(m)) * quarters_per_period(m.regime()));
}

}  // namespace libration
