// The events of repeated runs, with more bits if digits are missing.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../equation/needed_bits.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// A question about an event that so many bits do not decide is left open.
inline long most_bits_of_event(long digits) {
    constexpr long least = 4096;
    constexpr long factor = 16;
    return std::max(least, factor * needed_bits(digits).now());
}

/// The requested events with what the runs up to now prove of each. Event k of each run is the same, since none is
/// omitted: a later run adds digits to the events of those before it.
class event_list {
public:
    /// `names`: of the values of an event. `most_undecided`: the bits that are tried for a question about an event.
    event_list(std::vector<std::string> names, long count, long digits, long most_undecided)
        : names_(std::move(names)),
          wanted_(static_cast<std::size_t>(count)),
          digits_(digits),
          most_undecided_(most_undecided),
          bits_(digits) {
        names_.insert(names_.begin(), "time");
    }

    /// To be called once. Calls run() until nothing is missing or no run within the limits proves more. A run has bits()
    /// bits and calls add() for each event, as long as continues(); it returns the number of its steps.
    template <class Run>
    event_report of_runs(const Run& run) {
        try {
            do {
                found_ = 0;
                repeats_ = false;
            } while (!is_complete(run()));
        } catch (const error& problem) {
            if (problem.kind() != error_kind::undecided) {
                throw;
            }
            missing_ = missing_.value_or(problem);
        }
        return {std::move(known_), std::move(missing_)};
    }

    long bits() const { return bits_.now(); }
    std::size_t found() const { return found_; }
    const std::vector<known_event>& known() const { return known_; }
    /// Whether the run is to find a further event: not if another run is needed.
    bool continues() const { return !repeats_ && found_ < wanted_; }

    /// The next event of the run; another run is needed if a number that excludes 0 lacks digits.
    void add(const ball& time, const std::vector<ball>& values) {
        const bool is_new = found_ == known_.size();
        known_event event = is_new ? known_event{{}, std::vector<known_value>(values.size())} : known_[found_];
        add_number(event.time, time);
        for (std::size_t i = 0; i < values.size(); ++i) {
            add_number(event.values[i], values[i]);
        }
        if (repeats_) {
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
        repeat_or_end("lies in " + bounds_text(time) + ", which " + std::to_string(bits()) +
                      " bits do not distinguish from the end of the search in " + bounds_text(last));
        return false;
    }

    /// Another run with twice the bits is needed.
    void repeat() {
        bits_.raise_to(2 * bits(), "event", name_of_next());
        repeats_ = true;
    }
    void repeat_with_same_bits() { repeats_ = true; }
    /// repeat() if that is within the bits for a question about an event; otherwise end().
    void repeat_or_end(const std::string& undecided) { 2 * bits() > most_undecided_ ? end(undecided) : repeat(); }
    /// No run finds the next event, for this reason.
    void end(const std::string& reason) {
        missing_ = missing_.value_or(error(error_kind::undecided, "event", name_of_next(), reason));
        wanted_ = found_;
    }

    /// After a search that did not find the next event: with more bits, if they help. The system begins at `point`.
    void continue_beyond(const zero_search& search, const number& point, int direction) {
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
                    ", where the steps become too small, as they do near a singularity");
                break;
            case search_end::undecided:
                search.undecided().too_many_pieces ? end(text_of(search.undecided()))
                                                   : repeat_or_end(text_of(search.undecided()));
                break;
            case search_end::none:
            case search_end::precision: repeat(); break;
        }
    }

private:
    std::string text_of(const undecided_place& place) const {
        const std::string means = place.too_many_pieces
                                      ? std::to_string(zero_search::most_pieces_of_a_step) + " pieces of a step"
                                      : std::to_string(bits()) + " bits";
        return "is not decided by " + means + ": the condition may hold in [" + bound_text(place.from, MPFR_RNDD) +
               ", " + bound_text(place.to, MPFR_RNDU) + "], where its two sides differ by at most " +
               upper_bound_text(place.value.exact()) + " and the derivatives of the two sides by at most " +
               upper_bound_text(place.slope.exact());
    }
    std::string name_of_next() const { return std::to_string(found_ + 1); }

    void add_number(known_value& known, const ball& value) {
        improve(known, value, digits_);
        if (!known.decimal && !repeats_ && (!is_finite(value) || !contains_zero(value))) {
            bits_.raise_for(value, "event", name_of_next());
            repeats_ = true;
        }
    }

    // Whether no further run is needed after one of so many steps.
    bool is_complete(long steps) {
        if (repeats_) {
            return false;
        }
        const auto open = std::ranges::find_if_not(known_, &known_event::is_complete);
        if (open == known_.end()) {
            return true;
        }
        const std::string name = std::to_string(open - known_.begin() + 1);
        if (bits_.raised_at_zero(steps, "event", name)) {
            return false;
        }
        std::vector<known_value> values = open->values;
        values.insert(values.begin(), open->time);
        missing_ =
            missing_.value_or(error(error_kind::undecided, "event", name, text_of_undecided(names_, values, bits())));
        return true;
    }

    std::vector<std::string> names_;
    std::size_t wanted_;
    long digits_;
    long most_undecided_;
    needed_bits bits_;
    std::vector<known_event> known_;
    std::optional<error> missing_;
    std::size_t found_ = 0;  // of this run
    bool repeats_ = false;   // whether this run is to be repeated with more bits
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
            beyond();
        } else if (!request.before || list.is_before(*request.before, event->time, request.direction)) {
            add(*event);
        }
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
