// What a row asks `verify`: values, and where their truths come from.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "libration/scalar/ball/comparison.hpp"

namespace libration {

/// A column whose values are compared: our name of it, and its place.
struct compared_column {
    std::string name;
    std::size_t at;
};

/// A row, read exactly.
struct row_question {
    /// The digits of the first attempt that serves so many decimal places.
    std::function<long(long places)> first_digits;
    /// The truths of the compared columns, at the working precision of so many digits, or nothing where it is too
    /// small. May throw precision_exhausted.
    std::function<std::vector<true_value>(long digits)> truths;
    /// The condition number of the first column, or the largest of all where the reader says so, three digits;
    /// "inf" where it has none.
    std::function<std::string(long digits)> condition;
};

/// Reads rows of one kind: motions, or arguments of elliptic functions. One object for each thread; questions hold as
/// long as the next one is not read.
class question_reader {
public:
    question_reader() = default;
    question_reader(const question_reader&) = delete;
    question_reader& operator=(const question_reader&) = delete;
    virtual ~question_reader() = default;

    /// The columns to be compared, one at least.
    virtual const std::vector<compared_column>& columns() const = 0;
    /// Throws error of the name of a column where it cannot be read.
    virtual row_question read(const std::vector<std::string>& cells) = 0;
};

using make_reader = std::function<std::unique_ptr<question_reader>()>;

}  // namespace libration
