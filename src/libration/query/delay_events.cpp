#include "libration/query/delay_events.hpp"

#include "../equation/condition_system.hpp"
#include "../integration/delay/delay_rule.hpp"
#include "event_list.hpp"

namespace libration::ode {

namespace {

class delay_event_runs {
public:
    delay_event_runs(const delay_system& system, const event_request& request, long digits, const event_watch& watch)
        : system_(system),
          first_(system.first_equations()),
          request_(request),
          watch_(watch),
          given_(given_values(first_, request.g)),
          list_(names_of_state(system), request.count, digits, most_bits_of_event(digits)) {}

    event_report result() {
        return list_.of_runs([this] { return steps_of_run(); });
    }

private:
    // One run, and the number of its steps.
    long steps_of_run() {
        const precision_scope scope(decimal_digits(list_.bits()) + 10);
        const long bits = list_.bits();
        integration along({constant_value<ball>::of(system_.point()), {}, {}, {}},
                          std::make_shared<delay_rule>(system_, bits), infinite_distance(1), bits);
        zero_search search(first_, request_.g, along, bits, [&](const ball& reached, long bits_of_run) {
            along.forget_before(search.number_of_step());
            tell(reached, bits_of_run);
        });
        find_events(
            list_, search, request_,
            [&](const proved_event& event) {
                list_.add(event.time, with_given_values(event.state, given_));
                tell(search.reached(), list_.bits());
            },
            [&] { list_.continue_beyond(search, system_.point(), 1); });
        return search.steps();
    }

    void tell(const ball& reached, long bits) const {
        if (watch_) {
            watch_(reached, bits, list_.known());
        }
    }

    const delay_system& system_;
    explicit_system first_;  // the equations up to the first breaking point
    const event_request& request_;
    const event_watch& watch_;
    std::vector<std::optional<number>> given_;
    event_list list_;
};

}  // namespace

event_report searched_delay_events(const delay_system& system, const event_request& request, long digits,
                                   const event_watch& watch) {
    if (request.direction < 0) {
        throw error(error_kind::argument, "time", text_of_time(*request.before),
                    "is before the initial point, where the solution is the history: choose a time after it");
    }
    if (system.is_neutral()) {
        throw error(error_kind::argument, "problem", "",
                    "is not supported with a delayed highest derivative, where slopes jump: choose times");
    }
    return delay_event_runs(system, request, digits, watch).result();
}

}  // namespace libration::ode
