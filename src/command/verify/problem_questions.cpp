#include "verify/problem_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "problem/motion_cells.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

problem_layout::problem_layout(ode::explicit_system system, ode::equation_system equations, const compare_rules& rules)
    : system_(std::move(system)),
      equations_(std::move(equations)),
      rules_(rules),
      names_(ode::names_of_state(system_)),
      all_(ode::components_of(system_)) {}

std::vector<known_column> problem_layout::known() const {
    std::vector<known_column> columns{{"time", {"time", system_.variable()}}};
    for (const std::string& name : names_) {
        columns.push_back({name});
    }
    return columns;
}

void problem_layout::read(const column_names& names) {
    time_ = names.find("time");
    if (!time_) {
        const std::string variable = system_.variable();
        throw input_error(fmt::format("{} has no column {}: its columns are {}: {}", names.file(),
                                      variable == "t" ? "'time' or 't'" : quotation(variable) + " or 'time'",
                                      names.listed(), mapping_remedy));
    }
    own_time_ = names.own(*time_);
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (const auto at = names.find(names_[i])) {
            compared_.push_back({names_[i], *at});
            components_.push_back(all_[i]);
        }
    }
    if (compared_.empty()) {
        throw input_error(fmt::format("{} has none of the columns {} of the problem: its columns are {}: {}",
                                      names.file(), listed(names_), names.listed(), mapping_remedy));
    }
}

std::unique_ptr<question_reader> problem_layout::reader() const {
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
