// The energy of a motion as a well-conditioned pair, and the modulus and time scale that follow from it.
#pragma once

#include <string>

#include "libration/elliptic/modulus.hpp"
#include "libration/pendulum/motion.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// E and 2-E, both to full relative precision: near E = 2 the second carries all the digits of the period, which a
/// single number for E has lost.
template <scalar T>
struct energy_pair {
    T energy;
    T gap;  ///< 2 - E
};

/// Throws error for a value that T cannot represent: one that becomes zero or infinite in T.
template <scalar T>
void require_in_range(const wide_t<T>& value, const char* what) {
    const long exponent = binary_exponent(value);
    if (exponent != exponent_of_zero && !holds_exponent<T>(exponent)) {
        throw error(error_kind::range, what, "", "is outside the range of this scalar");
    }
}

/// E = 1 - cos theta0 + omega0^2/2 and 2-E = 1 + cos theta0 - omega0^2/2 of the motion (dimensionless, units of m g l),
/// computed with as many extra digits as the motion cancels. Within an ulp. Throws error of the kind range if E or 2-E
/// is below the range of a fixed scalar.
template <scalar T>
energy_pair<T> energies(const motion& m) {
    using W = wide_t<T>;
    using std::cos;
    W energy;
    W gap;
    {
        const precision_scope scope(decimal_digits(digits<T>() + m.condition_bits() + 64));
        if (m.energy()) {
            energy = from_rational<W>(*m.energy());
            gap = from_rational<W>(rational(2 - *m.energy()));
        } else if (m.exact_energy()) {
            energy = from_exact<W>(*m.exact_energy());
            gap = from_exact<W>(*m.exact_gap());
        } else {
            const W kinetic = from_rational<W>(rational(*m.omega0_squared() / 2));
            const W cosine = cos(from_exact<W>(*m.theta0()));
            energy = 1 - cosine + kinetic;
            gap = 1 + cosine - kinetic;
        }
    }
    require_in_range<T>(energy, "the energy E");
    require_in_range<T>(gap, "the gap 2 - E");
    return {narrow<T>(energy), narrow<T>(gap)};
}

/// The common data of all formulas of a motion: the pair (E, 2-E), the modulus, and the rate that converts time to the
/// argument of the elliptic functions. Not for E = 2.
///   libration  k^2 = E/2,  k'^2 = (2-E)/2,  u = t
///   rotation   k^2 = 2/E,  k'^2 = (E-2)/E,  u = t sqrt(E/2)
template <scalar T>
struct energy_level {
    pendulum::regime regime;
    energy_pair<T> pair;
    elliptic::modulus<T> modulus;
    T time_scale;
};

/// Throws error at E = 2, where there is no modulus below 1.
template <scalar T>
energy_level<T> energy_level_of(const motion& m) {
    using std::sqrt;
    if (at_critical_energy(m.regime())) {
        throw error(error_kind::argument, error_subject::energy, "2", "makes the period infinite");
    }
    energy_pair<T> pair = energies<T>(m);
    if (m.regime() == regime::rotation) {
        const T k = sqrt(2 / pair.energy);
        const T complement = sqrt(-pair.gap / pair.energy);
        T rate = sqrt(pair.energy / 2);
        return {m.regime(), std::move(pair), elliptic::modulus<T>::from_both(k, complement), std::move(rate)};
    }
    const T k = sqrt(pair.energy / 2);
    const T complement = sqrt(pair.gap / 2);
    return {m.regime(), std::move(pair), elliptic::modulus<T>::from_both(k, complement), T(1)};
}

/// Seconds per unit of dimensionless time, sqrt(length/gravity); 1 if no units were given.
template <scalar T>
T time_unit(const motion& m) {
    using std::sqrt;
    const exact& squared_frequency = m.squared_frequency();
    if (!squared_frequency.is_fraction()) {
        return 1 / sqrt(from_exact<T>(squared_frequency));
    }
    return squared_frequency.coefficient == 1 ? T(1)
                                              : T(sqrt(from_rational<T>(rational(1 / squared_frequency.coefficient))));
}

}  // namespace libration::pendulum
