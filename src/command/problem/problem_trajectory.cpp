#include "problem_trajectory.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "libration/equation/constant_value.hpp"
#include "libration/number/grid.hpp"
#include "libration/problem/axis.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* problem_times_remedy = "write times such as 0,1.5,sqrt(2) or a range 0:20:201";

constexpr long digits_beyond = 20;

cell decimal_of_constant(const ode::number& x, long digits) {
    const auto exactly = x.fraction();
    const precision_scope scope(digits + digits_beyond);
    return exactly ? number_cell(decimal_of(*exactly, digits)) : decimal_cell(ode::constant_value<mpfr>::of(x), digits);
}

table table_along(const answer& found, const std::vector<typed_point>& times, long digits) {
    std::vector<column> columns{{"time_re", ""}, {"time_im", ""}};
    for (const std::string& name : found.names) {
        columns.push_back({name, ""});
    }
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}, {"time_typed", ""}});
    if (!found.drifts.empty()) {
        columns.push_back({"invariant_drift", ""});
    }
    table data(std::move(columns));
    for (std::size_t i = 0; i < times.size(); ++i) {
        table_row_cells row{decimal_of_constant(times[i].value.re, digits),
                            decimal_of_constant(times[i].value.im, digits)};
        for (const answer_value& value : found.rows[i]) {
            row.push_back(cell::number(value.text, digits));
        }
        row.insert(row.end(), {cell(digits), cell(found.rigour), cell(times[i].text)});
        if (!found.drifts.empty()) {
            row.push_back(number_cell(found.drifts[i]));
        }
        data.add_row(std::move(row));
    }
    return data;
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
        at.push_back(as_exact_real(each));
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
        found.missing =
            error(error_kind::undecided, error_subject::time, found.missing->value(), found.missing->reason());
    }
    return found;
}

table problem_trajectory_along(const solution& of, const std::vector<ode::complex_constant>& corners,
                               const std::vector<typed_point>& times, const arithmetic& numbers) {
    if (numbers.scalar.kind == scalar_kind::proved) {
        throw input_error("--scalar", numbers.scalar.name(), "cannot prove a path in the complex plane",
                          "use mpfr:" + std::to_string(numbers.scalar.digits));
    }
    complex_path_request along{.times = {}, .corners = corners};
    std::ranges::transform(times, std::back_inserter(along.times), &typed_point::value);
    try {
        return table_along(of.states_along(along, {.scalar = numbers.scalar, .digits = numbers.digits}), times,
                           numbers.digits);
    } catch (const error& problem) {
        if (!problem.is_about(error_subject::point) || problem.kind() != error_kind::argument) {
            throw;
        }
        throw input_error(corners.empty() ? "--times" : "--via with --times", problem.value(), problem.reason(),
                          "give a path around the singularity by its corners, --via \"1+i,2+i\"");
    }
}

}  // namespace libration
