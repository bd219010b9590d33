// The Runge-Kutta solution that the paper compares its series with: on the separatrix, whose solution is closed.
#pragma once

#include <string>
#include <vector>

#include "libration/pendulum/march_error.hpp"
#include "sweep/study.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

/// A step, their number, and the arithmetic.
struct march {
    rational step;
    long steps;
    scalar_spec scalar;
};

/// The paper's Runge-Kutta integration, and those with 10 and 100 times its step, to t = 10.
inline std::vector<march> marches_of(const rational& step) {
    const rational end = 10;
    std::vector<march> marches;
    for (const int factor : {100, 10, 1}) {
        const rational longer = step * factor;
        if (factor == 1 || longer <= end) {
            const long steps = reading("--step", decimal_of(longer, 50), "write a step such as 1e-5",
                                       [&] { return pendulum::march_steps(longer, end); });
            marches.insert(marches.end(),
                           {{longer, steps, read_scalar("double")}, {longer, steps, read_scalar("long-double")}});
        }
    }
    return marches;
}

/// A Runge-Kutta solution compared with the closed-form solution.
struct march_row {
    march of;
    pendulum::march_error found;
    mpfr norm_in_epsilon;
};

inline const column_list<march_row>& baseline_columns() {
    using row = march_row;
    static const column_list<row> all{
        {"energy", "E, in units of m g l: 2, where the solution is closed",
         [](const row&) { return number_cell("2"); }},
        {"step", "dt of the classical Runge-Kutta method, dimensionless time",
         [](const row& r) { return number_cell(decimal_of(r.of.step, 50)); }},
        {"scalar", "arithmetic of the march", [](const row& r) { return r.of.scalar.name(); }},
        {"steps", "number of steps from (theta, omega) = (0, 2) to about t = 10",
         [](const row& r) { return r.of.steps; }},
        {"norm", "max of |theta by the march - theta| at 2000 of the steps, radians",
         [](const row& r) { return decimal_cell(r.found.norm, r.of.scalar.digits); }},
        {"time_of_maximum", "dimensionless time",
         [](const row& r) { return decimal_cell(r.found.time, r.of.scalar.digits); }},
        {"norm_in_epsilon", "norm over the unit in the last place of 1",
         [](const row& r) { return decimal_cell(r.norm_in_epsilon, 6); }},
        {"norm_without_growth", "max of |theta by the march - theta| e^-t, radians",
         [](const row& r) { return decimal_cell(r.found.undone, r.of.scalar.digits); }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.found.norm); }},
    };
    return all;
}

template <fixed_scalar T>
march_row march_in(const march& m) {
    constexpr int samples = 2000;
    const auto found = pendulum::separatrix_march_error<T>(m.step, m.steps, samples);
    return {m, found, mpfr(found.norm / widen(epsilon<T>()))};
}

inline march_row solved(const march& m) {
    const precision_scope scope(60);
    return m.scalar.kind == scalar_kind::binary64 ? march_in<double>(m) : march_in<long double>(m);
}

/// A cell for an integration: its row in the table with this index, the last one.
inline cell_group group_of_march(const march& m, std::size_t table_of_marches) {
    return {{{{"step", decimal_of(m.step, 50)}, {"scalar", m.scalar.name()}}},
            [m, table_of_marches](const std::vector<std::size_t>& /*the only one*/) {
                cell_rows rows(table_of_marches + 1);
                rows.back() = make_table(baseline_columns(), std::vector<march_row>{solved(m)}).rows();
                return std::vector<cell_rows>{std::move(rows)};
            }};
}

}  // namespace libration::studies
