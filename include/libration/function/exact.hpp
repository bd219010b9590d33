// Exact values of functions: fractions of 1 and of pi.
#pragma once

#include <optional>

#include "libration/scalar/error.hpp"
#include "libration/scalar/expression.hpp"

namespace libration::function {

using exact_value = std::optional<plain_number>;

/// The fraction that x is, where it is one.
std::optional<rational> fraction_of(const plain_number& x);
/// How many times pi a fraction of pi or of a degree is.
std::optional<rational> times_pi(const plain_number& x);
/// q ones, q times pi.
exact_value ones(const std::optional<rational>& q);
exact_value of_pi(const std::optional<rational>& q);
/// `value` where x is 0.
exact_value at_zero(const plain_number& x, int value);

/// The root of this order of a fraction >= 0, where it is a fraction.
std::optional<rational> exact_root(const rational& q, unsigned long order);
/// n where q = base^n.
std::optional<rational> exact_logarithm(const rational& q, int base);
/// cos(q pi), tan(q pi) and acos(x)/pi where they are rational, which by Niven's theorem they are nowhere else. The
/// tangent throws error at its poles, the arccosine beyond 1.
std::optional<rational> exact_cosine(const rational& times_pi);
std::optional<rational> exact_tangent(const rational& times_pi);
std::optional<rational> exact_arccosine(const rational& x);

/// The largest integer that is not above q.
integer floor_of(const rational& q);
bool is_whole(const rational& q);
/// Of the orders 2k <= n < 2k + 1 and n + 1, the first one.
bool is_first_of_pair(const rational& order);

}  // namespace libration::function
