// The place that the parsers of a formula have reached, each of which is in a separate file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "libration/equation/expression.hpp"
#include "libration/scalar/error.hpp"
#include "statement.hpp"

namespace libration::ode {

/// The tokens of a formula from `next` on, and the reader of a sum of them.
struct formula_cursor {
    const statement& words;
    std::size_t& next;
    std::size_t last;
    int& depth;  ///< of parentheses, signs and exponents
    std::function<expression()> sum;

    bool at_symbol(char c) const { return next < last && is_symbol(words[next], c); }
    /// Whether the next token is this symbol, which then is passed.
    bool take(char c) const {
        const bool found = at_symbol(c);
        next += found ? 1 : 0;
        return found;
    }
    /// A sum behind a parenthesis at that place, up to a ) or a comma.
    expression before_end(const place& opened) const;
    /// Passes the ) of a parenthesis at that place. Throws error for any other token.
    void close(const place& opened) const;
};

/// The value of an operation on parts of a formula, at this place; constants may have none, of which the error names the
/// place.
template <class Operation>
expression folded(const statement& words, const place& at, const Operation& operation) {
    try {
        return operation();
    } catch (const error& problem) {
        if (problem.is_about(error_subject::problem)) {
            throw;
        }
        const bool of_number = problem.is_about(error_subject::number);
        const std::string subject = of_number ? "" : problem.subject() + " ";
        throw error(problem.kind(), error_subject::problem, beginning_of(whole(words)),
                    "at line " + std::to_string(at.line) + ", column " + std::to_string(at.column) + " " +
                        (subject.empty() ? "" : "has an " + subject + "that ") + problem.reason() +
                        (of_number ? ": choose another number" : ""));
    }
}

}  // namespace libration::ode
