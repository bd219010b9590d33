// The events of repeated runs, with more bits if digits are missing.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../equation/bound_text.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/query/proved_events.hpp"

namespace libration::ode {

/// A question about an event that so many bits do not decide is left open.
inline long most_bits_of_event(long digits) { return std::max(4096L, 16 * bits_of_first_run(digits)); }

/// The requested events with what the runs up to now prove of each. Event k of each run is the same, since none is
/// omitted: a later run adds digits to the events of those before it.
class event_list {
public:
    /// `names`: of the values of an event. `most_undecided`: the bits that are tried for a question about an event.
    event_list(std::vector<std::string> names, long count, long digits, long most_undecided, const event_watch& watch)
        : names_(std::move(names)),
          wanted_(static_cast<std::size_t>(count)),
          digits_(digits),
          most_undecided_(most_undecided),
          watch_(watch) {}

    /// To be called once. Calls run(bits, demand) until nothing is missing or no run within the limits proves more. A
    /// run calls add() for each event, as long as continues().
    template <class Run>
    event_report of_runs(const Run& run) {
        auto missing = prove_digits(digits_, "event", [&](const run_bits& bits, run_demand& demand) {
            demand_ = &demand;
            found_ = 0;
            run(bits.bits, demand);
            if (!demand.repeats()) {
                wanted_ = found_;
            }
        });
        return {std::move(known_), std::move(missing)};
    }

    std::size_t found() const { return found_; }
    void tell(const ball& reached, long bits) const {
        if (watch_) {
            watch_(reached, bits, known_);
        }
    }
    /// Whether the run is to find a further event: not if another run is needed.
    bool continues() const { return !demand_->repeats() && found_ < wanted_; }
    /// Of the next event of the run, in messages.
    std::string name_of_next() const { return std::to_string(found_ + 1); }

    /// The next event of the run; another run is needed if a number that excludes 0 lacks digits.
    void add(const ball& time, const std::vector<ball>& values) {
        const bool is_new = found_ == known_.size();
        known_event event = is_new ? known_event() : known_[found_];
        demand_->improve(event.time, time, name_of_next(), "time");
        demand_->improve(event.values, values, name_of_next(), names_);
        if (demand_->repeats()) {
            return;
        }
        if (is_new) {
            known_.emplace_back();
        }
        known_[found_++] = std::move(event);
    }

    /// Whether the next event is certainly before the end of the search, or at it; else more bits are needed.
    bool is_before(const number& end, const ball& time, int direction) {
        const ball last = constant_value<ball>::of(end);
        if (arb_is_nonnegative(ball((last - time) * (direction < 0 ? -1 : 1)).handle()) != 0) {
            return true;
        }
        undecided("lies in " + bounds_text(time) + ", which " + std::to_string(demand_->now().bits) +
                  " bits do not distinguish from the end of the search in " + bounds_text(last));
        return false;
    }

    /// No run finds the next event, for this reason.
    void end(const std::string& reason) { demand_->ended(name_of_next(), reason); }

    /// After a search that did not find the next event: with more bits, if they help. The system begins at `point`.
    /// `cause` is what is known of a place where the steps become too small; empty if nothing is.
    void continue_beyond(const zero_search& search, const number& point, int direction, const std::string& cause = {}) {
        const std::string reached = proved_reach_text(search.reached(), direction >= 0);
        switch (search.end()) {
            case search_end::time:
                end("is not found before that time: " + std::to_string(found()) + " were found");
                break;
            case search_end::horizon:
                end("is not found within " + std::to_string(search.steps()) + " steps, from time " +
                    bound_text(exact_midpoint(constant_value<ball>::of(point)), MPFR_RNDN) + " up to " + reached +
                    ": give an end of the search, or a larger horizon");
                break;
            case search_end::steps:
                end("is not reached: the solution is proved to exist up to " + reached +
                    ", where the step size falls below its minimum (probably a singularity" +
                    (cause.empty() ? "" : "; " + cause) + ")");
                break;
            case search_end::undecided:
                search.undecided().too_many_pieces ? end(text_of(search.undecided()))
                                                   : undecided(text_of(search.undecided()));
                break;
            case search_end::none:
            case search_end::precision: demand_->twice_the_bits(name_of_next()); break;
        }
    }

private:
    std::string text_of(const undecided_place& place) const {
        const std::string means = place.too_many_pieces
                                      ? std::to_string(zero_search::most_pieces_of_a_step) + " pieces of a step"
                                      : std::to_string(demand_->now().bits) + " bits";
        return "is not decided by " + means + ": the condition may hold in " + interval_text(place.from, place.to) +
               ", where its two sides differ by at most " + upper_bound_text(place.value.exact()) +
               " and the derivatives of the two sides by at most " + upper_bound_text(place.slope.exact());
    }
    void undecided(const std::string& reason) { demand_->undecided(name_of_next(), reason, most_undecided_); }

    std::vector<std::string> names_;
    std::size_t wanted_;
    long digits_;
    long most_undecided_;
    const event_watch& watch_;
    run_demand* demand_ = nullptr;  // of this run
    std::vector<known_event> known_;
    std::size_t found_ = 0;  // of this run
};

/// The events of one run: add(event) for each of them that is before the end of the search, and beyond() after a search
/// that did not find the next one.
template <class Add, class Beyond>
void find_events(event_list& list, zero_search& search, const event_request& request, const Add& add,
                 const Beyond& beyond) {
    if (const auto start = request.from_start ? search.at_start() : std::nullopt;
        start && (request.way == crossing::any || request.way == start->way)) {
        add(*start);
    }
    while (list.continues()) {
        const auto event = search.next(request.way, request.before, request.horizon);
        if (!event) {
            return beyond();
        }
        if (request.before && !list.is_before(*request.before, event->time, request.direction)) {
            return;
        }
        add(*event);
    }
}

/// The numbers of `values` that the condition itself determines, by these.
inline std::vector<ball> with_given_values(std::vector<ball> values, const std::vector<std::optional<number>>& given) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (given[i]) {
            values[i] = constant_value<ball>::of(*given[i]);
        }
    }
    return values;
}

}  // namespace libration::ode
