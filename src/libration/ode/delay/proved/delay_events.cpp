#include "libration/ode/delay/proved/delay_events.hpp"

#include "../../proved/condition_system.hpp"
#include "../../proved/events/event_list.hpp"
#include "delay_steps.hpp"

namespace libration::ode {

namespace {

class delay_event_runs {
public:
    delay_event_runs(const delay_system& system, const event_request& request, long digits, const event_watch& watch)
        : system_(system),
          first_(system.first_equations()),
          request_(request),
          watch_(watch),
          fixed_(given_values(first_, request.g)),
          list_(names_of_state(system), request.count, digits, most_bits_of_undecided(digits)) {}

    event_report result() {
        return list_.of_runs([this] { return steps_of_run(); });
    }

private:
    // One run, and the number of its steps.
    long steps_of_run() {
        const precision_scope scope(decimal_digits(list_.bits()) + 10);
        delay_steps steps(system_, list_.bits());
        event_search search(first_, request_.g, steps, [&](const ball& reached, long bits) { tell(reached, bits); });
        if (const auto start = request_.from_start ? search.at_start() : std::nullopt;
            start && (request_.way == crossing::any || request_.way == start->way)) {
            add(*start);
        }
        while (list_.continues()) {
            const auto event = search.next(request_.way, request_.before, request_.horizon);
            if (!event) {
                list_.continue_beyond(search, system_.point(), 1);
            } else if (!request_.before || list_.is_before(*request_.before, event->time, 1)) {
                add(*event);
                tell(steps.reached(), list_.bits());
            }
        }
        return steps.steps();
    }

    void tell(const ball& reached, long bits) const {
        if (watch_) {
            watch_(reached, bits, list_.known());
        }
    }

    void add(const proved_event& event) {
        std::vector<ball> values = event.state;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (fixed_[i]) {
                values[i] = constant_value<ball>::of(*fixed_[i]);
            }
        }
        list_.add(event.time, values);
    }

    const delay_system& system_;
    explicit_system first_;  // the equations up to the first breaking point
    const event_request& request_;
    const event_watch& watch_;
    std::vector<std::optional<number>> fixed_;
    event_list list_;
};

}  // namespace

event_report searched_delay_events(const delay_system& system, const event_request& request, long digits,
                                   const event_watch& watch) {
    if (request.direction < 0) {
        throw error(error_kind::argument, "time", text_of_time(*request.before),
                    "is before the initial point, where the solution is the history: choose a time after it");
    }
    return delay_event_runs(system, request, digits, watch).result();
}

}  // namespace libration::ode
