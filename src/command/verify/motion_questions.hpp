// Rows of motions in `verify`: theta, and optionally omega, at a time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/verification/motion_truths.hpp"
#include "problem/motion_cells.hpp"
#include "verify/row_question.hpp"

namespace libration {

/// Where the columns of a file of motions are, and what its rows have in common.
class motion_layout {
public:
    /// The quantities, for column_names.
    static std::vector<known_column> known();
    /// Whether the names are those of motions: a time and a theta.
    static bool fits(const column_names& names);
    /// `usual` is what a row takes that does not say it. Throws input_error for a column or a motion that is missing.
    motion_layout(const column_names& names, motion_cells usual);

    const std::vector<compared_column>& compared() const { return compared_; }
    exact time(const std::vector<std::string>& cells, bool as_double) const;
    motion_cells motion(const std::vector<std::string>& cells) const;

private:
    time_columns time_;
    motion_columns motion_;
    motion_cells usual_;
    std::vector<compared_column> compared_;
};

/// Motions met lately are kept, so that rows of one motion share its work; what a row becomes does not depend on the
/// rows before.
class motion_questions : public question_reader {
public:
    motion_questions(const motion_layout& layout, const compare_rules& rules) : layout_(layout), rules_(rules) {}
    const std::vector<compared_column>& columns() const override { return layout_.compared(); }
    row_question read(const std::vector<std::string>& cells) override;

private:
    pendulum::motion_truths& motion_for(const motion_cells& cells);

    const motion_layout& layout_;
    const compare_rules& rules_;
    std::vector<std::pair<std::string, std::unique_ptr<pendulum::motion_truths>>> known_ = {};  // by key, latest first
};

}  // namespace libration
