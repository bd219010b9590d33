// The error norms of an approximation as they are printed by the study error_norm.
#pragma once

#include <optional>
#include <string>

#include "shared/equation_plan.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/unknown_on_interval.hpp"

namespace libration::studies::error_norm_study {

/// A norm and its time as they are printed; empty if there is no such approximant.
struct norm_row {
    int order;
    std::string method;
    const scalar_spec& scalar;
    cell norm = {};
    cell time = {};
    cell log10_norm = {};
    std::string rigour = {};
    std::optional<mpfr> bound = {};    ///< of the pendulum
    const sweep_energy* at = nullptr;  ///< of the pendulum
    std::string unknown = {};          ///< of an equation
};

/// All columns of norms, from which the tables of the pendulum and of an equation choose, with the meanings of the
/// latter.
inline const column_list<norm_row>& columns() {
    using row = norm_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"order", "N, last power of the series about the start", [](const row& r) { return r.order; }},
        {"method",
         "series | pade: [m/m] with 2 m <= N, without the powers that a symmetry leaves out | endpoint: with value and "
         "slope of the far end of the times | euler: in s/(s + R), or in that of the powers that a symmetry leaves | "
         "gauge: in 1 - exp(-s/R), s from the start, R the radius that the coefficients show; not proved",
         [](const row& r) { return r.method; }},
        {"norm",
         "max of |approximation - solution| over the times, in the unit of the unknown; empty where that is not "
         "decided",
         [](const row& r) { return r.norm; }},
        {"time_of_maximum", "which of the times, in the unit of the variable; empty where the norm is 0",
         [](const row& r) { return r.time; }},
        {"scalar", "arithmetic of the approximation", [](const row& r) { return r.scalar.name(); }},
        {"rigour",
         "two-method: two marches and series of other precisions agree | heuristic | proved: with --scalar ball:D | "
         "not decided: no precision tells it from 0, as where the approximation is the solution",
         [](const row& r) { return r.rigour; }},
        gap_column<row>(),
        {"bound", "theorem A (series) or A2 (resummed), radians; empty below the orders where they hold",
         [](const row& r) { return decimal_cell(r.bound, 12); }},
        {"log10_norm", "log10 of norm", [](const row& r) { return r.log10_norm; }},
        {"log10_bound", "log10 of bound", [](const row& r) { return log10_cell(r.bound); }},
        log10_gap_column<row>(),
        unknown_column<row>(),
    });
    return all;
}

/// Those of the pendulum.
inline const column_list<norm_row>& columns_of_pendulum() {
    static const auto all = columns_named(
        "energy,order,method,norm,time_of_maximum,scalar,rigour,gap,bound,log10_norm,log10_bound,log10_gap,"
        "energy_typed,gap_typed",
        with_meanings(columns(),
                      {{"order", "N, last power of the series; last index of the resummed series"},
                       {"method", "series | resummed"},
                       {"norm", "max of |approximation - theta| over [0, T*], radians"},
                       {"time_of_maximum", "dimensionless time since the top; with ball the digits that are proved"},
                       {"rigour", "proved | two-method: confirmed by the sum over separatrix solutions | heuristic"}}));
    return all;
}

/// Those of an equation.
inline const column_list<norm_row>& columns_of_equation() {
    static const auto all =
        columns_named("order,method,norm,time_of_maximum,scalar,rigour,log10_norm,unknown", columns());
    return all;
}

/// The norms of an equation that are requested.
struct question {
    shared_equation_sweep sweep;
    std::vector<ode::number> times;
    std::vector<exact> typed_times;
    scalar_spec scalar;

    norm_row row(int order, approximation method, int unknown) const {
        return {.order = order, .method = name_of(method), .scalar = scalar, .unknown = sweep->name_of(unknown)};
    }
    cell time(std::size_t place) const { return number_cell(decimal_of(typed_times[place], 50)); }
};

}  // namespace libration::studies::error_norm_study
