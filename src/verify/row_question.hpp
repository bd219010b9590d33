// A row of a file given to `verify`: values, and how their reference values are computed.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "libration/verify/proved/row_question.hpp"

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

using make_reader = std::function<std::unique_ptr<question_reader>()>;

}  // namespace libration
