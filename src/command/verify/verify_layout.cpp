#include "verify/verify_layout.hpp"

#include <optional>
#include <utility>

#include "text/input_error.hpp"
#include "verify/function_questions.hpp"
#include "verify/motion_questions.hpp"
#include "verify/problem_questions.hpp"

namespace libration {

namespace {

// Motions or elliptic functions.
class columns_subject : public row_subject {
public:
    columns_subject(const motion_options& motion, const compare_rules& rules) : motion_(motion), rules_(rules) {}

    std::vector<known_column> known() const override {
        auto columns = motion_layout::known();
        const auto of_functions = function_layout::known();
        columns.insert(columns.end(), of_functions.begin(), of_functions.end());
        return columns;
    }

    void read(const column_names& names) override {
        if (motion_layout::fits(names) || !function_layout::fits(names)) {
            of_motions_.emplace(names, motion_cells::of(motion_));
            return;
        }
        if (const auto option = motion_.first_given()) {
            throw input_error(*option + " has no meaning for elliptic functions: leave it out");
        }
        if (rules_.modulo_turn) {
            throw input_error("--modulo-2pi has no meaning for elliptic functions: leave it out");
        }
        of_functions_.emplace(names);
    }

    const std::vector<compared_column>& compared() const override {
        return of_motions_ ? of_motions_->compared() : of_functions_->compared();
    }

    std::unique_ptr<question_reader> reader() const override {
        if (of_motions_) {
            return std::make_unique<motion_questions>(*of_motions_, rules_);
        }
        return std::make_unique<function_questions>(*of_functions_, rules_);
    }

private:
    const motion_options& motion_;
    const compare_rules& rules_;
    std::optional<motion_layout> of_motions_;
    std::optional<function_layout> of_functions_;
};

// Complains of the options as every command does.
void check_motion(const motion_options& motion) {
    const motion_cells cells = motion_cells::of(motion);
    numbers_of_options({.length = cells.length.text, .gravity = cells.gravity.text});
    const bool energetic = !cells.gap.text.empty() || !cells.energy.text.empty();
    if (energetic || (!cells.theta0.text.empty() && !cells.omega0.text.empty())) {
        motion.choose_for({scalar_kind::proved, 50});
    }
}

}  // namespace

std::unique_ptr<row_subject> row_subject_of(const problem_options& problem, const motion_options& motion,
                                            const compare_rules& rules) {
    if (!problem.is_chosen()) {
        check_motion(motion);
        return std::make_unique<columns_subject>(motion, rules);
    }
    auto equations = problem.equations();
    if (equations.is_smooth() || equations.has_delays()) {
        return std::make_unique<problem_layout>(problem.choose(), std::move(equations), rules);
    }
    return std::make_unique<problem_layout>(problem.naming([&] { return ode::hybrid_system(equations); }), rules);
}

}  // namespace libration
