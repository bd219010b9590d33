#include "motion/event_options.hpp"

#include <fmt/format.h>

#include <utility>

#include "equation/problem_trajectory.hpp"
#include "libration/ode/parse.hpp"
#include "run/grid.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr int most_events = 100'000;
constexpr int most_steps = 10'000'000;

int positive_count(const char* option, const std::string& value, int most, const char* of_what) {
    const std::string remedy = fmt::format("write a number of {}, 1 or more", of_what);
    const int count = reading(option, value, remedy, [&] { return read_count(value, most); });
    if (count == 0) {
        throw input_error(option, value, "is less than 1", remedy);
    }
    return count;
}

ode::crossing way_of(const std::string& word) {
    if (word != "up" && word != "down") {
        throw input_error("--crossing", word, "is not a direction", "write up or down, or leave it out");
    }
    return word == "up" ? ode::crossing::up : ode::crossing::down;
}

}  // namespace

void event_options::add_to(CLI::App& command) {
    command.add_option("--until", until_, "of a problem: the times of an event, \"x' = 0\"")->type_name("G=H");
    command.add_option("--count", count_, "so many of them (1)")->type_name("K");
    command.add_option("--crossing", way_, "those where G - H passes 0 this way as time increases: up or down")
        ->type_name("WAY");
    command.add_option("--before", before_, "those alone that are certainly before this time or at it")
        ->type_name("TIME");
    command.add_flag("--from-start", from_start_, "the start too, where the condition holds there");
    command
        .add_option("--horizon", horizon_,
                    fmt::format("give up after so many steps without an event ({}; with --before only where given)",
                                ode::event_search::usual_horizon))
        ->type_name("STEPS");
}

void event_options::require_none() const {
    for (const auto& [option, value] : {std::pair("--count", count_), std::pair("--crossing", way_),
                                        std::pair("--before", before_), std::pair("--horizon", horizon_)}) {
        if (value) {
            throw input_error(option, *value, "is of an event and there is none", "add --until \"x = 0\"");
        }
    }
    if (from_start_) {
        throw input_error("--from-start is of an event and there is none: add --until \"x = 0\"");
    }
}

ode::event_request event_options::request(const problem_options& problem, const ode::explicit_system& system) const {
    ode::event_request request;
    request.g = naming_option("--until", [&] { return ode::parse_condition(problem.equations(), *until_); });
    if (request.g.is_constant()) {
        throw input_error("--until", *until_, "is no condition on the solution", "write one, such as \"x' = 0\"");
    }
    if (way_) {
        request.way = way_of(*way_);
    }
    if (count_) {
        request.count = positive_count("--count", *count_, most_events, "events");
    }
    if (horizon_) {
        request.horizon = positive_count("--horizon", *horizon_, most_steps, "steps");
    }
    request.from_start = from_start_;
    if (before_) {
        const auto end = times_of_problem(*before_);
        if (end.size() != 1) {
            throw input_error("--before", *before_, "is a list", "write one time");
        }
        request.before = as_expression(end.front());
        request.direction = (*request.before - system.point()).sign() < 0 ? -1 : 1;
    }
    return request;
}

}  // namespace libration
