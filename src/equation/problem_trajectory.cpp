#include "equation/problem_trajectory.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "equation/problem_reference.hpp"
#include "libration/ode/ball/fast_product.hpp"
#include "libration/ode/step.hpp"
#include "libration/ode/trajectory.hpp"
#include "libration/problem/axis.hpp"
#include "run/digits.hpp"
#include "run/grid.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* problem_times_remedy = "write times such as 0,1.5,sqrt(2) or a range 0:20:201";

// All values, one time after the other.
template <class T>
std::vector<mpfr> flat_states(const std::vector<ode::solution_state<T>>& states) {
    std::vector<mpfr> all;
    for (const auto& state : states) {
        for (const auto& of_unknown : state) {
            for (const T& value : of_unknown) {
                all.push_back(widen(value));
            }
        }
    }
    return all;
}

std::vector<mpfr> states_of(const ode::explicit_system& system, const std::vector<exact>& times,
                            const arithmetic& numbers) {
    std::vector<ode::number> at;
    at.reserve(times.size());
    for (const exact& each : times) {
        at.push_back(as_expression(each));
    }
    if (numbers.scalar.kind == scalar_kind::arbitrary) {
        return flat_states(
            ode::trajectory(system, at, std::max(numbers.digits, numbers.scalar.digits), ode::fast_product<mpfr>()));
    }
    return one_run(numbers.scalar, [&]<class T>() { return flat_states(ode::march_through<T>(system, at)); });
}

table table_of_states(const ode::explicit_system& system, const std::vector<exact>& times,
                      const std::vector<mpfr>& states, const arithmetic& numbers) {
    table data(columns_of_states(system));
    const std::size_t values = data.columns().size() - 4;
    const char* const rigour = numbers.scalar.kind == scalar_kind::arbitrary ? "two-method" : "heuristic";
    for (std::size_t i = 0; i < times.size(); ++i) {
        table_row_cells row{number_cell(decimal_of(times[i], numbers.digits))};
        for (std::size_t k = 0; k < values; ++k) {
            row.push_back(decimal_cell(states[i * values + k], numbers.digits));
        }
        row.emplace_back(numbers.digits);
        row.emplace_back(rigour);
        row.emplace_back(times[i].text);
        data.add_row(std::move(row));
    }
    return data;
}

}  // namespace

std::vector<column> columns_of_states(const ode::explicit_system& system) {
    std::vector<column> columns{{"time", ""}};
    for (const auto& each : system.unknowns()) {
        for (int j = 0; j < each.order; ++j) {
            columns.push_back({ode::primed(each.name, j), ""});
        }
    }
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}, {"time_typed", ""}});
    return columns;
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

table problem_trajectory(const ode::explicit_system& system, const std::vector<exact>& times,
                         const arithmetic& numbers) {
    if (numbers.scalar.kind == scalar_kind::proved) {
        return problem_reference(system, times, numbers.digits);
    }
    try {
        return table_of_states(system, times, states_of(system, times, numbers), numbers);
    } catch (const error& problem) {
        if (problem.subject() != "time" || problem.kind() != error_kind::argument) {
            throw;
        }
        throw input_error("--times", problem.value(), problem.reason(), "choose times nearer to the start");
    }
}

}  // namespace libration
