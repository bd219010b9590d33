// The properties of a number type that the library needs in addition to its operators: its precision, its pi, the
// conversion of exact numbers, whether its results are proved. A type is added by specialising scalar_traits, as with
// std::numeric_limits and Eigen's NumTraits; the functions digits<T>(), epsilon<T>(), pi<T>(), enclose(), ... called by
// the mathematics forward to it. No header of the library therefore has to be included after that of the type, and
// there is no list of types.
#pragma once

#include <cmath>
#include <concepts>

#include "libration/scalar/mpfr.hpp"

namespace libration {

/// A specialisation has
///     static constexpr bool fixed           whether the precision is part of the type
///     static constexpr bool proved          whether every result contains the exact one (balls, intervals)
///     static int digits()                   significand bits of a new value
///     static T epsilon()                    2^(1 - digits)
///     static T pi()
///     static T from_rational(const rational&)
///     static long binary_exponent(const T&) the e with 2^(e-1) <= |x| < 2^e, exponent_of_zero for 0
///     static bool holds_exponent(long e)    whether T has numbers of this binary exponent, at full precision
///     static T enclose(const T& value, const T& bound)     all numbers within |bound| of the value, where T can
///     static T midpoint(const T&)           an exact number close to x
///     static bool certainly_less(const T& a, const T& b)
///     using wide; static wide widen(const T&); static T narrow(const wide&)
///                                           the arithmetic used where T has too few digits, with conversions
/// default_scalar_traits<T> has the common part of most types: derive from it, then digits, pi, from_rational and
/// binary_exponent remain. If a type has faster operations than the loops of the library, also
///     static void add_product(T& sum, const T& a, const T& b)                 sum += a b with one rounding
///     static void horner_step(T& sum, const T& x, const T& next)              sum = sum x + next with two roundings
///     static T sum_of_products(const T* x, int x_step, const T* y, int y_step, int count), count > 0
///     static std::vector<T> whole_product(const std::vector<T>& a, const std::vector<T>& b)
///     static std::vector<T> whole_quotient(const std::vector<T>& a, const std::vector<T>& b)
/// of which any type may have any, including a ring that is not a scalar.
template <class T>
struct scalar_traits;

/// A type that has specialised scalar_traits as a scalar.
template <class T>
concept has_scalar_traits = requires {
    { scalar_traits<T>::digits() } -> std::convertible_to<long>;
    { scalar_traits<T>::fixed } -> std::convertible_to<bool>;
    { scalar_traits<T>::proved } -> std::convertible_to<bool>;
};

/// A scalar whose results contain the true value: a ball, an interval.
template <class T>
concept proved_scalar = has_scalar_traits<T> && scalar_traits<T>::proved;

/// A scalar that rounds, without proof.
template <class T>
concept rounding_scalar = has_scalar_traits<T> && !scalar_traits<T>::proved;

/// A rounding scalar whose precision is part of its type.
template <class T>
concept fixed_scalar = rounding_scalar<T> && scalar_traits<T>::fixed;

/// The value of binary_exponent() for 0: below the exponent of every other number.
inline constexpr long exponent_of_zero = -(1L << 61);

/// Common part of most types: computed values are treated as exact, exponents are unlimited, and the type is its own
/// wide arithmetic.
template <class T>
struct default_scalar_traits {
    static constexpr bool fixed = false;
    static constexpr bool proved = false;
    using wide = T;

    static T epsilon() {
        using std::ldexp;
        return ldexp(T(1), 1 - scalar_traits<T>::digits());
    }
    static bool holds_exponent(long /*exponent*/) { return true; }
    static T enclose(const T& value, const T& /*bound*/) { return value; }
    static T midpoint(const T& x) { return x; }
    static bool certainly_less(const T& a, const T& b) { return a < b; }
    static T widen(const T& x) { return x; }
    static T narrow(const T& x) { return x; }
};

/// The arithmetic used instead of T where T itself has too few digits (for example for a huge time): mpfr for rounding
/// scalars.
template <class T>
using wide_t = typename scalar_traits<T>::wide;

}  // namespace libration
