// Zeros of functions along hybrid paths to proved digits.
#include <string>
#include <utility>

#include "../../proved/needed_bits.hpp"
#include "libration/ode/hybrid/proved/hybrid_trajectory.hpp"
#include "path_limits.hpp"

namespace libration::ode {

namespace {

class hybrid_event_runs {
public:
    hybrid_event_runs(const hybrid_system& system, const event_request& request, long digits, const proof_route& route,
                      const event_watch& watch)
        : system_(system),
          request_(request),
          route_(route),
          watch_(watch),
          bits_(digits),
          most_undecided_(most_bits_of_undecided(bits_)) {}

    event_report result() {
        try {
            while (!complete()) {
            }
        } catch (const error& problem) {
            if (problem.kind() != error_kind::undecided) {
                throw;
            }
            return {std::move(known_), problem};
        }
        return {std::move(known_), std::nullopt};
    }

private:
    bool complete() {
        events_.clear();
        const auto watch = [this](const ball& reached, long bits) {
            if (watch_) {
                watch_(reached, bits, known_);
            }
        };
        hybrid_path path(system_, bits_.now(), route_, watch, &request_.g, request_.way);
        const precision_scope scope(decimal_digits(bits_.now()) + 10);
        while (static_cast<long>(events_.size()) < request_.count) {
            const auto event =
                path.next_observed(request_.before, request_.horizon.value_or(event_search::usual_horizon));
            if (!event) {
                require_more_bits(path);
                return false;
            }
            if (!taken(*event)) {
                return false;
            }
            watch(event->time, bits_.now());
        }
        return true;
    }

    std::string name_of_next() const { return std::to_string(events_.size() + 1); }

    void require_more_bits(const hybrid_path& path) {
        const auto refused = [&](const std::string& reason) {
            throw error(error_kind::undecided, "event", name_of_next(), reason);
        };
        if (path.end() == path_end::time) {
            refused("is not found before that time: " + std::to_string(events_.size()) + " were found");
        }
        if (path.end() == path_end::horizon) {
            refused("is not found within " + std::to_string(request_.horizon.value_or(event_search::usual_horizon)) +
                    " steps " + events_text(path) + ": give an end of the search, or a larger horizon");
        }
        raise_path_bits(bits_, path, most_undecided_, "event", name_of_next());
    }

    // Prints the event; false, with more bits requested, if digits are missing.
    bool taken(const path_event& event) {
        if (request_.before && !is_before_end(event)) {
            return false;
        }
        printed_event made;
        std::vector<ball> values = event.state;
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

    bool is_before_end(const path_event& event) {
        if (event.exactly
                ? (*request_.before - *event.exactly).sign() >= 0
                : arb_is_nonnegative(ball(constant_value<ball>::of(*request_.before) - event.time).handle()) != 0) {
            return true;
        }
        if (2 * bits_.now() > most_undecided_) {
            throw error(error_kind::undecided, "event", name_of_next(),
                        "lies in " + bounds_text(event.time) + ", which " + std::to_string(bits_.now()) +
                            " bits do not distinguish from the end of the search");
        }
        bits_.raise_to(2 * bits_.now(), "event", name_of_next());
        return false;
    }

    const hybrid_system& system_;
    const event_request& request_;
    const proof_route& route_;
    const event_watch& watch_;
    std::vector<printed_event> events_;  // of this run
    std::vector<printed_event> known_;   // of the run that found the most
    needed_bits bits_;
    long most_undecided_;
};

}  // namespace

event_report searched_hybrid_events(const hybrid_system& system, const event_request& request, long digits,
                                    const proof_route& route, const event_watch& watch) {
    if (route.integrator == integrator_choice::collocation) {
        throw error(
            error_kind::argument, "integrator", "collocation",
            "is not supported for a problem with events or a piecewise right-hand side: use automatic or taylor");
    }
    if (request.direction < 0 || request.from_start) {
        throw error(error_kind::argument, "event", "",
                    request.from_start ? "of a problem with events or piecewise right-hand sides is searched after the "
                                         "initial point: leave out the initial time"
                                       : "of a problem with events or piecewise right-hand sides is searched forwards "
                                         "only: choose an end after the initial point");
    }
    return hybrid_event_runs(system, request, digits, route, watch).result();
}

}  // namespace libration::ode
