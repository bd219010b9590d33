// Zeros of functions along hybrid solutions to proved digits.
#include <string>
#include <utility>

#include "../hybrid/path_limits.hpp"
#include "event_list.hpp"
#include "libration/query/hybrid_trajectory.hpp"
#include "shown_values.hpp"

namespace libration::ode {

namespace {

// After a search that did not find the next event: with more bits, if they help.
void continue_beyond(event_list& list, run_demand& demand, const hybrid_path& path, long horizon, long digits) {
    if (path.end() == path_end::time) {
        list.end("is not found before that time: " + std::to_string(list.found()) + " were found");
    } else if (path.end() == path_end::horizon) {
        list.end("is not found within " + std::to_string(horizon) + " steps " + events_text(path) +
                 ": give an end of the search, or a larger horizon");
    } else {
        demand_of_path(demand, path, digits, list.name_of_next());
    }
}

}  // namespace

event_report searched_hybrid_events(const hybrid_system& system, const event_request& request, long digits,
                                    const proof_route& route, const event_watch& watch) {
    const bool compares = route.integrator == integrator_choice::comparison;
    if (compares || route.integrator == integrator_choice::collocation) {
        throw error(
            error_kind::argument, error_subject::integrator, compares ? "comparison" : "collocation",
            "is not supported for a problem with events or a piecewise right-hand side: use automatic or taylor");
    }
    if (request.direction < 0 || request.from_start) {
        throw error(error_kind::argument, "event", "",
                    request.from_start ? "of a problem with events or piecewise right-hand sides is searched after the "
                                         "initial point: leave out the initial time"
                                       : "of a problem with events or piecewise right-hand sides is searched forwards "
                                         "only: choose an end after the initial point");
    }
    const long horizon = request.horizon.value_or(zero_search::usual_horizon);
    std::vector<std::string> by_relation;
    event_list list(names_with_shown(system), request.count, digits, most_bits_of_path(digits), watch);
    event_report report = list.of_runs([&](long bits, run_demand& demand) {
        const auto watch_steps = [&](const ball& reached, long now) { list.tell(reached, now); };
        hybrid_path path(system, bits, route, watch_steps, &request.g, request.way);
        const precision_scope scope(decimal_digits(bits) + 10);
        while (list.continues()) {
            const auto event = path.next_observed(request.before, horizon);
            by_relation = path.by_relation();
            if (!event) {
                continue_beyond(list, demand, path, horizon, digits);
                break;
            }
            const bool is_before = !request.before ||
                                   (event->exactly && (*request.before - *event->exactly).sign() >= 0) ||
                                   list.is_before(*request.before, event->time, 1);
            if (!is_before) {
                break;
            }
            auto values = event->state;
            append_shown(values, system, path.piece().system, path.piece().steps, event->time);
            list.add(event->time, values);
            list.tell(event->time, bits);
        }
        demand.cost(path.steps());
    });
    report.by_relation = std::move(by_relation);
    return report;
}

}  // namespace libration::ode
