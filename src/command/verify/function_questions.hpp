// Rows of elliptic functions under `verify`: am, sn, K, E, Pi, ... at a modulus and an argument.
#pragma once

#include <string>
#include <vector>

#include "libration/verification/compare_rules.hpp"
#include "table/elliptic_columns.hpp"
#include "verify/row_question.hpp"

namespace libration {

/// A function with its arguments, and which of its columns there are: its value, or the parts of a complex one.
struct function_question {
    const elliptic::named_function* function;
    elliptic_point at;
    bool real, imaginary;  ///< NAME_re, NAME_im; neither for NAME

    /// In the order of the columns. Throws as the function does.
    std::vector<true_value> truths() const;
};

/// Where the columns of a file of elliptic functions are: k, m, m1 or alpha; u, phi, x and n where functions need them;
/// and a column for each function under its name, or NAME_re and NAME_im for the parts of a complex value.
class function_layout {
public:
    /// The quantities, for column_names.
    static std::vector<known_column> known();
    /// Whether the names are those of elliptic functions: a modulus, or one of the functions.
    static bool fits(const column_names& names);
    /// Throws input_error for a column that is missing, a modulus or a function included, and for two moduli.
    explicit function_layout(const column_names& names);

    const std::vector<compared_column>& compared() const { return compared_; }
    /// Throws error of the name of a column.
    std::vector<function_question> read(const std::vector<std::string>& cells, bool as_doubles) const;

private:
    struct asked_function {
        const elliptic::named_function* function;
        elliptic_columns columns;
        bool real, imaginary;
    };

    std::vector<asked_function> functions_;
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
