// The conditions of piecewise functions, in the text of a problem.
#pragma once

#include <cstddef>
#include <vector>

#include "formula_cursor.hpp"
#include "libration/equation/expression.hpp"
#include "statement.hpp"

namespace libration::ode {

enum class condition_kind { constant, positive, equal, negation, all, any };

/// A condition on expressions: true or false, difference > 0 or >= 0, difference == 0, or another condition made of
/// such parts.
struct condition {
    condition_kind kind = condition_kind::constant;
    expression difference = {};
    bool or_equal = false;              ///< of `positive`: >= instead of >
    bool holds = false;                 ///< of `constant`
    std::vector<condition> parts = {};  ///< one of a negation, at least two of `all` and `any`
};

/// Reads the condition at the cursor, whose sums are the sides of comparisons: comparisons a > b, a <= b, a == b, a != b and chains 0 <= x < 1, true, false, and
/// conditions combined by `not`, `and`, `or`, in descending order of precedence, with parentheses or as and(a, b).
/// Throws error for anything else, with the operator and the remedy.
condition read_condition(const formula_cursor& at);

/// Whether the tokens from this index to the end of an argument, a comma or a closing parenthesis, are a condition.
bool is_condition(const statement& words, std::size_t first, std::size_t last);
/// Whether they are two arguments in parentheses: (a, b).
bool is_pair(const statement& words, std::size_t first, std::size_t last);

}  // namespace libration::ode
