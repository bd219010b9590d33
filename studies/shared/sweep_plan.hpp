// The cells of sweeps over energies: one per energy, or one per order or expansion point at each energy.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libration/problem/known/pendulum.hpp"
#include "plan_of_values.hpp"

namespace libration::studies {

/// The sweep of a request, which the functions of a plan share.
using shared_sweep = std::shared_ptr<const pendulum_sweep>;

inline shared_sweep sweep_of(const study_request& request) {
    return std::make_shared<const pendulum_sweep>(request.values);
}

/// The energy as an input of a cell, as printed in its columns.
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

/// A cell for each energy: rows(at) returns one table for each of the plan's.
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

/// A cell for each of these values of an axis at each energy, those of an energy together: rows(at, values).
template <class Value, class Rows>
study_plan plan_by_values(std::vector<study_table> tables, const shared_sweep& sweep, const std::string& axis,
                          const std::vector<Value>& values, const Rows& rows) {
    return plan_of_values(
        std::move(tables), {"energy", "gap", axis}, sweep->energies.size(),
        [sweep](std::size_t i) { return inputs_of(sweep->energies[i]); }, values,
        [sweep, rows](std::size_t i, const std::vector<Value>& chosen) { return rows(sweep->energies[i], chosen); });
}

/// plan_by_values() for the orders.
template <class Rows>
study_plan plan_by_order(std::vector<study_table> tables, const shared_sweep& sweep, const std::vector<int>& orders,
                         const Rows& rows) {
    return plan_by_values(std::move(tables), sweep, "order", orders, rows);
}

}  // namespace libration::studies
