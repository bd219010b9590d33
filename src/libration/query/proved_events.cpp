#include "libration/query/proved_events.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "../equation/condition_system.hpp"
#include "event_list.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

class event_runs {
public:
    event_runs(const explicit_system& system, const event_request& request, long digits, const proof_route& route,
               const event_watch& watch)
        : system_(system),
          request_(request),
          route_(route),
          watch_(watch),
          given_(given_values(system, request.g)),
          list_(names_of_state(system), request.count, digits, most_bits_of_event(digits)) {}

    event_report result() {
        event_report report = list_.of_runs([this] { return steps_of_run(); });
        report.collocation = std::move(collocation_);
        return report;
    }

private:
    // One run, and the number of its steps.
    long steps_of_run() {
        const precision_scope scope(decimal_digits(list_.bits()) + 10);
        zero_search search(as_unknown_ ? as_unknown_->system : system_,
                           as_unknown_ ? as_unknown_->condition : request_.g, list_.bits(), request_.direction, route_,
                           [&](const ball& reached, long bits) { tell(reached, bits); });
        const auto note_collocation = [&] {
            const collocation_use& used = search.collocation();
            collocation_.assign(used.steps > 0 ? 1 : 0, used);
        };
        find_events(
            list_, search, request_,
            [&](const proved_event& event) {
                note_collocation();
                list_.add(event.time, with_given_values(state_of(event), given_));
                tell(search.reached(), list_.bits());
            },
            [&] {
                note_collocation();
                continue_beyond(search);
            });
        return search.steps();
    }

    void tell(const ball& reached, long bits) const {
        if (watch_) {
            watch_(reached, bits, list_.known());
        }
    }

    std::vector<ball> state_of(const proved_event& event) const {
        if (!as_unknown_) {
            return event.state;
        }
        std::vector<ball> state;
        for (const std::size_t place : as_unknown_->places) {
            state.push_back(event.state[place]);
        }
        return state;
    }

    // If g itself is too wide on sets of times, the next run has it as an unknown.
    void continue_beyond(const zero_search& search) {
        if (search.end() == search_end::undecided && search.undecided().too_many_pieces && !as_unknown_ &&
            !system_.singular()) {
            as_unknown_ = with_condition(system_, request_.g);
            list_.repeat_with_same_bits();
        } else {
            list_.continue_beyond(search, system_.point(), request_.direction);
        }
    }

    const explicit_system& system_;
    const event_request& request_;
    const proof_route& route_;
    const event_watch& watch_;
    std::optional<condition_system> as_unknown_;  // if g itself is too wide on sets of times
    std::vector<std::optional<number>> given_;
    std::vector<collocation_use> collocation_;
    event_list list_;
};

}  // namespace

event_report searched_events(const explicit_system& system, const event_request& request, long digits,
                             const proof_route& route, const event_watch& watch) {
    return event_runs(system, request, digits, route, watch).result();
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
