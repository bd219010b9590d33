// The common columns of the tables of all sweeps over energies: those of the energy and of the expansion point.
#pragma once

#include <string>
#include <utility>

#include "libration/problem/known/pendulum.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

inline const sweep_energy& energy_of(const sweep_energy& at) { return at; }
inline const sweep_energy& energy_of(const sweep_energy* at) { return *at; }
inline const exact& point_of(const exact& point) { return point; }
inline const exact& point_of(const exact* point) { return *point; }

/// The columns of rows with a member `at`, the energy of the sweep; a pointer if other rows have none.
template <class Row>
column_of<Row> energy_column() {
    return {"energy", "E, in units of m g l", [](const Row& r) { return number_cell(energy_of(r.at).energy); }};
}

template <class Row>
column_of<Row> gap_column() {
    return {"gap", "2 - E", [](const Row& r) { return number_cell(energy_of(r.at).gap); }};
}

template <class Row>
column_of<Row> log10_gap_column() {
    return {"log10_gap", "log10 of |2 - E|", [](const Row& r) {
                const precision_scope scope(60);
                return log10_cell(abs(from_exact<mpfr>(exactly(2) - energy_of(r.at).value)));
            }};
}

/// The values as typed: these come after all others, and only if the value is not a decimal (tables_of).
template <class Row>
column_list<Row> typed_energy_columns() {
    return {{"energy_typed", "E as typed", [](const Row& r) { return cell(energy_of(r.at).energy_typed); }},
            {"gap_typed", "2 - E as typed", [](const Row& r) { return cell(energy_of(r.at).gap_typed); }}};
}

/// The expansion point of rows with a member `point`; a pointer if other rows have none.
template <class Row>
column_of<Row> point_column() {
    return {"point", "expansion point as a fraction of T*: 0 the top, 1 the bottom",
            [](const Row& r) { return read_cell(point_of(r.point).text); }};
}

/// The columns followed by those of the values as typed.
template <class Row>
column_list<Row> with_typed_energy(column_list<Row> columns) {
    return joined(std::move(columns), typed_energy_columns<Row>());
}

}  // namespace libration::studies
