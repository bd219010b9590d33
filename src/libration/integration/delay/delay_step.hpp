// The steps of a solution with delays, which later steps need, in balls or in arithmetic that rounds.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "libration/equation/expression.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/failure.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

// The solution on a step: polynomials about its beginning, and bounds of the rest and of its derivative (theorem M),
// which are 0 in arithmetic that rounds. Of each leaf of the state.
template <field R>
struct delay_step {
    R begins;  // the distance from the beginning of the piece, exact
    R length;
    std::vector<std::vector<R>> series;
    std::vector<magnitude> error, slope_error;
};

// Between two breaking points.
template <field R>
struct delay_piece {
    number begins;
    std::vector<delay_step<R>> steps;
};

inline const ball& as_ball(const ball& x) { return x; }
template <ordered_scalar T>
ball as_ball(const T& x) {
    return ball(widen(x));
}

inline magnitude size_above(const ball& x) { return magnitude(x); }
template <ordered_scalar T>
magnitude size_above(const T& x) {
    return magnitude(as_ball(x));
}

// For choices of steps, on which no proof depends.
inline double rough_value(const ball& x) { return arf_get_d(arb_midref(x.handle()), ARF_RND_NEAR); }
template <ordered_scalar T>
double rough_value(const T& x) {
    return convert<double>(x);
}

// To 30 bits, as an exact number. Throws precision_exhausted for an infinite one.
template <field R>
number rounded_number(const R& x) {
    constexpr int bits = 30;
    const double value = rough_value(x);
    if (!std::isfinite(value)) {
        throw precision_exhausted("a state");
    }
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    const rational power = exponent >= bits ? rational(integer(1) << (exponent - bits))
                                            : rational(integer(1), integer(1) << (bits - exponent));
    return number(rational(static_cast<long>(std::ldexp(mantissa, bits))) * power);
}

// m 2^e, exactly.
inline ball binary_fraction(const ball& /*like*/, int m, int e) {
    ball result(m);
    arb_mul_2exp_si(result.handle(), result.handle(), e);
    return result;
}
template <ordered_scalar T>
T binary_fraction(const T& /*like*/, int m, int e) {
    using std::ldexp;
    return T(ldexp(T(m), e));
}

template <ordered_scalar T>
T exact_sum(const T& a, const T& b) {
    return T(a + b);
}

// One number of x.
inline ball one_of(const ball& x) {
    ball result = x;
    mag_zero(arb_radref(result.handle()));
    return result;
}
template <ordered_scalar T>
T one_of(const T& x) {
    return x;
}

inline ball with_error(const ball& x, const magnitude& by) { return widened(x, by); }
template <ordered_scalar T>
T with_error(const T& x, const magnitude& /*by*/) {
    return x;
}

inline bool certainly_negative(const ball& x) { return arb_is_negative(x.handle()) != 0; }
template <ordered_scalar T>
bool certainly_negative(const T& x) {
    return x < 0;
}

// Negative by more than 2^-44 of a size, or some rounding errors of it: ends of steps that are equal as real numbers
// are rounded in different ways.
inline bool certainly_negative(const ball& x, const ball& size) {
    constexpr long bits = 44;
    const ball least = abs(size);
    return certainly_negative(x + ldexp(least, -bits));
}
template <ordered_scalar T>
bool certainly_negative(const T& x, const T& size) {
    constexpr int roundings = 16;  // of the sums that lead to x
    return x < -roundings * epsilon<T>() * size;
}

// A lower bound of |x|.
inline magnitude size_below(const ball& x) { return magnitude::below(x); }
template <ordered_scalar T>
magnitude size_below(const T& x) {
    return size_above(x);
}

inline bool is_exact_zero(const ball& x) { return arb_is_zero(x.handle()) != 0; }
template <ordered_scalar T>
bool is_exact_zero(const T& x) {
    return x == 0;
}

// A bound of the positive numbers of x; 0 in arithmetic that rounds.
inline magnitude excess_of(const ball& x) {
    if (arb_is_nonpositive(x.handle()) != 0) {
        return {};
    }
    return arb_is_positive(x.handle()) != 0 ? magnitude(x) : magnitude::radius_of(x) + magnitude::radius_of(x);
}
template <ordered_scalar T>
magnitude excess_of(const T& /*x*/) {
    return {};
}

// Horner's rule.
template <field R>
R value_of(const std::vector<R>& a, const R& at) {
    R value = a.back();
    for (std::size_t n = a.size() - 1; n-- > 0;) {
        value = R(value * at + a[n]);
    }
    return value;
}

// The coefficients of a(s + by), by repeated divisions by a linear factor: n^2/2 products.
template <field R>
std::vector<R> shifted(std::vector<R> a, const R& by) {
    for (std::size_t k = 0; k + 1 < a.size(); ++k) {
        for (std::size_t n = a.size() - 1; n-- > k;) {
            a[n] += by * a[n + 1];
        }
    }
    return a;
}

}  // namespace libration::ode
