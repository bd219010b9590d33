#include "event_options.hpp"

#include <fmt/format.h>

#include "libration/number/grid.hpp"
#include "problem_trajectory.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr int most_events = 100'000;
constexpr int most_steps = 10'000'000;

ode::crossing way_of(const std::string& word) {
    if (word != "up" && word != "down") {
        throw input_error("--crossing", word, "is not a direction", "write up or down, or leave it out");
    }
    return word == "up" ? ode::crossing::up : ode::crossing::down;
}

ode::number read_end(const std::string& before) {
    const auto end = times_of_problem(before);
    if (end.size() != 1) {
        throw input_error("--before", before, "is a list", "write one time");
    }
    return as_exact_real(end.front());
}

}  // namespace

int positive_count(const char* option, const std::string& value, int most, const char* of_what) {
    const std::string remedy = fmt::format("write a number of {}, 1 or more", of_what);
    const int count = reading(option, value, remedy, [&] { return read_count(value, most); });
    if (count == 0) {
        throw input_error(option, value, "is less than 1", remedy);
    }
    return count;
}

void event_options::add_to(CLI::App& command) {
    command.add_option("--until", until_, "with --problem: the times at which a condition holds, e.g. \"x' = 0\"")
        ->type_name("G=H");
    command.add_option("--count", count_, "number of events to find (default: 1)")->type_name("K");
    command.add_option("--crossing", way_, "only events where G - H increases (up) or decreases (down) with time")
        ->type_name("WAY");
    command.add_option("--before", before_, "only events before or at this time")->type_name("TIME");
    command.add_flag("--from-start", from_start_, "include the initial time if the condition holds there");
    command
        .add_option("--horizon", horizon_,
                    fmt::format("maximum number of steps without such an event (default: {}; none with --before)",
                                ode::zero_search::usual_horizon))
        ->type_name("STEPS");
    command.add_flag("--how-many", how_many_,
                     "with --before: how many events there are, for a set of solutions each possible number");
}

template <class Request>
void event_options::read_into(Request& request) const {
    if (way_) {
        request.way = way_of(*way_);
    }
    if (count_) {
        request.count = positive_count("--count", *count_, most_events, "events");
    }
    if (horizon_) {
        request.horizon = positive_count("--horizon", *horizon_, most_steps, "steps");
    }
    if (before_) {
        request.before = read_end(*before_);
    }
}

ode::set_event_request event_options::request_for_sets() const {
    ode::set_event_request request{.condition = *until_};
    read_into(request);
    return request;
}

ode::event_count_request event_options::request_for_counts() const {
    ode::event_count_request request{.condition = *until_, .before = read_end(*before_)};
    if (way_) {
        request.way = way_of(*way_);
    }
    return request;
}

ode::event_request event_options::request(const solution& of, const ode::explicit_system& system) const {
    ode::event_request request;
    request.g = naming_option("--until", [&] { return of.condition(*until_); });
    if (request.g.is_constant()) {
        throw input_error("--until", *until_, "is not a condition on the solution", "write one, such as \"x' = 0\"");
    }
    read_into(request);
    request.from_start = from_start_;
    if (request.before) {
        request.direction = (*request.before - system.point()).sign() < 0 ? -1 : 1;
    }
    return request;
}

}  // namespace libration
