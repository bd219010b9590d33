#include "set_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "libration/number/grid.hpp"
#include "libration/problem/axis.hpp"
#include "libration/scalar/ball/outward_decimals.hpp"
#include "problem_trajectory.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr int most_parts_of_box = 1'000'000;
constexpr long most_spans = 100'000;
constexpr const char* remedy_for_spans = "write a span of times A:B, or A:B:N for N spans of the same length";

// A line for each time or span, and one for each unknown.
partial_table table_of_enclosures(const ode::set_enclosures& found, const std::vector<std::vector<std::string>>& times,
                                  std::vector<column> columns, const std::vector<std::string>& typed, long digits) {
    columns.insert(columns.end(), {{"unknown", ""}, {"lower", ""}, {"upper", ""}, {"rigour", ""}});
    if (!typed.empty()) {
        columns.push_back({"time_typed", ""});
    }
    partial_table result{table(std::move(columns)), "", "", found.missing, {}};
    std::size_t width = std::string("time").size();
    for (const std::string& name : found.names) {
        width = std::max(width, name.size());
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (found.values[i].empty()) {
            continue;
        }
        result.text += fmt::format("{}{:<{}}  {}\n", result.text.empty() ? "" : "\n", "time", width,
                                   times[i].size() == 1 ? times[i].front() : times[i][0] + " to " + times[i][1]);
        for (std::size_t k = 0; k < found.names.size(); ++k) {
            const auto [lower, upper] = outward_decimals(found.values[i][k].lower, found.values[i][k].upper, digits);
            result.text += fmt::format("{:<{}}  in [{}, {}]\n", found.names[k], width, lower, upper);
            table_row_cells row;
            for (const std::string& time : times[i]) {
                row.push_back(number_cell(time));
            }
            row.insert(row.end(), {found.names[k], number_cell(lower), number_cell(upper), "proved"});
            if (!typed.empty()) {
                row.emplace_back(typed[i]);
            }
            result.rows.add_row(std::move(row));
        }
    }
    return result;
}

std::string counted(std::size_t count, const std::string& one) {
    return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

void state_parts(std::size_t parts, long all_steps, std::size_t faces, const ode::equation_system& equations) {
    const auto steps = counted(static_cast<std::size_t>(all_steps), "step");
    if (equations.sets.empty()) {
        say_line("the solution was enclosed in " + steps);
        return;
    }
    say_line(fmt::format(
        "the set of initial values and parameters was enclosed in {} and {}{}", counted(parts, "part"), steps,
        faces == 0 ? "" : ", and bounds of monotone values are those on " + counted(faces, "face") + " of it"));
}

// "2", "2 or 4", "0, 2 or 4".
std::string text_of_counts(const std::vector<long>& counts) {
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        text += (i == 0 ? "" : i + 1 < counts.size() ? ", " : " or ") + std::to_string(counts[i]);
    }
    return text;
}

// The result of a function of a callback that shows the time reached.
template <class Enclose>
auto with_progress(const Enclose& enclose) {
    progress shown("reference", progress_of_part::steps);
    progress_of_part to(shown);
    return enclose([&](const ball& reached, long bits) {
        const precision_scope scope(20);
        to.reached(midpoint_of(reached).convert_to<double>(), bits);
        to(0);
    });
}

// A paragraph for each event, and a line of it for its time and for each unknown.
partial_table table_of_events(const ode::set_events& found, long digits) {
    partial_table result{table({{"event", ""}, {"quantity", ""}, {"lower", ""}, {"upper", ""}, {"rigour", ""}}),
                         "",
                         "",
                         found.missing,
                         {}};
    std::size_t width = std::string("event").size();
    for (const std::string& name : found.names) {
        width = std::max(width, name.size());
    }
    for (std::size_t k = 0; k < found.events.size(); ++k) {
        const ode::enclosed_event& event = found.events[k];
        const std::string number = std::to_string(k + 1);
        result.text += fmt::format("{}{:<{}}  {}\n", result.text.empty() ? "" : "\n", "event", width, number);
        for (std::size_t i = 0; i <= found.names.size(); ++i) {
            const std::string& name = i == 0 ? "time" : found.names[i - 1];
            const ode::closed_interval& of = i == 0 ? event.time : event.values[i - 1];
            const auto [lower, upper] = outward_decimals(of.lower, of.upper, digits);
            result.text += fmt::format("{:<{}}  in [{}, {}]\n", name, width, lower, upper);
            result.rows.add_row({number_cell(number), name, number_cell(lower), number_cell(upper), "proved"});
        }
    }
    return result;
}

}  // namespace

void set_options::add_to(CLI::App& command) {
    command
        .add_option("--over", over_,
                    "with --problem: enclosures of the solution over all times from A to B, or over each of N equal "
                    "parts")
        ->type_name("A:B[:N]");
    command
        .add_option("--parts", parts_,
                    "with sets, x(0) = [0.9, 1.1] or k = 1 +- 0.1: maximum number of parts into which the set is "
                    "divided (default: 64)")
        ->type_name("N");
}

std::vector<exact> set_options::ends_of_spans() const {
    const auto colons = std::ranges::count(*over_, ':');
    if (colons != 1 && colons != 2) {
        throw input_error("--over", *over_, "is not a span of times", remedy_for_spans);
    }
    const auto last = over_->rfind(':');
    const std::string ends = colons == 1 ? *over_ : over_->substr(0, last);
    const int count = colons == 1 ? 1 : reading("--over", *over_, remedy_for_spans, [&] {
        return read_count(over_->substr(last + 1), most_spans);
    });
    if (count == 0) {
        throw input_error("--over", *over_, "has no span", remedy_for_spans);
    }
    auto times =
        reading("--over", *over_, remedy_for_spans, [&] { return read_grid(fmt::format("{}:{}", ends, count + 1)); });
    if (std::ranges::any_of(times, [](const exact& time) { return time.is_angle() || time.has_periods(); })) {
        throw input_error("--over", *over_, "has a time that is an angle or a period", remedy_for_spans);
    }
    const auto numbers = constants_of({times.front(), times.back()});
    if ((numbers[1] - numbers[0]).sign() < 0) {
        throw input_error("--over", *over_, "ends before it begins", "write the earlier time first");
    }
    return times;
}

std::size_t set_options::most_parts() const {
    if (!parts_) {
        return ode::set_request{}.most_parts;
    }
    const char* const remedy = "write a number of parts, 1 or more";
    const int count = reading("--parts", *parts_, remedy, [&] { return read_count(*parts_, most_parts_of_box); });
    if (count == 0) {
        throw input_error("--parts", *parts_, "is less than 1", remedy);
    }
    return static_cast<std::size_t>(count);
}

partial_table set_options::enclosures(const problem_options& problem, const std::optional<std::string>& times,
                                      long digits, const ode::proof_route& route) const {
    const auto equations = problem.equations();
    const auto given = over_ ? ends_of_spans() : times_of_problem(*times);
    const auto numbers = constants_of(given);
    ode::set_request request{.spans = {}, .most_parts = most_parts(), .digits = digits};
    std::vector<std::vector<std::string>> decimals;
    std::vector<std::string> typed;
    for (std::size_t i = 0; i + (over_ ? 1 : 0) < given.size(); ++i) {
        request.spans.push_back(over_ ? ode::time_span{numbers[i], numbers[i + 1]} : ode::at_time(numbers[i]));
        decimals.push_back(over_ ? std::vector{decimal_of(given[i], digits), decimal_of(given[i + 1], digits)}
                                 : std::vector{decimal_of(given[i], digits)});
        if (!over_) {
            typed.push_back(given[i].text);
        }
    }
    const auto found = problem.naming([&] {
        return with_progress(
            [&](const auto& watch) { return ode::enclosed_solutions(equations, request, watch, route); });
    });
    state_parts(found.parts, found.steps, found.faces, equations);
    return table_of_enclosures(
        found, decimals, over_ ? std::vector<column>{{"from", ""}, {"to", ""}} : std::vector<column>{{"time", ""}},
        typed, digits);
}

partial_table set_options::events(const problem_options& problem, ode::set_event_request request, long digits,
                                  const ode::proof_route& route) const {
    const auto equations = problem.equations();
    request.most_parts = most_parts();
    request.digits = digits;
    const auto found = problem.naming([&] {
        return with_progress([&](const auto& watch) { return ode::enclosed_events(equations, request, watch, route); });
    });
    state_parts(found.parts, found.steps, found.faces, equations);
    return table_of_events(found, digits);
}

partial_table set_options::event_counts(const problem_options& problem, ode::event_count_request request, long digits,
                                        const ode::proof_route& route) const {
    const auto equations = problem.equations();
    request.most_parts = most_parts();
    request.digits = digits;
    const auto found = problem.naming([&] {
        return with_progress([&](const auto& watch) { return ode::event_counts(equations, request, watch, route); });
    });
    state_parts(found.parts, found.steps, 0, equations);
    partial_table result{table(std::vector<column>{{"events", ""}, {"rigour", ""}}), "", "", found.missing, {}};
    for (const long count : found.counts) {
        result.rows.add_row({number_cell(std::to_string(count)), "proved"});
    }
    result.text = found.counts.empty() ? "" : "events  " + text_of_counts(found.counts) + "\n";
    if (found.counts.size() > 1 && equations.sets.empty()) {
        result.text +=
            "proved: one of these is the number of changes of sign; --count K finds the K-th event, or "
            "none, and counts a time at which 0 is only touched, too\n";
    }
    return result;
}

}  // namespace libration
