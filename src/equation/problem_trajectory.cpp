#include "equation/problem_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "libration/digits/proved/printed_values.hpp"
#include "libration/ode/ball/fast_product.hpp"
#include "libration/ode/invariant.hpp"
#include "libration/ode/path.hpp"
#include "libration/ode/trajectory.hpp"
#include "libration/problem/axis.hpp"
#include "run/grid.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* problem_times_remedy = "write times such as 0,1.5,sqrt(2) or a range 0:20:201";

using complex = complex_number<mpfr>;

// In the arithmetic that prints them.
template <class T>
std::vector<ode::solution_state<complex>> in_wide_numbers(
    const std::vector<ode::solution_state<complex_number<T>>>& states) {
    std::vector<ode::solution_state<complex>> all;
    for (const auto& state : states) {
        auto& wide = all.emplace_back();
        for (const auto& of_unknown : state) {
            auto& values = wide.emplace_back();
            for (const auto& value : of_unknown) {
                values.push_back({widen(value.re), widen(value.im)});
            }
        }
    }
    return all;
}

// The minimum number of digits with which integrations work beyond those of the result.
constexpr long digits_beyond = 20;

long digits_of_march(const arithmetic& numbers) { return std::max(numbers.digits, numbers.scalar.digits); }

std::vector<ode::solution_state<complex>> states_along(const ode::explicit_system& system,
                                                       const std::vector<ode::complex_constant>& corners,
                                                       const std::vector<ode::complex_constant>& times,
                                                       const arithmetic& numbers) {
    if (numbers.scalar.kind == scalar_kind::arbitrary) {
        return ode::trajectory_along(system, corners, times, digits_of_march(numbers));
    }
    const precision_scope wide(numbers.scalar.digits + digits_beyond);
    return with_scalar(numbers.scalar, 0,
                       [&]<class T>() { return in_wide_numbers(ode::states_along<T>(system, corners, times)); });
}

// The largest change of an invariant at each time; empty if the problem states none or its initial point is singular.
std::vector<cell> drifts_of(const ode::explicit_system& system, const std::vector<ode::complex_constant>& times,
                            const std::vector<ode::solution_state<complex>>& states, const arithmetic& numbers) {
    std::vector<cell> drifts;
    if (system.invariants().empty() || system.singular()) {
        return drifts;
    }
    const precision_scope scope(digits_of_march(numbers) + digits_beyond);
    ode::invariants<complex> constant(system);
    for (std::size_t i = 0; i < times.size(); ++i) {
        drifts.push_back(decimal_cell(constant.drift(ode::constant_value<complex>::of(times[i]), states[i]), 3));
    }
    return drifts;
}

const char* rigour_of_march(const arithmetic& numbers) {
    return numbers.scalar.kind == scalar_kind::arbitrary ? "two-method" : "heuristic";
}

// <time>,<values>,digits,rigour,time_typed, and the drifts if there are any.
table table_with(std::vector<column> columns, const std::vector<cell>& drifts,
                 const std::vector<table_row_cells>& times_and_values, const std::vector<std::string>& typed,
                 const arithmetic& numbers) {
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}, {"time_typed", ""}});
    if (!drifts.empty()) {
        columns.push_back({"invariant_drift", ""});
    }
    table data(std::move(columns));
    for (std::size_t i = 0; i < typed.size(); ++i) {
        table_row_cells row = times_and_values[i];
        row.emplace_back(numbers.digits);
        row.emplace_back(rigour_of_march(numbers));
        row.emplace_back(typed[i]);
        if (!drifts.empty()) {
            row.push_back(drifts[i]);
        }
        data.add_row(std::move(row));
    }
    return data;
}

cell decimal_of_constant(const ode::number& x, long digits) {
    const auto exactly = x.fraction();
    const precision_scope scope(digits + digits_beyond);
    return exactly ? number_cell(decimal_of(*exactly, digits)) : decimal_cell(ode::constant_value<mpfr>::of(x), digits);
}

table table_along(const ode::explicit_system& system, const std::vector<ode::complex_constant>& corners,
                  const std::vector<typed_point>& times, const arithmetic& numbers) {
    std::vector<ode::complex_constant> at;
    std::vector<std::string> typed;
    for (const typed_point& each : times) {
        at.push_back(each.value);
        typed.push_back(each.text);
    }
    const auto states = states_along(system, corners, at, numbers);
    std::vector<column> columns{{"time_re", ""}, {"time_im", ""}};
    for (const std::string& name : ode::names_of_state(system)) {
        columns.push_back({name + "_re", ""});
        columns.push_back({name + "_im", ""});
    }
    std::vector<table_row_cells> rows;
    for (std::size_t i = 0; i < at.size(); ++i) {
        auto& row = rows.emplace_back(table_row_cells{decimal_of_constant(at[i].re, numbers.digits),
                                                      decimal_of_constant(at[i].im, numbers.digits)});
        for (const auto& of_unknown : states[i]) {
            for (const complex& value : of_unknown) {
                row.push_back(decimal_cell(value.re, numbers.digits));
                row.push_back(decimal_cell(value.im, numbers.digits));
            }
        }
    }
    return table_with(std::move(columns), drifts_of(system, at, states, numbers), rows, typed, numbers);
}

}  // namespace

std::vector<column> columns_of_states(const ode::explicit_system& system) {
    std::vector<column> columns{{"time", ""}};
    for (const std::string& name : ode::names_of_state(system)) {
        columns.push_back({name, ""});
    }
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}, {"time_typed", ""}});
    return columns;
}

std::vector<ode::number> constants_of(const std::vector<exact>& times) {
    std::vector<ode::number> at;
    at.reserve(times.size());
    for (const exact& each : times) {
        at.push_back(as_expression(each));
    }
    return at;
}

std::vector<exact> times_of_problem(const std::string& words) {
    auto times = reading("--times", words, problem_times_remedy, [&] { return read_grid(words); });
    for (const exact& time : times) {
        if (time.measure == unit::degree || time.has_periods()) {
            throw input_error("--times", words,
                              time.has_periods() ? "has '" + time.text + "', and a problem has no period T"
                                                 : "has the angle '" + time.text + "'",
                              problem_times_remedy);
        }
    }
    return times;
}

void refuse_times(const error& missing) {
    throw input_error("--times", missing.value(), missing.reason(), "choose times nearer to the initial point");
}

partial_table problem_trajectory(const solution& of, const std::vector<exact>& times, const arithmetic& numbers,
                                 const std::function<void(double)>& progress, ode::integrator_choice integrator) {
    partial_table found = states_table(
        of, times,
        {.scalar = numbers.scalar, .digits = numbers.digits, .progress = progress, .integrator = integrator});
    if (found.missing && found.missing->kind() == error_kind::argument) {
        if (found.rows.rows().empty()) {
            refuse_times(*found.missing);
        }
        found.missing = error(error_kind::undecided, "time", found.missing->value(), found.missing->reason());
    }
    return found;
}

table problem_trajectory_along(const ode::explicit_system& system, const std::vector<ode::complex_constant>& corners,
                               const std::vector<typed_point>& times, const arithmetic& numbers) {
    if (numbers.scalar.kind == scalar_kind::proved) {
        throw input_error("--scalar", numbers.scalar.name(), "cannot prove a path in the complex plane",
                          "use mpfr:" + std::to_string(numbers.scalar.digits));
    }
    try {
        return table_along(system, corners, times, numbers);
    } catch (const error& problem) {
        if (problem.subject() != "point" || problem.kind() != error_kind::argument) {
            throw;
        }
        throw input_error(corners.empty() ? "--times" : "--via with --times", problem.value(), problem.reason(),
                          "give a path around the singularity by its corners, --via \"1+i,2+i\"");
    }
}

}  // namespace libration
