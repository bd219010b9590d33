// Rows of elliptic functions under `verify`: am, sn, K, E, Pi, ... at a modulus and an argument.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "table/elliptic_columns.hpp"
#include "verify/compare_rules.hpp"
#include "verify/row_question.hpp"

namespace libration {

/// Where the columns of a file of elliptic functions are: k, m or m1; u, phi, x and n where functions need them; and a
/// column for each function under its name.
class function_layout {
public:
    /// The quantities, for column_names.
    static std::vector<known_column> known();
    /// Whether the names are those of elliptic functions: a modulus, and one of them.
    static bool fits(const column_names& names);
    /// Throws input_error for a column that is missing, and for two moduli.
    explicit function_layout(const column_names& names);

    const std::vector<compared_column>& compared() const { return compared_; }
    /// A function with its arguments.
    using question = std::pair<const elliptic::named_function*, elliptic_point>;
    /// Throws error of the name of a column.
    std::vector<question> read(const std::vector<std::string>& cells, bool as_doubles) const;

private:
    std::vector<std::pair<const elliptic::named_function*, elliptic_columns>> functions_;
    std::vector<compared_column> compared_;
};

/// Rows of such a file.
class function_questions : public question_reader {
public:
    function_questions(const function_layout& layout, const compare_rules& rules) : layout_(layout), rules_(rules) {}
    const std::vector<compared_column>& columns() const override { return layout_.compared(); }
    row_question read(const std::vector<std::string>& cells) override;

private:
    const function_layout& layout_;
    const compare_rules& rules_;
};

}  // namespace libration
