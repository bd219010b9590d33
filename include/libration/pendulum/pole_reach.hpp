// The distance up to which poles must be summed for a coefficient, the coefficient from which this costs less than the
// method for the preceding ones, and which of two methods computes these.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "libration/pendulum/singularity_view.hpp"
#include "libration/pendulum/tuning.hpp"

namespace libration::pendulum {

/// The distance up to which poles are needed for a_n: omitted ones add less than an eighth of an epsilon of T in
/// 8/(n R^n). 2^(bits/(n-4)) R, bits from (2/n) d^(4-n) S4 <= (8/n) R^-n epsilon/8. n > 4; where it only determines
/// costs, few digits are enough.
template <scalar T>
class pole_reach {
public:
    pole_reach(const singularity_view<T>& view, long precision) : radius_(midpoint(view.radius())) {
        const T square = view.radius() * view.radius();
        bits_ = precision + 3 + std::max(0L, binary_exponent(T(view.fourth_powers() * square * square)));
    }

    long bits() const { return bits_; }
    /// In units of the radius.
    T factor(long n) const {
        using std::exp;
        using std::log;
        return midpoint(T(exp(T(log(T(2)) * T(bits_) / T(n - 4)))));
    }
    T operator()(long n) const { return midpoint(T(radius_ * factor(n))); }

private:
    T radius_;
    long bits_;
};

/// The method for the powers before those of the lattice.
enum class head_by { recurrence, thetas };

/// Whether the quotient of thetas (theta_series.hpp) is cheaper than the recurrence for the powers up to n, on balls or
/// in mpfr with FLINT, as measured about points of symmetry (tuning.hpp). Without symmetry the recurrence costs four
/// times as much, the quotient twice.
template <scalar T>
bool thetas_cost_less(bool symmetric, long n) {
    constexpr bool in_balls = proved_scalar<T>;
    constexpr long power = in_balls ? tuning::thetas_from_power_on_balls : tuning::thetas_from_power_in_mpfr;
    constexpr long bits = in_balls ? tuning::thetas_from_bits_on_balls : tuning::thetas_from_bits_in_mpfr;
    const long weighed = symmetric ? n : 2 * n;
    return weighed >= power && weighed * digits<T>() >= bits;
}

/// The power before which the recurrence costs less in every case, as measured with symmetry (tuning.hpp), a quarter
/// earlier without. The recurrence in double is vectorised.
template <scalar T>
constexpr long least_lattice_power(bool symmetric) {
    long least = 16;
    if constexpr (fixed_scalar<T>) {
        least = digits<T>() <= 53   ? tuning::sums_from_power_in_double
                : digits<T>() <= 64 ? tuning::sums_from_power_in_long_double
                                    : tuning::sums_from_power_in_quad;
    }
    return symmetric ? least : least * 3 / 4;
}

/// The power from which sums over the singularities cost less than the recurrence, or last + 1 if that is smaller:
/// about 2 powers per digit at 50 digits, 0.8 at 1000; `first`, if the powers from there on alone cost less than the
/// recurrence up to it. A step of the recurrence costs 3n/8 products per power (with symmetry, for half of the poles;
/// without it twice as many of both), a coefficient 2 products per pole, and the tables of a pole 180; the poles within
/// reach are about those of half an ellipse in the lattice. A coefficient by the quotient of thetas costs about 120
/// products at any n: it replaces sums over more than 60 poles. An estimate of costs, on which results depend only by
/// rounding.
template <scalar T>
long lattice_begins(const singularity_view<T>& view, long first, long last, head_by head = head_by::recurrence) {
    const long least = least_lattice_power<T>(view.symmetric());
    const long precision = digits<T>();
    const precision_scope rough(20);
    const pole_reach<T> reach(view, precision);
    const T step = narrow<T>(widen(view.lattice().effective_period));
    const T wide = view.lattice().single_column ? T(0) : T(narrow<T>(widen(view.radius())) / step);
    const T tall = narrow<T>(widen(T(view.radius() / view.lattice().height)));
    // Five times their number.
    const auto poles = [&](long n) {
        const T factor = reach.factor(n);
        return midpoint(T((factor * wide + 1) * (factor * tall + 1)));
    };
    const auto cheap = [&](long n) {
        const long most = head == head_by::thetas ? std::min(n, 300L) : n;
        return certainly_less(poles(n), T(most)) && certainly_less(T(poles(n) * 300), T(T(n) * T(n)));
    };
    long below = std::max(least, reach.bits() / 8) - 1;  // reach.factor() remains below 2^8 or so
    if (first > below && certainly_less(T(poles(first) * T(last - first + 180)), T(T(first) * T(first)))) {
        return first;
    }
    long enough = below + 1;
    while (enough <= last && !cheap(enough)) {
        below = enough;
        enough *= 2;
    }
    while (enough - below > 1 && below < last) {
        const long middle = below + (enough - below) / 2;
        (cheap(middle) ? enough : below) = middle;
    }
    return std::min(enough, last + 1);
}

}  // namespace libration::pendulum
