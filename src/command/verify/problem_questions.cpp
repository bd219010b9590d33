#include "verify/problem_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "libration/equation/renamed_unknowns.hpp"
#include "problem/motion_cells.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

// Columns of tables of libration that hold no values of the solution.
bool describes_rows(std::string_view name) {
    constexpr std::array<std::string_view, 5> names{"digits", "rigour", "time_typed", "verdict", "condition"};
    constexpr std::array<std::string_view, 3> endings{"reference", "error", "correct_digits"};
    return std::ranges::find(names, name) != names.end() || std::ranges::any_of(endings, [&](std::string_view ending) {
               return name == ending || name.ends_with("_" + std::string(ending));
           });
}

}  // namespace

problem_layout::problem_layout(ode::explicit_system system, ode::equation_system equations, const compare_rules& rules)
    : system_(std::move(system)),
      equations_(std::move(equations)),
      rules_(rules),
      variable_(system_->variable()),
      names_(ode::names_of_state(*system_)) {}

problem_layout::problem_layout(ode::hybrid_system system, const compare_rules& rules)
    : hybrid_(std::move(system)),
      rules_(rules),
      variable_(hybrid_->variable()),
      names_(ode::names_of_state(*hybrid_)) {}

std::vector<known_column> problem_layout::known() const {
    std::vector<known_column> columns{{"time", {"time", variable_}}};
    for (const std::string& name : names_) {
        const std::string_view before = ode::name_before_renaming(name);
        columns.push_back(before == "time" ? known_column{name} : known_column{name, {before}});
    }
    return columns;
}

void problem_layout::read(const column_names& names) {
    time_ = names.find("time");
    if (!time_) {
        throw input_error(fmt::format("{} has no column {}: its columns are {}: {}", names.file(),
                                      variable_ == "t" ? "'time' or 't'" : quotation(variable_) + " or 'time'",
                                      names.listed(), mapping_remedy));
    }
    own_time_ = names.own(*time_);
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (const auto at = names.find(names_[i])) {
            compared_.push_back({names_[i], *at});
            places_.push_back(i);
        }
    }
    if (compared_.empty()) {
        throw input_error(fmt::format("{} has none of the columns {} of the problem: its columns are {}: {}",
                                      names.file(), listed(names_), names.listed(), mapping_remedy));
    }
    require_all_compared(names);
}

// A column that is neither compared nor left out by the user could be taken for one that is.
void problem_layout::require_all_compared(const column_names& names) const {
    for (std::size_t at = 0; at < names.count(); ++at) {
        const std::string& own = names.own(at);
        const bool compared = at == *time_ || std::ranges::find(compared_, at, &compared_column::at) != compared_.end();
        if (!compared && !names.is_ignored(at) && !describes_rows(own)) {
            throw input_error(
                fmt::format("{} has the column {}, which is none of {}: write --rename {}=- to leave it out, or {}={} "
                            "to compare it",
                            names.file(), quotation(own), listed(names_), own, own, names_.back()));
        }
    }
}

std::vector<ode::solution_component> problem_layout::components() const {
    const auto all = ode::components_of(*system_);
    std::vector<ode::solution_component> chosen;
    std::ranges::transform(places_, std::back_inserter(chosen), [&](std::size_t place) { return all[place]; });
    return chosen;
}

std::unique_ptr<question_reader> problem_layout::reader() const {
    if (hybrid_) {
        return std::make_unique<hybrid_questions>(*this, rules_);
    }
    return std::make_unique<problem_questions>(*this, rules_);
}

exact problem_layout::time(const std::vector<std::string>& cells, bool as_double) const {
    return reading_cell({trimmed(cells[*time_]), own_time_}, [&](const std::string& text) {
        const exact time = time_in(text);
        if (time.has_periods()) {
            throw error(error_kind::argument, error_subject::time, text,
                        "is a multiple of a period, which a problem has not");
        }
        return as_double ? nearest_double(time) : time;
    });
}

row_question problem_questions::read(const std::vector<std::string>& cells) {
    return truths_.at(layout_.time(cells, rules_.inputs_are_doubles));
}

}  // namespace libration
