#include "verify/verify_layout.hpp"

#include "text/input_error.hpp"

namespace libration {

std::vector<known_column> known_columns() {
    auto columns = motion_layout::known();
    const auto of_functions = function_layout::known();
    columns.insert(columns.end(), of_functions.begin(), of_functions.end());
    return columns;
}

verify_layout::verify_layout(const column_names& names, const motion_options& motion, const compare_rules& rules)
    : rules_(rules) {
    if (motion_layout::fits(names) || !function_layout::fits(names)) {
        of_motions_.emplace(names, motion_cells::of(motion));
        return;
    }
    if (const auto option = motion.first_given()) {
        throw input_error(*option + " has no meaning for elliptic functions: leave it out");
    }
    if (rules.modulo_turn) {
        throw input_error("--modulo-2pi has no meaning for elliptic functions: leave it out");
    }
    of_functions_.emplace(names);
}

make_reader verify_layout::reader() const {
    return [this]() -> std::unique_ptr<question_reader> {
        if (of_motions_) {
            return std::make_unique<motion_questions>(*of_motions_, rules_);
        }
        return std::make_unique<function_questions>(*of_functions_, rules_);
    };
}

}  // namespace libration
