// The requirements of this library on number types: everything in series/ is written once on a ring or a field,
// everything in approximant/, elliptic/ and pendulum/ on a scalar.
#pragma once

#include <cmath>
#include <concepts>
#include <type_traits>

#include "libration/scalar/constants.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/enclose.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

/// The minimum requirement for coefficients of power series: sums and products, and small integers as exact operands.
/// The integer types of C++ are excluded: they overflow.
template <class R>
concept ring = std::copyable<R> && !std::is_integral_v<R> && requires(R a, const R b, const R c, int n) {
    R(n);
    a += b;
    a -= b;
    a *= b;
    R(-b);
    R(b + c);
    R(b - c);
    R(b * c);
    R(b * n);
};

/// A ring with quotients: fractions, complex numbers, every scalar.
template <class R>
concept field = ring<R> && requires(R a, const R b, const R c, int n) {
    a /= b;
    R(b / c);
    R(b / n);
};

namespace elementary_functions {

using std::cos;
using std::exp;
using std::log;
using std::sin;
using std::sqrt;

/// The elementary functions, found by unqualified calls after `using std::sin;`.
template <class T>
concept has_functions = requires(const T x) {
    T(sqrt(x));
    T(exp(x));
    T(log(x));
    T(sin(x));
    T(cos(x));
};

using std::atan;
using std::atan2;
using std::cosh;
using std::sinh;
using std::tan;
using std::tanh;

/// Those of closed forms.
template <class T>
concept has_inverse_and_hyperbolic_functions = requires(const T x) {
    T(tan(x));
    T(sinh(x));
    T(cosh(x));
    T(tanh(x));
    T(atan(x));
    T(atan2(x, x));
};

using std::abs;
using std::ldexp;

/// Those of the choice of steps.
template <class T>
concept has_size = requires(const T x, int n) {
    T(abs(x));
    T(ldexp(x, n));
};

}  // namespace elementary_functions

/// A field with the elementary functions that has specialised scalar_traits. No order is required: balls have none.
template <class T>
concept scalar = field<T> && has_scalar_traits<T> && elementary_functions::has_functions<T> &&
    requires(const T x, const wide_t<T> y, const rational q, long exponent) {
    { scalar_traits<T>::epsilon() } -> std::convertible_to<T>;
    { scalar_traits<T>::pi() } -> std::convertible_to<T>;
    { scalar_traits<T>::from_rational(q) } -> std::convertible_to<T>;
    { scalar_traits<T>::binary_exponent(x) } -> std::convertible_to<long>;
    { scalar_traits<T>::holds_exponent(exponent) } -> std::convertible_to<bool>;
    { scalar_traits<T>::enclose(x, x) } -> std::convertible_to<T>;
    { scalar_traits<T>::midpoint(x) } -> std::convertible_to<T>;
    { scalar_traits<T>::certainly_less(x, x) } -> std::convertible_to<bool>;
    { scalar_traits<T>::widen(x) } -> std::convertible_to<wide_t<T>>;
    { scalar_traits<T>::narrow(y) } -> std::convertible_to<T>;
};

/// A scalar for closed forms (elliptic/, pendulum/solution/): small integers on either side of an operator, and more
/// functions.
template <class T>
concept closed_form_scalar = scalar<T> && elementary_functions::has_inverse_and_hyperbolic_functions<T> &&
    requires(const T x, int n) {
    T(x + n);
    T(x - n);
    T(n + x);
    T(n - x);
    T(n / x);
};

/// A scalar for integrations without proof (integration/taylor/taylor_march.hpp): an order, and sizes.
template <class T>
concept ordered_scalar = scalar<T> && rounding_scalar<T> && elementary_functions::has_size<T> &&
    requires(const T x, int n) {
    { x < x } -> std::convertible_to<bool>;
    { x == x } -> std::convertible_to<bool>;
    { x < n } -> std::convertible_to<bool>;
    { x == n } -> std::convertible_to<bool>;
};

static_assert(scalar<double> && scalar<long double> && scalar<quad> && scalar<mpfr>);
static_assert(closed_form_scalar<double> && closed_form_scalar<quad> && closed_form_scalar<mpfr>);
static_assert(ordered_scalar<double> && ordered_scalar<quad> && ordered_scalar<mpfr>);
static_assert(field<rational> && ring<integer> && !scalar<rational>);

}  // namespace libration
