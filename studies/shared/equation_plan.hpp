// The plans of studies of any equation: a cell per combination of parameters, or per integer of an axis at each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "equation_sweep.hpp"
#include "plan_of_values.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

inline shared_equation_sweep equation_sweep_of(const study_request& request) {
    return std::make_shared<const equation_sweep>(request);
}

/// A table without rows under the columns of a Row and those of the axes.
template <class Row>
study_table head_of(const equation_sweep& sweep, std::string suffix, const scalar_spec& scalar,
                    const column_list<Row>& columns) {
    return {std::move(suffix), scalar, sweep.framed(0, make_table(columns, std::vector<Row>()))};
}

/// The last of the study's columns, for rows with a member `unknown`.
template <class Row>
column_of<Row> unknown_column() {
    return {"unknown", "of the problem", [](const Row& r) { return cell(r.unknown); }};
}

/// A cell per combination: rows(i) returns one table of the study's columns for each table of the plan.
template <class Rows>
study_plan plan_by_parameters(std::vector<study_table> tables, const shared_equation_sweep& sweep, const Rows& rows) {
    return plan_of_cells(
        std::move(tables), sweep->axes(), sweep->size(), [sweep](std::size_t i) { return sweep->inputs(i); },
        [sweep, rows](std::size_t i) { return sweep->framed(i, rows(i)); });
}

/// A cell for each of these integers of an axis at each combination, those of a combination together: rows(i, values).
template <class Rows>
study_plan plan_by_numbers(std::vector<study_table> tables, const shared_equation_sweep& sweep, const std::string& axis,
                           const std::vector<int>& values, const Rows& rows) {
    return plan_of_values(
        std::move(tables), sweep->axes({axis}), sweep->size(), [sweep](std::size_t i) { return sweep->inputs(i); },
        values,
        [sweep, rows](std::size_t i, const std::vector<int>& chosen) { return sweep->framed(i, rows(i, chosen)); });
}

/// The times of the request as the constants of equations. Throws input_error if there are fewer than `least`.
inline std::vector<ode::number> times_of(const study_request& request, std::size_t least) {
    std::vector<ode::number> times;
    for (const exact& each : request.values.of("time")) {
        times.push_back(as_exact_real(each));
    }
    if (times.size() < least) {
        throw input_error(times.empty() ? "no --times are given: add --times such as 0:3:61"
                                        : "--times has fewer than " + std::to_string(least) +
                                              " times: write a range such as 0:3:61");
    }
    return times;
}

/// The parameter --times of an equation, which times_of requires.
inline study_parameter required_times(const std::string& meaning) { return {"--times", "", meaning, true}; }

/// A text without commas, which would separate it in a table.
inline std::string without_commas(std::string text) {
    std::ranges::replace(text, ',', ';');
    return text;
}

}  // namespace libration::studies
