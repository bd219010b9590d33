// Real numbers as formulas: input as typed, stored exactly and evaluated to any precision with proved bounds.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "libration/function/function_kind.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/plain_number.hpp"

namespace libration {

/// A constant real number: a sum of fractions times 1, pi, the period T, and products, quotients, powers and functions
/// of such sums. Immutable and cheap to copy. Sums are exact: pi - 1e-10 - pi is -1e-10, and values that are rational
/// by the rules for roots of fractions, for sin, cos, tan at fractions of pi and for their inverses are folded. T is
/// not a number here: it occurs only linearly. Shared subexpressions, as in y = x*x, z = y*y, are evaluated and
/// compared once. Operations throw libration::error of kind argument for a division by an exact 0, for arguments
/// outside the domain of a function, for T anywhere except in a sum, and for more than 10000 different terms or 200
/// levels of products, quotients, powers and functions; of kind undecided if no precision within the
/// limits decides whether a value is in the domain.
class exact_real {
public:
    /// 0.
    exact_real() = default;
    explicit exact_real(const rational& coefficient, unit measure = unit::one);
    exact_real(const plain_number& value) : exact_real(value.coefficient, value.measure) {}

    /// The value as a multiple of a single unit, if it is one; 0 has the unit one.
    std::optional<plain_number> plain() const;
    /// The value as a fraction, if it is one.
    std::optional<rational> fraction() const;
    /// The multiple of T in the sum, and the sum without it.
    rational periods() const;
    exact_real without_periods() const;

    exact_real operator-() const;
    friend exact_real operator+(const exact_real& a, const exact_real& b);
    friend exact_real operator-(const exact_real& a, const exact_real& b) { return a + -b; }
    friend exact_real operator*(const exact_real& a, const exact_real& b);
    friend exact_real operator/(const exact_real& a, const exact_real& b);
    /// base^exponent: any base with an integer exponent, otherwise a nonnegative base.
    friend exact_real power(const exact_real& base, const exact_real& exponent);
    friend exact_real apply(function_kind f, const exact_real& x);
    /// For a function with an order. Throws error for others.
    friend exact_real apply(function_kind f, const rational& order, const exact_real& x);
    /// Whether both have the same form; equal numbers may have different forms.
    friend bool same_form(const exact_real& a, const exact_real& b);
    /// Equal for equal forms.
    std::size_t hash() const;

    /// One evaluation with this number of bits, rounded outwards at each step; std::nullopt if they do not suffice to
    /// prove that a value is inside the domain of a function.
    std::optional<number_bounds> bounds_at(long bits) const;
    /// Bounds with upper - lower <= 2^-bits |x|, from 64 more bits on, doubled as often as necessary; both are 0 for a
    /// number that separation_exponent shows to be 0. Throws libration::error of kind undecided if the limit of the cost
    /// (about a second) is reached first: then the number may be 0.
    number_bounds narrowed(long bits) const;
    /// An exponent e such that the number is 0 or at least 2^-e, if it is built from fractions by sums, products,
    /// quotients, and powers with fractions as exponents, and e is below 2^22. It is U/L with algebraic integers U, L of
    /// a field of degree at most D, the product of the degrees of all roots in it, and all conjugates of U are at most
    /// u, those of L at most l. The norm of U is an integer: if nonzero, |U| >= u^(1-D), and the number is at least
    /// u^(1-D)/l [Burnikel2009].
    std::optional<long> separation_exponent() const;
    /// -1, 0 or 1, proved. Throws as narrowed().
    int sign() const;

private:
    struct atom;
    class comparison;
    class evaluation;
    class separation;
    class exponential_form;
    struct term {
        rational coefficient;
        std::shared_ptr<const atom> of;
    };

    static exact_real of_atom(atom a);
    static exact_real of_function(function_kind f, const rational& order, const exact_real& x);
    static bool same_atom(const atom& a, const atom& b);
    void add(const rational& coefficient, const std::shared_ptr<const atom>& of);
    const term* only_term() const { return terms_.size() == 1 ? &terms_.front() : nullptr; }
    void degrees_to_pi();
    long depth() const;
    /// The number of functions and powers computed by an evaluation; shared ones count once.
    long functions() const;
    /// The largest useful number of bits.
    long most_bits() const;

    std::vector<term> terms_;
};

/// The value at the working precision, within half a unit in the last place and 2^-64 of it. Throws as narrowed().
mpfr rounded_value(const exact_real& x);

}  // namespace libration
