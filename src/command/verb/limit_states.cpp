#include "limit_states.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "libration/number/given_number.hpp"
#include "libration/scalar/list_items.hpp"
#include "plot/solution_plot.hpp"
#include "problem/problem_trajectory.hpp"
#include "problem/solution_table.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

constexpr long drawn_times = 301;

// Times as of a problem, and the ends.
std::vector<exact> times_with_ends(const std::string& words) {
    std::vector<exact> times;
    for (const std::string_view item : list_items(words)) {
        std::string each(item);
        std::erase(each, ' ');
        if (each == "inf" || each == "-inf") {
            times.push_back({0, unit::one, each});
            continue;
        }
        const auto finite = times_of_problem(each);
        times.insert(times.end(), finite.begin(), finite.end());
    }
    return times;
}

std::vector<std::string> decimals_of(const std::vector<exact>& times, long digits) {
    std::vector<std::string> decimals;
    for (const exact& each : times) {
        decimals.push_back(each.text == "inf" || each.text == "-inf" ? each.text : decimal_of(each, digits));
    }
    return decimals;
}

// The time, and what has a limit.
std::string axes_of_limits(const limit_problem& of) {
    std::vector<std::string> names{"t"};
    for (const std::string& each : of.conditions) {
        const std::string name = trimmed(each.substr(0, each.find('(')));
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    }
    return fmt::format("{}", fmt::join(names, ","));
}

}  // namespace

int write_limit_states(const taken_limits& of, const limit_states_request& asked, const problem_options& problem_of,
                       const output_options& output, plot_axes plot) {
    plot.use_if_empty(axes_of_limits(of.problem));
    const auto figure = plot.file(output);
    const limit_solution solution(of.problem);
    progress indicator("reference", 1);
    const request how{
        .scalar = {scalar_kind::proved, asked.digits}, .check = asked.check, .reached = [&](double time, long bits) {
            indicator.reached(time, bits);
            check_time();
        }};
    const auto times = asked.times ? times_with_ends(*asked.times) : solution.visible_times(drawn_times, how);
    answer found = solution.states(times, of.shown, how);
    const auto notes = std::exchange(found.notes, {});
    const auto table_of_states = states_table(found, times, decimals_of(times, asked.digits), asked.digits);
    if (table_of_states.has_output()) {
        if (figure) {
            figure->draw(solution_plot({{"", table_of_states.rows}}, plot, std::nullopt, problem_of.heading()));
        }
        table_output(output, figure)
            .write(table_of_states.rows, asked.as_lines ? std::optional(table_of_states.text) : std::nullopt);
    }
    for (const answer_note& each : notes) {
        if (!is_shown(each, of.shown)) {
            say_line(each.name + ": " + each.text);
        }
    }
    say_missing(of.shown, notes);
    require_complete(table_of_states);
    return 0;
}

}  // namespace libration
