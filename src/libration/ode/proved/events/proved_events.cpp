#include "libration/ode/proved/proved_events.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "../condition_system.hpp"
#include "event_list.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// A question about an event that so many bits do not decide is left open.
long most_bits_of_undecided(long digits) {
    constexpr long least = 4096;
    constexpr long factor = 16;
    return std::max(least, factor * needed_bits(digits).now());
}

class event_runs {
public:
    event_runs(const explicit_system& system, const event_request& request, long digits, const proof_route& route,
               const event_watch& watch)
        : system_(system),
          request_(request),
          route_(route),
          watch_(watch),
          given_(given_values(system, request.g)),
          list_(names_of_state(system), request.count, digits, most_bits_of_undecided(digits)) {}

    event_report result() {
        event_report report = list_.of_runs([this] { return steps_of_run(); });
        report.collocation = std::move(collocation_);
        return report;
    }

private:
    // One run, and the number of its steps.
    long steps_of_run() {
        const precision_scope scope(decimal_digits(list_.bits()) + 10);
        event_search search(as_unknown_ ? as_unknown_->system : system_,
                            as_unknown_ ? as_unknown_->condition : request_.g, list_.bits(), request_.direction, route_,
                            [&](const ball& reached, long bits) { tell(reached, bits); });
        if (const auto start = request_.from_start ? search.at_start() : std::nullopt;
            start && (request_.way == crossing::any || request_.way == start->way)) {
            add(*start);
        }
        while (list_.continues()) {
            const auto event = search.next(request_.way, request_.before, request_.horizon);
            const collocation_use& used = search.march().collocation();
            collocation_.assign(used.steps > 0 ? 1 : 0, used);
            if (!event) {
                continue_beyond(search);
            } else if (!request_.before || list_.is_before(*request_.before, event->time, request_.direction)) {
                add(*event);
                tell(search.march().reached(), list_.bits());
            }
        }
        return search.march().steps();
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

    void add(const proved_event& event) {
        std::vector<ball> values = state_of(event);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (given_[i]) {
                values[i] = constant_value<ball>::of(*given_[i]);
            }
        }
        list_.add(event.time, values);
    }

    std::string reached_text(const ball& reached) const { return proved_reach_text(reached, request_.direction >= 0); }

    // After a search that did not find the next event: with more bits, if they help.
    void continue_beyond(const event_search& search) {
        const std::string reached = reached_text(search.march().reached());
        switch (search.end()) {
            case search_end::time:
                list_.end("is not found before that time: " + std::to_string(list_.found()) + " were found");
                break;
            case search_end::horizon:
                list_.end("is not found within " + std::to_string(search.march().steps()) + " steps, from time " +
                          bound_text(exact_midpoint(constant_value<ball>::of(system_.point())), MPFR_RNDN) + " up to " +
                          reached + ": give an end of the search, or a larger horizon");
                break;
            case search_end::steps:
                list_.end("is not reached: the solution is proved to exist up to " + reached +
                          ", where the steps become too small, as they do near a singularity");
                break;
            case search_end::undecided:
                if (!search.undecided().too_many_pieces) {
                    list_.repeat_or_end(text_of(search.undecided()));
                } else if (as_unknown_ || system_.singular()) {
                    list_.end(text_of(search.undecided()));
                } else {
                    as_unknown_ = with_condition(system_, request_.g);
                    list_.repeat_with_same_bits();
                }
                break;
            case search_end::none:
            case search_end::precision: list_.repeat(); break;
        }
    }

    std::string text_of(const undecided_place& place) const {
        const std::string means = place.too_many_pieces
                                      ? std::to_string(event_search::most_pieces_of_a_step) + " pieces of a step"
                                      : std::to_string(list_.bits()) + " bits";
        return "is not decided by " + means + ": the condition may hold in [" + bound_text(place.from, MPFR_RNDD) +
               ", " + bound_text(place.to, MPFR_RNDU) + "], where its two sides differ by at most " +
               upper_bound_text(place.value.exact()) + " and the derivatives of the two sides by at most " +
               upper_bound_text(place.slope.exact());
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
