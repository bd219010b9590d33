// Values that somebody computed for one time or argument, and the truths that they are compared with.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/scalar/ball/comparison.hpp"
#include "libration/verify/proved/compare_rules.hpp"

namespace libration {

/// Where the truths of a row come from.
struct row_question {
    /// Whether the truths are proved; otherwise two computations agree on them.
    bool proved = true;
    /// The digits of the first attempt that serves so many decimal places.
    std::function<long(long places)> first_digits;
    /// The truths of the compared columns, at the working precision of so many digits, or nothing where it is too
    /// small. May throw precision_exhausted.
    std::function<std::vector<true_value>(long digits)> truths;
    /// The condition number of the first column, or the largest of all where the one who asks says so, three digits;
    /// "inf" where it has none.
    std::function<std::string(long digits)> condition;
};

/// A row compared with its truths.
struct compared_values {
    std::vector<comparison> values;
    std::string condition;
    /// Whether the truths are.
    bool proved = true;

    /// Whether all of them keep their tolerance.
    bool within() const;
};

/// A value as it was written, "nan" and "inf" among them, and the name of its column.
struct written_value {
    std::string text;
    std::string name;
};

/// Throws error of the name of a column for what is no number.
void require_numbers(const std::vector<written_value>& values, const compare_rules& rules);

/// The values of a row, one a truth, compared by the rules: with more digits until every verdict is decided. Throws
/// error of the name of a column for what is no number, of the kind undecided of the name of the first one where five
/// times the first digits do not decide.
compared_values compare_row(const std::vector<written_value>& values, const row_question& question,
                            const compare_rules& rules);

/// The tenths of tenths_of_digits as a decimal, inf for an error of 0.
std::string correct_digits_text(const std::optional<long>& tenths);

}  // namespace libration
