// Which kind of file `verify` has before it: motions, or elliptic functions.
#pragma once

#include <optional>
#include <vector>

#include "verify/function_questions.hpp"
#include "verify/motion_questions.hpp"

namespace libration {

/// All quantities that a file may have, for column_names.
std::vector<known_column> known_columns();

/// The kind of a file and its columns.
class verify_layout {
public:
    /// Throws input_error for a file of neither kind, and for options of motions together with elliptic functions.
    verify_layout(const column_names& names, const motion_options& motion, const compare_rules& rules);

    const std::vector<compared_column>& compared() const {
        return of_motions_ ? of_motions_->compared() : of_functions_->compared();
    }
    /// Makes a reader of rows for each thread; the layout has to outlive them.
    make_reader reader() const;

private:
    std::optional<motion_layout> of_motions_;
    std::optional<function_layout> of_functions_;
    const compare_rules& rules_;
};

}  // namespace libration
