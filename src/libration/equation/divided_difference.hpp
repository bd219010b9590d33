// Functions of one expression u of an equation, divided exactly by u - u0.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// A sum of constant multiples of other expressions, and a constant.
struct linear_sum {
    std::vector<std::pair<expression, number>> terms;
    number constant;
};

/// std::nullopt for more than 32 terms or 500 nodes.
std::optional<linear_sum> linear_sum_of(const expression& e);

/// A number that is decided to be 0; false if it is not decided.
bool is_proved_zero(const number& x);

/// Expressions as functions of u, the terms of a linear form. Every operation returns std::nullopt for an expression that
/// is not such a function, is too large, or contains a function that is not supported.
class function_of_one {
public:
    explicit function_of_one(linear_sum u);

    /// a and b if the expression is a u + b.
    std::optional<std::pair<number, number>> affine(const expression& e);
    /// Whether it is a function of u alone.
    bool holds(const expression& e);
    /// Its value at u = u0, exactly; std::nullopt if it has none there, too.
    std::optional<number> value(const expression& e, const number& u0);
    /// (e(u) - e(u0))/(u - u0), as an expression without a division by u - u0 that is analytic at u0 if e is, and that has
    /// a value only where e has one:
    ///     (a b - a0 b0) = (a - a0) b + a0 (b - b0), (a/b - a0/b0) = ((a - a0) - (a0/b0)(b - b0))/b,
    ///     f(a) - f(a0) = (a - a0) times, with h = a - a0,
    ///         exp(a0) exprel(1, h), 1/(a0 exprel(1, log a - log a0)) for log, 1/(sqrt(a) + sqrt(a0)),
    ///         cos((a + a0)/2) sinc(h/2) for sin, -sin((a + a0)/2) sinc(h/2) for cos, sinc(h)/(cos(a) cos(a0)) for tan,
    ///         exp(-w0)/(exp(v) + w0 exprel(1, v)) for w = lambertw(a), v = w - w0,
    /// and likewise for the hyperbolic functions with sinhc(h) = exp(-h) exprel(1, 2 h); for the inverse functions, erf not
    /// among them, at a0 = 0 by the same formula for v = atan(a), a = tan(v).
    std::optional<expression> difference(const expression& e, const number& u0);

private:
    bool spent();
    std::optional<expression> of_product(const expression& e, const number& u0);
    std::optional<expression> of_quotient(const expression& e, const number& u0);
    std::optional<expression> of_power(const expression& e, const number& u0);
    std::optional<expression> of_function(const expression& e, const number& u0);

    linear_sum u_;
    int budget_ = 4000;
};

}  // namespace libration::ode
