// Values computed by another program for one time or argument, and the true values with which they are compared.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/scalar/ball/comparison.hpp"
#include "libration/verify/proved/compare_rules.hpp"

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
    /// The condition number of the first column, or the largest of all columns, depending on the source, three digits;
    /// "inf" if it has none.
    std::function<std::string(long digits)> condition;
};

/// A row compared with its true values.
struct compared_values {
    std::vector<comparison> values;
    std::string condition;
    /// Whether the true values are.
    bool proved = true;

    /// Whether all of them are within their tolerance.
    bool within() const;
};

/// A value as it was written, which may be "nan" or "inf", and the name of its column.
struct written_value {
    std::string text;
    std::string name;
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
