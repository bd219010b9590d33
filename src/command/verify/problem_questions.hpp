// Rows of the solution of any differential equation under `verify`: some of its unknowns and their derivatives at a
// time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/verification/compare_rules.hpp"
#include "libration/verification/hybrid_truths.hpp"
#include "libration/verification/problem_truths.hpp"
#include "text/column_names.hpp"
#include "verify/row_question.hpp"

namespace libration {

/// The columns of a file: time, or the variable of the problem, and unknowns and their lower derivatives, x, x', ...
class problem_layout : public row_subject {
public:
    /// The problem solved for its highest derivatives, and as it is written.
    problem_layout(ode::explicit_system system, ode::equation_system equations, const compare_rules& rules);
    /// A problem with events or a piecewise right-hand side.
    problem_layout(ode::hybrid_system system, const compare_rules& rules);

    std::vector<known_column> known() const override;
    void read(const column_names& names) override;
    std::unique_ptr<question_reader> reader() const override;

    const ode::explicit_system& system() const { return *system_; }
    const ode::hybrid_system& hybrid() const { return *hybrid_; }
    const ode::equation_system& equations() const { return equations_; }
    const std::vector<compared_column>& compared() const override { return compared_; }
    std::vector<ode::solution_component> components() const;
    /// Their indices in the state.
    const std::vector<std::size_t>& places() const { return places_; }
    /// Throws error of the name of the column.
    exact time(const std::vector<std::string>& cells, bool as_double) const;

private:
    void require_all_compared(const column_names& names) const;

    std::optional<ode::explicit_system> system_;
    std::optional<ode::hybrid_system> hybrid_;
    ode::equation_system equations_;
    const compare_rules& rules_;
    std::string variable_;
    std::vector<std::string> names_;   // of all components
    std::vector<std::size_t> places_;  // of those of the file among them
    std::vector<compared_column> compared_;
    std::optional<std::size_t> time_;
    std::string own_time_;
};

/// Rows of such a file (ode::problem_truths). Rows sorted by time share the integrations.
class problem_questions : public question_reader {
public:
    problem_questions(const problem_layout& layout, const compare_rules& rules)
        : layout_(layout), rules_(rules), truths_(layout.system(), layout.equations(), layout.components()) {}
    const std::vector<compared_column>& columns() const override { return layout_.compared(); }
    row_question read(const std::vector<std::string>& cells) override;

private:
    const problem_layout& layout_;
    const compare_rules& rules_;
    ode::problem_truths truths_;
};

/// Rows of such a file for a problem with events or a piecewise right-hand side (ode::hybrid_truths).
class hybrid_questions : public question_reader {
public:
    hybrid_questions(const problem_layout& layout, const compare_rules& rules)
        : layout_(layout), rules_(rules), truths_(layout.hybrid(), layout.places()) {}
    const std::vector<compared_column>& columns() const override { return layout_.compared(); }
    row_question read(const std::vector<std::string>& cells) override {
        return truths_.at(layout_.time(cells, rules_.inputs_are_doubles));
    }

private:
    const problem_layout& layout_;
    const compare_rules& rules_;
    ode::hybrid_truths truths_;
};

}  // namespace libration
