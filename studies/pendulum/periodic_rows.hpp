// Common parts of the tables of periodic motions: the admissible energies, and the columns of a time.
#pragma once

#include <vector>

#include "../shared/sweep_columns.hpp"
#include "libration/pendulum/dimensionless_time.hpp"
#include "value_with_error.hpp"

namespace libration::studies {

/// Energies without a period, or without a motion.
inline std::vector<without_answer> without_period() {
    return no_answer_at_limits("the pendulum rests", "the period is infinite");
}

/// A time as two columns of a table: dimensionless, and in periods.
struct time_cells {
    cell time;
    cell periods;
};

inline std::vector<time_cells> cells_of(const pendulum::motion& m, const std::vector<exact>& times, long digits) {
    const precision_scope scope(digits + guard_digits);
    std::vector<time_cells> cells;
    cells.reserve(times.size());
    for (const exact& time : times) {
        cells.push_back({decimal_cell(dimensionless_time<mpfr>(m, time), digits),
                         decimal_cell(elapsed_periods<mpfr>(m, time), 12)});
    }
    return cells;
}

}  // namespace libration::studies
