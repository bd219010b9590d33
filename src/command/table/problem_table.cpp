#include "table/problem_table.hpp"

#include <algorithm>
#include <utility>

#include "libration/problem/axis.hpp"
#include "problem/problem_trajectory.hpp"

namespace libration {

namespace {

// The names of the values of a row, and in programs, where a prime has no place.
std::vector<column> columns_of(const ode::explicit_system& system, input_style style) {
    std::vector<column> columns{{"time", "of the problem: its variable " + system.variable()}};
    for (const auto& unknown : system.unknowns()) {
        for (int j = 0; j < unknown.order; ++j) {
            const std::string name = ode::primed(unknown.name, j);
            const std::string in_programs = j == 0 ? name : unknown.name + "_d" + std::to_string(j);
            columns.push_back({style == input_style::typed ? name : in_programs, name});
        }
    }
    return columns;
}

}  // namespace

table problem_table(const table_problem& of, const std::vector<exact>& times, long digits, input_style style) {
    const auto columns = columns_of(of.system, style);
    const partial_table values = problem_trajectory(*of.solution, times, {{scalar_kind::proved, digits}, digits});
    if (values.missing) {
        refuse_times(*values.missing);
    }
    table result = [&] {
        auto all = columns;
        if (style == input_style::typed) {
            all.insert(all.end(), {{"digits", "significant digits"}, {"rigour", ""}, {"time_typed", "as typed"}});
        }
        return table(std::move(all));
    }();
    for (std::size_t i = 0; i < times.size(); ++i) {
        table_row_cells row = values.rows.rows()[i];
        row[0] = number_cell(style == input_style::typed ? decimal_of(times[i], digits + more_input_digits)
                                                         : decimal_text(times[i], digits + more_input_digits));
        row.resize(result.columns().size());
        result.add_row(std::move(row));
    }
    return result;
}

}  // namespace libration
