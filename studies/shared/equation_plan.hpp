// The plans of studies of any equation: a cell for each combination of parameters, or for each of some numbers at one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "equation_sweep.hpp"
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

/// The last of the study's own columns, of rows with a member `unknown`.
template <class Row>
column_of<Row> unknown_column() {
    return {"unknown", "of the problem", [](const Row& r) { return cell(r.unknown); }};
}

/// A cell for each combination: rows(i) gives one table of the study's own columns for each of the plan's.
template <class Rows>
study_plan plan_by_parameters(std::vector<study_table> tables, const shared_equation_sweep& sweep, const Rows& rows) {
    return plan_of_cells(
        std::move(tables), sweep->axes(), sweep->size(), [sweep](std::size_t i) { return sweep->inputs(i); },
        [sweep, rows](std::size_t i) {
            std::vector<table> all;
            for (const table& own : rows(i)) {
                all.push_back(sweep->framed(i, own));
            }
            return all;
        });
}

/// A cell for each of these whole numbers of an axis at each combination, those of a combination together: rows(i,
/// values) gives one table for each of the plan's, with as many rows for each value, one value after the other.
template <class Rows>
study_plan plan_by_numbers(std::vector<study_table> tables, const shared_equation_sweep& sweep, const std::string& axis,
                           const std::vector<int>& values, const Rows& rows) {
    const auto group = [sweep, axis, values, rows](std::size_t i) {
        cell_group cells;
        for (const int value : values) {
            cells.cells.push_back(with_input(sweep->inputs(i), axis, std::to_string(value)));
        }
        cells.compute = [sweep, values, rows, i](const std::vector<std::size_t>& which) {
            std::vector<int> chosen;
            chosen.reserve(which.size());
            for (const std::size_t each : which) {
                chosen.push_back(values[each]);
            }
            std::vector<table> all;
            for (const table& own : rows(i, chosen)) {
                all.push_back(sweep->framed(i, own));
            }
            return equal_parts(all, which.size());
        };
        return cells;
    };
    return {std::move(tables), sweep->axes({axis}), sweep->size(), group, {}, {}};
}

/// The orders by size. Throws input_error where one is below `least`, which `is` why.
inline std::vector<int> orders_from(const study_request& request, int least, const std::string& is) {
    std::vector<int> orders = request.orders();
    std::ranges::sort(orders);
    if (orders.front() < least) {
        throw input_error("--orders", std::to_string(orders.front()), is,
                          "write orders from " + std::to_string(least) + " on");
    }
    return orders;
}

/// The times of the request as the constants of equations. Throws input_error where there are fewer than `least`.
inline std::vector<ode::number> times_of(const study_request& request, std::size_t least) {
    std::vector<ode::number> times;
    for (const exact& each : request.values.of("time")) {
        times.push_back(as_expression(each));
    }
    if (times.size() < least) {
        throw input_error(times.empty() ? "no --times are given: add --times such as 0:3:61"
                                        : "--times has fewer than " + std::to_string(least) +
                                              " times: write a range such as 0:3:61");
    }
    return times;
}

/// A text without the commas that would part it in a table.
inline std::string without_commas(std::string text) {
    std::ranges::replace(text, ',', ';');
    return text;
}

}  // namespace libration::studies
