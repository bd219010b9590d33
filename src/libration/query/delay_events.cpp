#include "libration/query/delay_events.hpp"

#include "../equation/condition_system.hpp"
#include "../integration/delay/delay_rule.hpp"
#include "event_list.hpp"

namespace libration::ode {

event_report searched_delay_events(const delay_system& system, const event_request& request, long digits,
                                   const event_watch& watch) {
    if (request.direction < 0) {
        throw error(error_kind::argument, error_subject::time, text_of_time(*request.before),
                    "is before the initial point, where the solution is the history: choose a time after it");
    }
    if (system.is_neutral()) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "is not supported with a delayed highest derivative, where slopes jump: choose times");
    }
    const explicit_system first = system.first_equations();  // up to the first breaking point
    const auto given = given_values(first, request.g);
    event_list list(names_of_state(system), request.count, digits, most_bits_of_event(digits), watch);
    return list.of_runs([&](long bits, run_demand& demand) {
        const precision_scope scope(decimal_digits(bits) + 10);
        integration along({constant_value<ball>::of(system.point()), {}, {}, {}},
                          std::make_shared<delay_rule>(system, bits), infinite_distance(1), bits);
        zero_search search(first, request.g, along, bits, [&](const ball& reached, long now) {
            along.forget_before(search.number_of_step());
            list.tell(reached, now);
        });
        const auto add = [&](const proved_event& event) {
            list.add(event.time, with_given_values(event.state, given));
            list.tell(search.reached(), bits);
        };
        find_events(list, search, request, add, [&] { list.continue_beyond(search, system.point(), 1); });
        demand.cost(search.steps());
    });
}

}  // namespace libration::ode
