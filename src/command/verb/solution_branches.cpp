#include "solution_branches.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "problem/solution_table.hpp"

namespace libration {

namespace {

std::string name_of_branch(const first_guess& guess) {
    return guess.empty() ? "the branch" : fmt::format("the branch of the first guess {}", fmt::join(guess, ", "));
}

}  // namespace

void solution_branches::keep(const first_guess& guess, answer found) {
    for (const answer_note& each : found.notes) {
        remarks_.push_back(fmt::format("{} {}", name_of_branch(guess), each.text));
    }
    if (found.missing) {
        has_failures_ = true;
        remarks_.push_back(fmt::format("{}: {}", name_of_branch(guess), found.missing->what()));
    }
    branches_.push_back(std::move(found));
}

std::string solution_branches::failure(const first_guess& guess) const {
    return name_of_branch(guess) + " has no first solution";
}

table solution_branches::as_table(long digits, bool numbered) const {
    const bool undecided = std::ranges::any_of(branches_, has_undecided);
    std::vector<column> columns;
    if (numbered) {
        columns.push_back({"branch", ""});
    }
    for (const std::string& each : branches_.front().names) {
        columns.push_back({each, ""});
    }
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}});
    if (undecided) {
        columns.push_back({"undecided", ""});
    }
    table data(columns);
    for (std::size_t i = 0; i < branches_.size(); ++i) {
        for (const auto& row : branches_[i].rows) {
            table_row_cells cells;
            if (numbered) {
                cells.emplace_back(static_cast<long>(i + 1));
            }
            cells.emplace_back(row.front().text);
            for (auto value = row.begin() + 1; value != row.end(); ++value) {
                cells.push_back(cell::number(value->text, digits));
            }
            cells.emplace_back(digits);
            cells.emplace_back(branches_[i].rigour);
            if (undecided) {
                cells.emplace_back(bounds_of(branches_[i], row));
            }
            data.add_row(std::move(cells));
        }
    }
    return data;
}

}  // namespace libration
