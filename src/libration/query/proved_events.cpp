#include "libration/query/proved_events.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "../equation/condition_system.hpp"
#include "event_list.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/scalar/error.hpp"
#include "small_divisor.hpp"

namespace libration::ode {

namespace {

// The state of an event of a system that has the condition as an unknown.
std::vector<ball> state_of(const proved_event& event, const std::optional<condition_system>& with) {
    if (!with) {
        return event.state;
    }
    std::vector<ball> state;
    for (const std::size_t place : with->places) {
        state.push_back(event.state[place]);
    }
    return state;
}

// What is known of the end of a search for zeros of g: a root of a multiple of g in the equations.
std::string cause_at_root(const explicit_system& system, const expression& g) {
    bool found = false;
    node_values<bool> seen;
    for (const expression& right : system.right()) {
        seen.of(right, [&](const expression& e) {
            found = found || (has_no_value_below_zero(e) && relative_sign(expression(e.left()), g) != 0);
            return true;
        });
    }
    return found
               ? "the equations contain a root of what has to become 0, which has no real value on one side, where an "
                 "event has to be proved on both: search for a small value instead, as y = 10^-15, or a smaller one "
                 "with more digits"
               : "";
}

}  // namespace

event_report searched_events(const explicit_system& system, const event_request& request, long digits,
                             const proof_route& route, const event_watch& watch, kept_integrations* kept) {
    const auto given = given_values(system, request.g);
    std::optional<condition_system> as_unknown;  // if g itself is too wide on sets of times
    std::vector<collocation_use> collocation;
    event_list list(names_of_state(system), request.count, digits, most_bits_of_event(digits), watch);
    event_report report = list.of_runs([&](long bits, run_demand& demand) {
        const precision_scope scope(decimal_digits(bits) + 10);
        const march_watch tell = [&](const ball& reached, long now) { list.tell(reached, now); };
        zero_search search =
            as_unknown ? zero_search(as_unknown->system, as_unknown->condition, bits, request.direction, route, tell)
            : kept != nullptr ? zero_search(system, request.g, kept_part{kept}, bits, request.direction, route, tell)
                              : zero_search(system, request.g, bits, request.direction, route, tell);
        const auto note_collocation = [&] {
            const collocation_use& used = search.collocation();
            collocation.assign(used.steps > 0 ? 1 : 0, used);
        };
        const auto add = [&](const proved_event& event) {
            note_collocation();
            list.add(event.time, with_given_values(state_of(event, as_unknown), given));
            list.tell(search.reached(), bits);
        };
        const auto beyond = [&] {
            note_collocation();
            if (search.end() == search_end::undecided && search.undecided().too_many_pieces && !as_unknown &&
                !system.singular()) {
                as_unknown = with_condition(system, request.g);
                demand.again();
            } else {
                list.continue_beyond(search, system.point(), request.direction, cause_at_root(system, request.g));
            }
        };
        find_events(list, search, request, add, beyond);
        demand.cost(search.steps());
    });
    report.collocation = std::move(collocation);
    return report;
}

std::vector<printed_event> proved_events(const explicit_system& system, const event_request& request, long digits,
                                         const proof_route& route) {
    const event_report report = searched_events(system, request, digits, route);
    if (report.missing) {
        throw error(*report.missing);
    }
    std::vector<printed_event> events;
    for (const known_event& each : report.events) {
        events.push_back({each.time.decimal.value(), {}});
        for (const known_value& value : each.values) {
            events.back().values.push_back(value.decimal.value());
        }
    }
    return events;
}

}  // namespace libration::ode
