// Zeros of functions along hybrid solutions to proved digits.
#include <string>
#include <utility>

#include "../hybrid/path_limits.hpp"
#include "event_list.hpp"
#include "libration/query/hybrid_trajectory.hpp"

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
          most_undecided_(most_bits_of_undecided(needed_bits(digits))),
          list_(names_of_state(system), request.count, digits, most_undecided_) {}

    event_report result() {
        event_report report = list_.of_runs([this] { return steps_of_run(); });
        report.by_relation = std::move(by_relation_);
        return report;
    }

private:
    // One run, and the number of its steps.
    long steps_of_run() {
        const auto watch = [&](const ball& reached, long bits) { tell(reached, bits); };
        hybrid_path path(system_, list_.bits(), route_, watch, &request_.g, request_.way);
        const precision_scope scope(decimal_digits(list_.bits()) + 10);
        while (list_.continues()) {
            const auto event = path.next_observed(request_.before, horizon());
            by_relation_ = path.by_relation();
            if (!event) {
                continue_beyond(path);
            } else if (!request_.before || is_before_end(*event)) {
                list_.add(event->time, event->state);
                tell(event->time, list_.bits());
            }
        }
        return path.steps();
    }

    void tell(const ball& reached, long bits) const {
        if (watch_) {
            watch_(reached, bits, list_.known());
        }
    }

    long horizon() const { return request_.horizon.value_or(zero_search::usual_horizon); }

    bool is_before_end(const path_event& event) {
        const bool exactly = event.exactly && (*request_.before - *event.exactly).sign() >= 0;
        return exactly || list_.is_before(*request_.before, event.time, 1);
    }

    // After a search that did not find the next event: with more bits, if they help.
    void continue_beyond(const hybrid_path& path) {
        if (path.end() == path_end::time) {
            list_.end("is not found before that time: " + std::to_string(list_.found()) + " were found");
        } else if (path.end() == path_end::horizon) {
            list_.end("is not found within " + std::to_string(horizon()) + " steps " + events_text(path) +
                      ": give an end of the search, or a larger horizon");
        } else if (const auto reason = reason_of_end(path, most_undecided_)) {
            list_.end(*reason);
        } else {
            list_.repeat();
        }
    }

    const hybrid_system& system_;
    const event_request& request_;
    const proof_route& route_;
    const event_watch& watch_;
    long most_undecided_;
    event_list list_;
    std::vector<std::string> by_relation_;
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
