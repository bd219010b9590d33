#include "equation/problem_trajectory.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "libration/ode/constant_value.hpp"
#include "libration/ode/step.hpp"
#include "libration/ode/trajectory.hpp"
#include "libration/problem/axis.hpp"
#include "run/digits.hpp"
#include "run/grid.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* problem_times_remedy = "write times such as 0,1.5,sqrt(2) or a range 0:20:201";

// One march forwards and one backwards, in the order of the times.
template <class T>
std::vector<mpfr> states_by_march(const ode::explicit_system& system, const std::vector<exact>& times) {
    std::vector<T> at;
    for (const exact& each : times) {
        at.push_back(ode::constant_value<T>::of(as_expression(each)));
    }
    const T origin = ode::constant_value<T>::of(system.point());
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const bool after_a = at[a] >= origin;
        const bool after_b = at[b] >= origin;
        return after_a != after_b ? after_a : after_a ? at[a] < at[b] : at[a] > at[b];
    });
    std::vector<std::vector<mpfr>> rows(times.size());
    ode::taylor_march<T> march(system);
    for (const std::size_t i : order) {
        for (const auto& of_unknown : march.advance_to(at[i])) {
            for (const T& value : of_unknown) {
                rows[i].push_back(widen(value));
            }
        }
    }
    std::vector<mpfr> all;
    for (const auto& row : rows) {
        all.insert(all.end(), row.begin(), row.end());
    }
    return all;
}

std::vector<mpfr> states_in_digits(const ode::explicit_system& system, const std::vector<exact>& times, long digits) {
    std::vector<ode::number> at;
    for (const exact& each : times) {
        at.push_back(as_expression(each));
    }
    std::vector<mpfr> all;
    for (const auto& state : ode::trajectory(system, at, digits)) {
        for (const auto& of_unknown : state) {
            all.insert(all.end(), of_unknown.begin(), of_unknown.end());
        }
    }
    return all;
}

std::vector<mpfr> states_of(const ode::explicit_system& system, const std::vector<exact>& times,
                            const arithmetic& numbers) {
    if (numbers.scalar.kind == scalar_kind::arbitrary) {
        return states_in_digits(system, times, std::max(numbers.digits, numbers.scalar.digits));
    }
    return one_run(numbers.scalar, [&]<class T>() { return states_by_march<T>(system, times); });
}

table table_of_states(const ode::explicit_system& system, const std::vector<exact>& times,
                      const std::vector<mpfr>& states, const arithmetic& numbers) {
    std::vector<column> columns{{"time", ""}};
    for (const auto& each : system.unknowns()) {
        for (int j = 0; j < each.order; ++j) {
            columns.push_back({each.name + std::string(static_cast<std::size_t>(j), '\''), ""});
        }
    }
    const std::size_t values = columns.size() - 1;
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}, {"time_typed", ""}});
    table data(std::move(columns));
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
        throw input_error("--scalar", numbers.scalar.name(), "proves no way from the start to other times",
                          "use mpfr:" + std::to_string(numbers.scalar.digits));
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
