// A row of a file given to `verify`: values, and how their reference values are computed.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libration/verification/row_question.hpp"
#include "text/column_names.hpp"

namespace libration {

/// A column whose values are compared: our name of it, and its place.
struct compared_column {
    std::string name;
    std::size_t at;
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

/// What the rows of a file are compared with: motions, elliptic functions or the solution of a problem.
class row_subject {
public:
    row_subject() = default;
    row_subject(const row_subject&) = delete;
    row_subject& operator=(const row_subject&) = delete;
    virtual ~row_subject() = default;

    /// The quantities that its files may have, for column_names; they live as long as this.
    virtual std::vector<known_column> known() const = 0;
    /// Finds the columns of a file. Throws input_error for one that is missing, and if there is nothing to compare.
    virtual void read(const column_names& names) = 0;
    /// Those to be compared, after read().
    virtual const std::vector<compared_column>& compared() const = 0;
    /// A reader of rows, one for each thread; the subject has to outlive it.
    virtual std::unique_ptr<question_reader> reader() const = 0;
};

}  // namespace libration
