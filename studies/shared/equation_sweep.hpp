// The cells of sweeps over parameters and initial values of an equation, and the columns that all their tables have.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/renamed_unknowns.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

/// Every combination of the values of --set; the last axis varies fastest.
class equation_sweep {
public:
    explicit equation_sweep(const study_request& request);

    /// Number of combinations; 1 if there is no axis.
    std::size_t size() const { return size_; }
    /// The system of one of them. Throws error if it has no solution.
    ode::explicit_system system(std::size_t i) const { return of_->at(values(i)); }
    /// The problem of one of them with the conditions at infinity of the text.
    limit_problem at_infinity(std::size_t i) const { return of_->at_infinity(values(i)); }
    cell_inputs inputs(std::size_t i) const;
    /// The names of the axes, followed by additional ones.
    std::vector<std::string> axes(const std::vector<std::string>& more = {}) const;
    /// The indices of the requested unknowns, and their names.
    const std::vector<int>& unknowns() const { return unknowns_; }
    const std::string& name_of(int unknown) const { return names_[static_cast<std::size_t>(unknown)]; }
    const swept_problem& of() const { return *of_; }

    /// <axes>,<columns of the study>,<values of the axes as typed>: a table of a study with all columns. An axis whose
    /// name is that of a column of the study is called set_NAME.
    table framed(std::size_t i, const table& own) const;
    std::vector<table> framed(std::size_t i, const std::vector<table>& own) const;

private:
    std::vector<exact> values(std::size_t i) const;

    shared_problem of_;
    std::vector<std::vector<exact>> along_;
    std::size_t size_ = 1;
    std::vector<std::string> names_;
    std::vector<int> unknowns_;
};

inline equation_sweep::equation_sweep(const study_request& request)
    : of_(request.equation), names_(of_->system.unknowns()) {
    for (const set_axis& each : of_->sets) {
        along_.push_back(request.values.of(each.axis()));
        size_ *= along_.back().size();
    }
    const auto& asked = request.values.of("unknown");
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const bool chosen = std::ranges::any_of(asked, [&](const exact& word) {
            return word.text == names_[i] || word.text == ode::name_before_renaming(names_[i]);
        });
        if (asked.empty() || chosen) {
            unknowns_.push_back(static_cast<int>(i));
        }
    }
}

inline std::vector<exact> equation_sweep::values(std::size_t i) const {
    std::vector<exact> result(along_.size());
    for (std::size_t axis = along_.size(); axis-- > 0; i /= along_[axis].size()) {
        result[axis] = along_[axis][i % along_[axis].size()];
    }
    return result;
}

inline cell_inputs equation_sweep::inputs(std::size_t i) const {
    const auto chosen = values(i);
    cell_inputs inputs;
    for (std::size_t axis = 0; axis < chosen.size(); ++axis) {
        inputs.push_back({of_->sets[axis].name, chosen[axis].text});
    }
    return inputs;
}

inline std::vector<std::string> equation_sweep::axes(const std::vector<std::string>& more) const {
    std::vector<std::string> names;
    for (const set_axis& each : of_->sets) {
        names.push_back(each.axis());
    }
    names.insert(names.end(), more.begin(), more.end());
    return names;
}

inline table equation_sweep::framed(std::size_t i, const table& own) const {
    constexpr long digits_of_axes = 50;
    const auto chosen = values(i);
    std::vector<column> columns;
    std::vector<column> typed;
    table_row_cells front;
    table_row_cells back;
    for (std::size_t axis = 0; axis < chosen.size(); ++axis) {
        const std::string& name = of_->sets[axis].name;
        const bool taken = std::ranges::any_of(own.columns(), [&](const column& c) { return c.name == name; });
        columns.push_back({taken ? "set_" + name : name, name + " of the problem"});
        typed.push_back({columns.back().name + "_typed", name + " as typed"});
        front.push_back(number_cell(decimal_of(chosen[axis], digits_of_axes)));
        back.push_back(read_cell(chosen[axis].text));
    }
    columns.insert(columns.end(), own.columns().begin(), own.columns().end());
    columns.insert(columns.end(), typed.begin(), typed.end());
    table result(std::move(columns));
    for (const table_row_cells& row : own.rows()) {
        table_row_cells cells = front;
        cells.insert(cells.end(), row.begin(), row.end());
        cells.insert(cells.end(), back.begin(), back.end());
        result.add_row(std::move(cells));
    }
    return result;
}

inline std::vector<table> equation_sweep::framed(std::size_t i, const std::vector<table>& own) const {
    std::vector<table> all;
    all.reserve(own.size());
    for (const table& each : own) {
        all.push_back(framed(i, each));
    }
    return all;
}

using shared_equation_sweep = std::shared_ptr<const equation_sweep>;

}  // namespace libration::studies
