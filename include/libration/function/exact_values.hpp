// Exact values of functions: rational multiples of 1 and of pi.
#pragma once

#include <optional>

#include "libration/scalar/error.hpp"
#include "libration/scalar/plain_number.hpp"

namespace libration::function {

using exact_value = std::optional<plain_number>;

/// x as a fraction, if it is one.
std::optional<rational> fraction_of(const plain_number& x);
/// x/pi, if x is a rational multiple of pi or of a degree.
std::optional<rational> times_pi(const plain_number& x);
/// q ones, q times pi.
exact_value ones(const std::optional<rational>& q);
exact_value of_pi(const std::optional<rational>& q);
/// `value` if x is 0.
exact_value at_zero(const plain_number& x, int value);

/// The root of this order of a fraction >= 0, if it is a fraction.
std::optional<rational> exact_root(const rational& q, unsigned long order);
/// n if q = base^n.
std::optional<rational> exact_logarithm(const rational& q, int base);
/// cos(q pi), tan(q pi) and acos(x)/pi if they are rational; Niven's theorem excludes all other cases. The tangent
/// throws error at its poles, the arccosine beyond 1.
std::optional<rational> exact_cosine(const rational& times_pi);
std::optional<rational> exact_tangent(const rational& times_pi);
std::optional<rational> exact_arccosine(const rational& x);

/// The largest integer not above q.
integer floor_of(const rational& q);
bool is_whole(const rational& q);
/// Of the orders 2k <= n < 2k + 1 and n + 1, the first one.
bool is_first_of_pair(const rational& order);

}  // namespace libration::function
