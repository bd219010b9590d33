// Expressions in the independent variable, unknown functions, their derivatives, parameters and exact constants, of
// which differential equations consist. Text and the operators of C++ create the same objects.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/number/exact_real.hpp"

namespace libration::ode {

/// An exact constant: a fraction, a multiple of pi, or a formula of such numbers.
using number = libration::exact_real;

/// re + i im.
struct complex_constant {
    number re;
    number im;
};

/// The kind of a node of an expression.
enum class node_kind { constant, variable, unknown, parameter, sum, product, quotient, power, function };

/// An immutable expression, cheap to copy: a node that shares its subexpressions. Constants are folded exactly during
/// construction (x + 0, 1*x, 0*x, x^1, x - x, 2*(3*x)); nothing else is simplified. A constant factor is the left
/// operand, a constant summand the right one, a division by a constant is a product with its inverse, and a - b is a +
/// (-1)*b. Operations on constants throw libration::error as those on numbers do: a division by an exact 0, a function
/// outside its domain.
class expression {
public:
    /// 0.
    expression();
    expression(int n) : expression(number(rational(n))) {}
    expression(const rational& q) : expression(number(q)) {}
    expression(const number& value);

    node_kind kind() const;
    /// The value of a constant.
    const number& constant() const;
    /// The name of an unknown or a parameter.
    const std::string& name() const;
    /// The order of the derivative of an unknown: 0 for the unknown itself.
    int derivative() const;
    /// The kind of a function.
    function_kind function() const;
    /// The operands: the argument of a function is the left one, base and exponent of a power are left and right.
    const expression& left() const;
    const expression& right() const;
    /// Whether it is a function with an order, right(), which is a constant or contains parameters whose values are set
    /// later.
    bool has_order() const;
    /// The order; 0 for a function without one. Throws error if it contains parameters.
    rational order() const;

    /// Whether the variable, an unknown, a parameter occurs in it.
    bool has_variable() const;
    bool has_unknowns() const;
    bool has_parameters() const;
    /// Whether neither the variable nor an unknown occurs.
    bool is_constant() const { return !has_variable() && !has_unknowns(); }
    /// Whether it is this integer.
    bool is(int n) const;
    /// Its value if it is a fraction; std::nullopt otherwise.
    std::optional<rational> fraction() const;
    /// Whether it is a product made by unfolded_zero().
    bool is_unfolded_zero() const { return kind() == node_kind::product && left().is(0); }

    /// Equal for equal forms; collisions of other forms are rare.
    std::size_t hash() const;
    /// The same only for copies of one object.
    const void* identity() const { return node_.get(); }

    expression operator-() const;
    friend expression operator+(const expression& a, const expression& b);
    friend expression operator-(const expression& a, const expression& b) { return a + -b; }
    friend expression operator*(const expression& a, const expression& b);
    friend expression operator/(const expression& a, const expression& b);
    /// 0*e as a product, which no operation folds: 0 where e has a value (domain/defined_zero.hpp).
    friend expression unfolded_zero(const expression& e);
    /// base^exponent; exp(exponent*log(base)), where the base is positive, for an exponent that depends on the variable
    /// or an unknown. Throws error if then the base is a number that is not positive.
    friend expression pow(const expression& base, const expression& exponent);
    friend expression apply(function_kind f, const expression& x);
    /// A function of constant order. Throws error for an order that is not a fraction, and for a function without an
    /// order.
    friend expression apply(function_kind f, const expression& order, const expression& x);
    /// Whether both are structurally equal.
    friend bool same_form(const expression& a, const expression& b);

    friend expression variable();
    friend expression unknown(const std::string& name, int derivative);
    friend expression parameter(const std::string& name);

private:
    struct node;
    struct no_node {};
    explicit expression(no_node /*null*/) {}
    explicit expression(node&& made);
    static expression binary(node_kind kind, const expression& a, const expression& b);

    std::shared_ptr<const node> node_;
};

/// The function of a node, with its order, applied to another argument.
expression with_argument(const expression& function, const expression& x);

/// The independent variable, whatever its name.
expression variable();
/// The unknown function of this name, or one of its derivatives.
expression unknown(const std::string& name, int derivative = 0);
/// The parameter of this name.
expression parameter(const std::string& name);
/// The derivative of an unknown, or of a derivative of it. Throws error for any other expression.
expression derivative(const expression& of, int order = 1);

inline expression exp(const expression& x) { return apply(function_kind::exp, x); }
inline expression log(const expression& x) { return apply(function_kind::log, x); }
inline expression sqrt(const expression& x) { return apply(function_kind::sqrt, x); }
inline expression sin(const expression& x) { return apply(function_kind::sin, x); }
inline expression cos(const expression& x) { return apply(function_kind::cos, x); }
inline expression tan(const expression& x) { return apply(function_kind::tan, x); }
inline expression asin(const expression& x) { return apply(function_kind::asin, x); }
inline expression acos(const expression& x) { return apply(function_kind::acos, x); }
inline expression atan(const expression& x) { return apply(function_kind::atan, x); }
inline expression sinh(const expression& x) { return apply(function_kind::sinh, x); }
inline expression cosh(const expression& x) { return apply(function_kind::cosh, x); }
inline expression tanh(const expression& x) { return apply(function_kind::tanh, x); }
inline expression asinh(const expression& x) { return apply(function_kind::asinh, x); }
inline expression acosh(const expression& x) { return apply(function_kind::acosh, x); }
inline expression atanh(const expression& x) { return apply(function_kind::atanh, x); }
inline expression log10(const expression& x) { return apply(function_kind::log10, x); }
inline expression log2(const expression& x) { return apply(function_kind::log2, x); }
inline expression exp2(const expression& x) { return apply(function_kind::exp2, x); }
inline expression cbrt(const expression& x) { return apply(function_kind::cbrt, x); }
inline expression sinc(const expression& x) { return apply(function_kind::sinc, x); }
inline expression expm1(const expression& x) { return apply(function_kind::expm1, x); }
inline expression log1p(const expression& x) { return apply(function_kind::log1p, x); }
inline expression erf(const expression& x) { return apply(function_kind::erf, x); }
inline expression erfc(const expression& x) { return apply(function_kind::erfc, x); }
inline expression airy_ai(const expression& x) { return apply(function_kind::airy_ai, x); }
inline expression airy_ai_prime(const expression& x) { return apply(function_kind::airy_ai_prime, x); }
inline expression airy_bi(const expression& x) { return apply(function_kind::airy_bi, x); }
inline expression airy_bi_prime(const expression& x) { return apply(function_kind::airy_bi_prime, x); }
inline expression lambertw(const expression& x) { return apply(function_kind::lambertw, x); }
inline expression bessel_j(const rational& order, const expression& x) {
    return apply(function_kind::bessel_j, expression(order), x);
}
inline expression bessel_y(const rational& order, const expression& x) {
    return apply(function_kind::bessel_y, expression(order), x);
}
inline expression bessel_i(const rational& order, const expression& x) {
    return apply(function_kind::bessel_i, expression(order), x);
}
inline expression exprel(const rational& order, const expression& x) {
    return apply(function_kind::exprel, expression(order), x);
}
inline expression cosrel(const rational& order, const expression& x) {
    return apply(function_kind::cosrel, expression(order), x);
}
inline expression bessel_k(const rational& order, const expression& x) {
    return apply(function_kind::bessel_k, expression(order), x);
}

/// Calls seen(leaf) for the variable, the unknowns and the parameters in an expression, from left to right; only once
/// for copies of one object.
void each_leaf(const expression& e, const std::function<void(const expression& leaf)>& seen);

/// The replacement of a leaf (variable, unknown, parameter); std::nullopt if the leaf is unchanged.
using replacement = std::function<std::optional<expression>(const expression& leaf)>;

/// The expression with its leaves replaced; shared subexpressions are replaced once.
expression replaced(const expression& in, const replacement& by);
/// The same for any nodes: `by` is called for each one, of which the operands of those that it replaces have no effect.
expression with_nodes_replaced(const expression& in, const replacement& by);

/// d e / d leaf with all other leaves fixed; the leaf is the variable, an unknown or one of its derivatives, or a
/// parameter.
expression partial(const expression& e, const expression& leaf);

/// sum over k of directions[k] d e / d leaves[k]; further leaves are fixed.
expression derivative_along(const expression& e, const std::vector<expression>& leaves,
                            const std::vector<expression>& directions);

/// The name with one prime per derivative: f''.
std::string primed(const std::string& name, int derivative);

}  // namespace libration::ode
