// What the tables of motions with a period share: which energies they take, and how they say a time.
#pragma once

#include <string>
#include <vector>

#include "judged.hpp"
#include "libration/pendulum/time/dimensionless_time.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

using table_rows = std::vector<std::vector<std::string>>;

/// Refuses, before any work, the energies that have no period or no motion.
inline void require_period(const std::vector<sweep_energy>& energies) {
    refuse_limits(energies, "the pendulum rests", "the period is infinite");
}

/// A time as the two columns of a table: dimensionless, and in periods.
struct time_cells {
    std::string time;
    std::string periods;
};

inline std::vector<time_cells> cells_of(const motion& m, const std::vector<exact>& times, long digits) {
    const precision_scope scope(digits + guard_digits);
    std::vector<time_cells> cells;
    cells.reserve(times.size());
    for (const exact& time : times) {
        cells.push_back(
            {to_decimal(dimensionless_time<mpfr>(m, time), digits), to_decimal(elapsed_periods<mpfr>(m, time), 12)});
    }
    return cells;
}

}  // namespace libration::studies
