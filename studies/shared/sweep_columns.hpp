// What the tables of all sweeps over energies share: the columns of the energy, and the least order that they take.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "libration/problem/known/pendulum.hpp"
#include "sweep/study.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

/// The columns of rows with a member `at`, the energy of the sweep.
template <class Row>
column_of<Row> energy_column() {
    return {"energy", "E, in units of m g l", [](const Row& r) { return number_cell(r.at.energy); }};
}

template <class Row>
column_of<Row> gap_column() {
    return {"gap", "2 - E", [](const Row& r) { return number_cell(r.at.gap); }};
}

template <class Row>
column_of<Row> log10_gap_column() {
    return {"log10_gap", "log10 of |2 - E|", [](const Row& r) {
                const precision_scope scope(60);
                return log10_cell(abs(from_exact<mpfr>(exactly(2) - r.at.value)));
            }};
}

/// What was typed: these stand behind all others, and only where it is no decimal (tables_of).
template <class Row>
column_list<Row> typed_energy_columns() {
    return {{"energy_typed", "E as typed", [](const Row& r) { return cell(r.at.energy_typed); }},
            {"gap_typed", "2 - E as typed", [](const Row& r) { return cell(r.at.gap_typed); }}};
}

/// The columns with those of what was typed behind them.
template <class Row>
column_list<Row> with_typed_energy(column_list<Row> columns) {
    return joined(std::move(columns), typed_energy_columns<Row>());
}

/// The orders by size. Throws input_error where one is below `least`, which `is` why.
inline std::vector<int> sorted_orders(const study_request& request, int least, const std::string& is) {
    std::vector<int> orders = request.orders();
    std::sort(orders.begin(), orders.end());
    if (orders.front() < least) {
        throw input_error("--orders", std::to_string(orders.front()), is,
                          "write orders from " + std::to_string(least) + " on");
    }
    return orders;
}

/// The orders of a study that counts coefficients. Throws input_error for 0.
inline std::vector<int> numbers_of_coefficients(const study_request& request) {
    std::vector<int> counts = request.orders();
    for (const int count : counts) {
        if (count < 1) {
            throw input_error("--orders", std::to_string(count), "is no number of coefficients", "write 1 or more");
        }
    }
    return counts;
}

}  // namespace libration::studies
