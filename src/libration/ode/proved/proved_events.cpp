#include "libration/ode/proved/proved_events.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "condition_system.hpp"
#include "libration/scalar/error.hpp"
#include "needed_bits.hpp"

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
          bits_(digits),
          most_undecided_(std::max(most_undecided_bits, most_undecided_factor * bits_.now())) {}

    event_report result() {
        try {
            while (!complete()) {
            }
        } catch (const error& problem) {
            if (problem.kind() != error_kind::undecided) {
                throw;
            }
            return {std::move(known_), problem, std::move(collocation_)};
        }
        return {std::move(known_), std::nullopt, std::move(collocation_)};
    }

private:
    // One run; false where the next one needs more bits.
    bool complete() {
        events_.clear();
        const precision_scope scope(decimal_digits(bits_.now()) + 10);
        event_search search(as_unknown_ ? as_unknown_->system : system_,
                            as_unknown_ ? as_unknown_->condition : request_.g, bits_.now(), request_.direction, route_,
                            [&](const ball& reached, long bits) { tell(reached, bits); });
        if (const auto start = request_.from_start ? search.at_start() : std::nullopt;
            start && (request_.way == crossing::any || request_.way == start->way) && !taken(*start)) {
            return false;
        }
        while (static_cast<long>(events_.size()) < request_.count) {
            const auto event = search.next(request_.way, request_.before, request_.horizon);
            const collocation_use& used = search.march().collocation();
            collocation_.assign(used.steps > 0 ? 1 : 0, used);
            if (!event) {
                require_more_bits(search);
                return false;
            }
            if (!certainly_asked_for(event->time) || !taken(*event)) {
                return false;
            }
            tell(search.march().reached(), bits_.now());
        }
        return true;
    }

    void tell(const ball& reached, long bits) const {
        if (watch_) {
            watch_(reached, bits, known_);
        }
    }

    // Whether the event is before `before` or at it; false, with more bits requested, if that is undecided.
    bool certainly_asked_for(const ball& time) {
        if (!request_.before) {
            return true;
        }
        const ball end = constant_value<ball>::of(*request_.before);
        const ball rest = (end - time) * (request_.direction < 0 ? -1 : 1);
        if (arb_is_nonnegative(rest.handle()) != 0) {
            return true;
        }
        raise_bits_for("lies in " + bounds_text(time) + ", which " + std::to_string(bits_.now()) +
                       " bits do not distinguish from the end of the search in " + bounds_text(end));
        return false;
    }

    // Doubles the bits, or throws if the limit is reached.
    void raise_bits_for(const std::string& undecided) {
        if (2 * bits_.now() > most_undecided_) {
            throw error(error_kind::undecided, "event", name_of_next(), undecided);
        }
        bits_.raise_to(2 * bits_.now(), "event", name_of_next());
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

    // Prints the event; false, with more bits requested, if digits are missing.
    bool taken(const proved_event& event) {
        printed_event made;
        std::vector<ball> values = state_of(event);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (given_[i]) {
                values[i] = constant_value<ball>::of(*given_[i]);
            }
        }
        values.insert(values.begin(), event.time);
        for (const ball& value : values) {
            auto decimal = bits_.printed(value, "event", name_of_next());
            if (!decimal) {
                return false;
            }
            made.values.push_back(*std::move(decimal));
        }
        made.time = made.values.front();
        made.values.erase(made.values.begin());
        events_.push_back(std::move(made));
        if (events_.size() > known_.size()) {
            known_.push_back(events_.back());
        }
        return true;
    }

    std::string reached_text(const ball& reached) const { return proved_reach_text(reached, request_.direction >= 0); }

    // Throws if more bits do not help.
    void require_more_bits(const event_search& search) {
        const auto refused = [&](const std::string& reason) {
            throw error(error_kind::undecided, "event", name_of_next(), reason);
        };
        const std::string reached = reached_text(search.march().reached());
        switch (search.end()) {
            case search_end::time:
                refused("is not found before that time: " + std::to_string(events_.size()) + " were found");
                break;
            case search_end::horizon:
                refused("is not found within " + std::to_string(search.march().steps()) + " steps, from time " +
                        bound_text(exact_midpoint(constant_value<ball>::of(system_.point())), MPFR_RNDN) + " up to " +
                        reached + ": give an end of the search, or a larger horizon");
                break;
            case search_end::steps:
                refused("is not reached: the solution is proved to exist up to " + reached +
                        ", where the steps become too small, as they do near a singularity");
                break;
            case search_end::undecided:
                if (!search.undecided().too_many_pieces) {
                    raise_bits_for(text_of(search.undecided()));
                } else if (as_unknown_ || system_.singular()) {
                    refused(text_of(search.undecided()));
                } else {
                    as_unknown_ = with_condition(system_, request_.g);
                }
                break;
            case search_end::none:
            case search_end::precision: bits_.raise_to(2 * bits_.now(), "event", name_of_next()); break;
        }
    }

    std::string text_of(const undecided_place& place) const {
        const std::string means = place.too_many_pieces
                                      ? std::to_string(event_search::most_pieces_of_a_step) + " pieces of a step"
                                      : std::to_string(bits_.now()) + " bits";
        return "is not decided by " + means + ": the condition may hold in [" + bound_text(place.from, MPFR_RNDD) +
               ", " + bound_text(place.to, MPFR_RNDU) + "], where its two sides differ by at most " +
               upper_bound_text(place.value.exact()) + " and the derivatives of the two sides by at most " +
               upper_bound_text(place.slope.exact());
    }

    std::string name_of_next() const { return std::to_string(events_.size() + 1); }

    const explicit_system& system_;
    const event_request& request_;
    const proof_route& route_;
    const event_watch& watch_;
    std::optional<condition_system> as_unknown_;  // if g itself is too wide on sets of times
    std::vector<std::optional<number>> given_;
    std::vector<printed_event> events_;  // of this run
    std::vector<printed_event> known_;   // of the run that found the most
    std::vector<collocation_use> collocation_;
    needed_bits bits_;
    long most_undecided_;
};

}  // namespace

event_report searched_events(const explicit_system& system, const event_request& request, long digits,
                             const proof_route& route, const event_watch& watch) {
    return event_runs(system, request, digits, route, watch).result();
}

std::vector<printed_event> proved_events(const explicit_system& system, const event_request& request, long digits,
                                         const proof_route& route) {
    event_report report = searched_events(system, request, digits, route);
    if (report.missing) {
        throw error(*report.missing);
    }
    return std::move(report.events);
}

}  // namespace libration::ode
