// The rate of convergence of the uniform resummation.
#pragma once

#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/uniform_remainder.hpp"

namespace libration::pendulum {

/// T*/|(2P+1) T* + i K~'|, the rate of the uniform resummation per power of t.
template <scalar T>
T uniform_convergence_rate(const top_bounds<T>& b, int columns) {
    using std::sqrt;
    const T square = b.effective_period * b.effective_period;
    return b.effective_period / sqrt(square * (4 * columns * (columns + 1)) + b.radius * b.radius);
}

/// Decimal digits by which the error to the power N, P = 1, is below 1: those of its rate, and near E = 2, where the
/// kept columns become the whole motion, the two of exp(-2y). A computation of the error must carry this many digits.
inline long uniform_digits_below(const motion& m, int order) {
    const precision_scope scope(20);
    const energy_level<mpfr> o = energy_level_of<mpfr>(m);
    const mpfr of_rate = -log10(uniform_convergence_rate(top_bounds<mpfr>::of(o), 1)) * (order + 3);
    const mpfr of_gap = half_column_distance(o) * 2 / log(mpfr(10));
    return 20 + static_cast<long>(nearest_integer(mpfr(of_rate + of_gap)));
}

}  // namespace libration::pendulum
