// Messages for formulas that are ambiguous or have another form: both readings, or the correction, as the statement
// that was written with the correction in it.
#pragma once

#include <cstddef>

#include "libration/equation/expression.hpp"
#include "names.hpp"
#include "statement.hpp"

namespace libration::ode {

/// y z, (y)(z): two operands without * between them, the second at this index.
[[noreturn]] void refuse_product(const statement& words, std::size_t second);

/// a/2y in the tokens begin .. end - 1: the number, at this index, is the denominator, or the product is.
[[noreturn]] void refuse_denominator(const statement& words, std::size_t begin, std::size_t slash, std::size_t numeral,
                                     std::size_t end);

/// x^2y, where begin is the first token of the exponent, and the number at this index is its end, or end is.
[[noreturn]] void refuse_exponent(const statement& words, std::size_t begin, std::size_t numeral, std::size_t end);

/// sin y, sin 2y, sin^2(y): the name of a function at this index without a parenthesis behind it.
[[noreturn]] void refuse_without_argument(const statement& words, std::size_t function);

/// a(t + 1), f(0), Sin(x): a name at this index that is not a function, before a parenthesis.
[[noreturn]] void refuse_argument(const statement& words, std::size_t name, const known_names& names);

/// The token of this index, which cannot follow an operand.
[[noreturn]] void refuse_token(const statement& words, std::size_t at, std::size_t last);

/// The end of a formula where an operand is missing.
[[noreturn]] void refuse_end(const statement& words, std::size_t last);

/// A formula nested more than deepest_formula deep, at the token of this index.
[[noreturn]] void refuse_depth(const statement& words, std::size_t at);

/// Throws error for y' and y'(t) in a condition, the name of this index, and for the variable.
void require_time(const statement& words, std::size_t name, const known_names& names);

/// Throws error for y'(y + 1) in a condition, the name of this index up to the token `end`: a time that is not constant.
void require_constant_time(const expression& time, const statement& words, std::size_t name, std::size_t end);

/// d of y(t - d), the name at this index up to the token `end`, from its argument. Throws error for other arguments.
expression delay_of(const expression& argument, const statement& words, std::size_t name, std::size_t end,
                    const known_names& names);

/// Throws error for the symbols of an interval, 1 +- 0.1 or [0, 1], within a formula.
void refuse_interval(const token& word);

/// A name without a value.
[[noreturn]] void refuse_name(const token& word, const known_names& names);

}  // namespace libration::ode
