// Values computed by another program for one time or argument, and the true values with which they are compared.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/scalar/ball/comparison.hpp"
#include "libration/verification/compare_rules.hpp"

namespace libration {

/// The source of the true values of a row.
struct row_question {
    /// Whether the true values are proved; otherwise two computations agree on them.
    bool proved = true;
    /// The digits of the first attempt for a given number of decimal places.
    std::function<long(long places)> first_digits;
    /// The true values of the compared columns, at the working precision of this many digits; empty if that is too
    /// low. May throw precision_exhausted.
    std::function<std::vector<true_value>(long digits)> truths;
    /// The derivatives of the compared columns with respect to the time of the row, to a few digits, empty at an initial
    /// time; no function if rows have no time.
    std::function<std::vector<mpfr>(long digits)> slopes = {};
    /// The condition number of the first column, or the largest of all columns, depending on the source, three digits;
    /// "inf" if it has none.
    std::function<std::string(long digits)> condition;
};

inline constexpr long digits_of_row_numbers = 20;

/// Numbers of a row, to 20 digits, by which mistakes that rows have in common are recognised (mistake_hint).
struct row_numbers {
    std::vector<mpfr> written;
    std::vector<mpfr> truths;
    std::vector<mpfr> errors;  ///< written - truth
    std::vector<mpfr> slopes;  ///< derivatives of the truths by time; empty if unknown, and for a row without a miss
};

/// A row compared with its true values.
struct compared_values {
    std::vector<comparison> values;
    std::string condition;
    /// std::nullopt if one of the values is not finite.
    std::optional<row_numbers> numbers = std::nullopt;
    /// Whether the true values are.
    bool proved = true;

    /// Whether all of them are within their tolerance.
    bool within() const;
};

/// Throws error of the name of a column if it is not a number.
void require_numbers(const std::vector<written_value>& values, const compare_rules& rules);

/// The values of a row, one per true value, compared by the rules: with more digits until every verdict is decided.
/// Throws error of the name of a column if a value is not a number, of the kind undecided of the name of the first one
/// if five times the first digits do not decide.
compared_values compare_row(const std::vector<written_value>& values, const row_question& question,
                            const compare_rules& rules);

/// The tenths of tenths_of_digits as a decimal, inf for an error of 0.
std::string correct_digits_text(const std::optional<long>& tenths);

}  // namespace libration
