// The cells of sweeps over energies: each energy by itself, or each order, or each expansion point, at an energy.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libration/problem/known/pendulum.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

/// The sweep of a request, which the functions of a plan share.
using shared_sweep = std::shared_ptr<const pendulum_sweep>;

inline shared_sweep sweep_of(const study_request& request) {
    return std::make_shared<const pendulum_sweep>(request.values);
}

/// The energy as an input of a cell: what its columns print.
inline cell_inputs inputs_of(const sweep_energy& at) {
    cell_inputs inputs{{"energy", at.energy}, {"gap", at.gap}};
    if (!at.energy_typed.empty()) {
        inputs.push_back({"energy_typed", at.energy_typed});
    }
    if (!at.gap_typed.empty()) {
        inputs.push_back({"gap_typed", at.gap_typed});
    }
    return inputs;
}

/// A cell for each energy: rows(at) gives one table for each of the plan's.
template <class Rows>
study_plan plan_by_energy(std::vector<study_table> tables, const shared_sweep& sweep, const Rows& rows) {
    return plan_of_cells(
        std::move(tables), {"energy", "gap"}, sweep->energies.size(),
        [sweep](std::size_t i) { return inputs_of(sweep->energies[i]); },
        [sweep, rows](std::size_t i) { return rows(sweep->energies[i]); });
}

/// A cell for each expansion point at each energy: rows(at, point).
template <class Rows>
study_plan plan_by_point(std::vector<study_table> tables, const shared_sweep& sweep, const Rows& rows) {
    const std::size_t points = sweep->points.size();
    return plan_of_cells(
        std::move(tables), {"energy", "gap", "point"}, sweep->energies.size() * points,
        [sweep, points](std::size_t i) {
            return with_input(inputs_of(sweep->energies[i / points]), "point", sweep->points[i % points].text);
        },
        [sweep, points, rows](std::size_t i) { return rows(sweep->energies[i / points], sweep->points[i % points]); });
}

inline std::string input_words(int order) { return std::to_string(order); }
inline std::string input_words(const exact& value) { return value.text; }

/// A cell for each of these values of an axis at each energy, those of an energy together: rows(at, values) gives one
/// table for each of the plan's, with as many rows for each value, one value after the other.
template <class Value, class Rows>
study_plan plan_by_values(std::vector<study_table> tables, const shared_sweep& sweep, const std::string& axis,
                          const std::vector<Value>& values, const Rows& rows) {
    const auto group = [sweep, axis, values, rows](std::size_t i) {
        const sweep_energy& at = sweep->energies[i];
        cell_group cells;
        cells.cells.reserve(values.size());
        for (const Value& value : values) {
            cells.cells.push_back(with_input(inputs_of(at), axis, input_words(value)));
        }
        cells.compute = [sweep, &at, values, rows](const std::vector<std::size_t>& which) {
            std::vector<Value> chosen;
            chosen.reserve(which.size());
            for (const std::size_t each : which) {
                chosen.push_back(values[each]);
            }
            return equal_parts(rows(at, chosen), which.size());
        };
        return cells;
    };
    return {std::move(tables), {"energy", "gap", axis}, sweep->energies.size(), group, {}, {}};
}

/// The same for the orders.
template <class Rows>
study_plan plan_by_order(std::vector<study_table> tables, const shared_sweep& sweep, const std::vector<int>& orders,
                         const Rows& rows) {
    return plan_by_values(std::move(tables), sweep, "order", orders, rows);
}

}  // namespace libration::studies
