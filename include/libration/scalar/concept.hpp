// What the mathematics of this library asks of a number type. Everything in series/, approximant/, elliptic/ and
// pendulum/ is written once on a type that models this concept.
#pragma once

#include <cmath>
#include <concepts>

#include "libration/scalar/constants.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/enclose.hpp"
#include "libration/scalar/exact.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

/// A field with the elementary functions (found by unqualified calls after `using std::sin;`), small integers as exact
/// operands, a precision, pi, and enclose(). Order is not asked for: balls have none.
template <class T>
concept scalar = std::copyable<T> && requires(T a, const T b, int n) {
    a = T(n);
    a += b;
    a -= b;
    a *= b;
    a /= b;
    T(-a);
    T(a + b);
    T(a - b);
    T(a * b);
    T(a / b);
    T(a * n);
    T(a / n);
    { digits<T>() } -> std::convertible_to<long>;
    { epsilon<T>() } -> std::convertible_to<T>;
    { pi<T>() } -> std::convertible_to<T>;
    { enclose(b, b) } -> std::convertible_to<T>;
    { binary_exponent(b) } -> std::convertible_to<long>;
    { widen(b) } -> std::convertible_to<wide_t<T>>;
    { narrow<T>(widen(b)) } -> std::convertible_to<T>;
    { from_rational<T>(rational()) } -> std::convertible_to<T>;
};

static_assert(scalar<double> && scalar<long double> && scalar<quad> && scalar<mpfr>);

}  // namespace libration
