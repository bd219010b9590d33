// Rows of the solution of any differential equation under `verify`: some of its unknowns and their derivatives at a
// time.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/condition_numbers.hpp"
#include "libration/ode/step.hpp"
#include "text/column_names.hpp"
#include "verify/compare_rules.hpp"
#include "verify/row_question.hpp"

namespace libration {

/// Where the columns of a file are: time, or the variable of the problem, and unknowns and their lower derivatives,
/// x, x', ...
class problem_layout {
public:
    /// The problem solved for its highest derivatives, and as it is written.
    problem_layout(ode::explicit_system system, ode::equation_system equations);

    /// The quantities, for column_names; they live as long as this.
    std::vector<known_column> known() const;
    /// Finds the columns of a file. Throws input_error where there is no time or nothing to compare.
    void read(const column_names& names);

    /// A column that is compared: a derivative of an unknown.
    struct component {
        std::size_t unknown;
        std::size_t derivative;
    };
    const ode::explicit_system& system() const { return system_; }
    const ode::equation_system& equations() const { return equations_; }
    /// The place of a component among all unknowns and their lower derivatives.
    std::size_t place_of(const component& of) const;
    const std::vector<compared_column>& compared() const { return compared_; }
    const std::vector<component>& components() const { return components_; }
    /// Throws error of the name of the column.
    exact time(const std::vector<std::string>& cells, bool as_double) const;

private:
    ode::explicit_system system_;
    ode::equation_system equations_;
    std::vector<std::string> names_;     // of all components
    std::vector<component> all_;         // in the same order
    std::vector<component> components_;  // those of the file
    std::vector<compared_column> compared_;
    std::optional<std::size_t> time_;
    std::string own_time_;
};

/// Rows of such a file. A truth is proved (ode::proved_march); where the start is singular it is that of two marches of
/// other orders and precisions, within 16 times what they differ by. The condition number is the largest
///     (|t dy/dt| + sum_x |x dy/dx|) / max(1, |y|)
/// of the columns y that are compared, x the starts and the parameters that are not 0 (ode::dependence); at a singular
/// start |t dy/dt| / max(1, |y|) of the first one alone.
/// Rows that come by time share the marches.
class problem_questions : public question_reader {
public:
    problem_questions(const problem_layout& layout, const compare_rules& rules) : layout_(layout), rules_(rules) {}
    const std::vector<compared_column>& columns() const override { return layout_.compared(); }
    row_question read(const std::vector<std::string>& cells) override;

private:
    struct march_pair;
    struct proved_way;
    struct dependent_way;

    std::vector<ball> proved_state(const exact& time, long digits);
    march_pair& marches(long digits);
    std::vector<true_value> truths_at(const exact& time, long digits);
    std::string condition_at(const exact& time, long digits);
    std::string condition_of_slope(const exact& time, long digits);
    std::optional<std::vector<ode::moved_value>> moved_at(const ode::number& time);

    const problem_layout& layout_;
    const compare_rules& rules_;
    std::map<long, std::shared_ptr<march_pair>> by_digits_;
    std::map<long, std::shared_ptr<proved_way>> proved_by_digits_;
    std::shared_ptr<dependent_way> dependent_;
};

}  // namespace libration
