// The scalar `ball`: proved enclosures of any precision through FLINT/Arb [Arb], FLINT 2.9 with Arb 2.23 or FLINT 3. A
// program that includes this header links the CMake target libration::ball; no header outside of scalar/ball*.hpp
// includes it.
//
// Every result contains the exact one, given GMP, MPFR, FLINT/Arb and the compiler, and given that the loops which stop
// early end in enclose(value, bound) with a bound proved in their header. Precision only decides how narrow a result
// is: where it proves too little (a sign, a branch, the digits asked for), precision_exhausted is thrown, and the
// caller repeats with more digits.
#pragma once

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/ball/quotient.hpp"
#include "libration/scalar/enclose.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/exact.hpp"

namespace libration {

template <proved_scalar T>
int digits() {
    return static_cast<int>(T::working_bits());
}

template <proved_scalar T>
T epsilon() {
    return ldexp(T(1), 1 - digits<T>());
}

template <proved_scalar T>
T pi() {
    T result;
    arb_const_pi(result.handle(), T::working_bits());
    return result;
}

/// The value with a radius wider by the largest |bound|.
template <proved_scalar T>
T enclose(const T& value, const T& bound) {
    T result = value;
    arb_add_error(result.handle(), bound.handle());
    return result;
}

/// The e with |x| < 2^e for the whole ball, within a factor of 2 where the ball is narrow; exponent_of_zero for 0
/// alone. Throws precision_exhausted for a ball without bounds.
template <proved_scalar T>
long binary_exponent(const T& x) {
    if (!is_finite(x)) {
        throw precision_exhausted("a size");
    }
    T largest;
    arb_get_abs_ubound_arf(arb_midref(largest.handle()), x.handle(), T::working_bits());
    return arb_is_zero(x.handle()) != 0 ? exponent_of_zero
                                        : static_cast<long>(arf_abs_bound_lt_2exp_si(arb_midref(largest.handle())));
}

/// Balls are their own wide arithmetic: the precision is the scope's.
template <proved_scalar T>
T widen(const T& x) {
    return x;
}

/// The midpoint rounded to the working precision, the radius wider by what that moves it.
template <proved_scalar T>
T narrow(const T& x) {
    T result;
    arb_set_round(result.handle(), x.handle(), T::working_bits());
    return result;
}

template <proved_scalar T>
T sum_of_products(const T* x, int x_step, const T* y, int y_step, int count) {
    static_assert(sizeof(T) == sizeof(arb_struct), "FLINT walks through an array of balls");
    T sum;
    arb_dot(sum.handle(), nullptr, 0, x->handle(), x_step, y->handle(), y_step, count, T::working_bits());
    return sum;
}

template <proved_scalar T>
T midpoint(const T& x) {
    T result;
    arf_set(arb_midref(result.handle()), arb_midref(x.handle()));
    return result;
}

/// Whether every number of a is below every number of b.
template <proved_scalar T>
bool certainly_less(const T& a, const T& b) {
    return arb_lt(a.handle(), b.handle()) != 0;
}

/// An enclosure of the fraction.
template <proved_scalar T>
T from_rational(const rational& q) {
    T result;
    fmpz_t above;
    fmpz_t below;
    fmpz_init(above);
    fmpz_init(below);
    fmpz_set_mpz(above, mpq_numref(q.backend().data()));
    fmpz_set_mpz(below, mpq_denref(q.backend().data()));
    arb_fmpz_div_fmpz(result.handle(), above, below, T::working_bits());
    fmpz_clear(above);
    fmpz_clear(below);
    return result;
}

/// An enclosure of the exact number. Throws error for multiples of the period, which only a motion knows.
template <proved_scalar T>
T from_exact(const exact& number) {
    switch (number.measure) {
        case unit::one: return from_rational<T>(number.coefficient);
        case unit::period:
            throw error(error_kind::argument, "number", number.text, "is a multiple of a period, not a number");
        default: break;
    }
    return from_rational<T>(number.in_pi()) * pi<T>();
}

}  // namespace libration

#include "libration/scalar/concept.hpp"

static_assert(libration::scalar<libration::ball>);
