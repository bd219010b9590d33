// Zeros of functions of the time alone at numbers that are known exactly, of any order.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/expression.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// Numbers in a ball, each with the least denominator: a fraction, and a fraction of pi.
std::vector<number> simple_numbers_in(const ball& times);

/// Whether a function of the variable alone is 0 at this number, by exact arithmetic; false also if that is not decided.
bool is_exact_zero(const expression& g, const number& time);

/// A zero of order k at an exact time t0, g(t0) = .. = g^(k-1)(t0) = 0.
struct exact_zero {
    number time;
    int order = 0;
    int sign = 0;  ///< of g^(k), and of g after t0
};

/// A zero of order 2 .. 8 of a function of the variable alone, one of simple_numbers_in of a ball of times or of one that is
/// wider by 2^-16 of it, or 0. g^(k) excludes 0 on the hull of the ball and t0, where t0 is the only zero: g(t) = g^(k)(x) (t -
/// t0)^k/k! with x between t and t0.
std::optional<exact_zero> exact_zero_near(const expression& g, const ball& times);

}  // namespace libration::ode
