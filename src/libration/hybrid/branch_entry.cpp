// Events of hybrid solutions: the state and the branch after each.
#include <algorithm>
#include <iterator>
#include <utility>

#include "../equation/bound_text.hpp"
#include "branch_search.hpp"
#include "crossing_set.hpp"
#include "libration/hybrid/hybrid_path.hpp"
#include "libration/hybrid/initial_mode.hpp"
#include "libration/scalar/error.hpp"
#include "states_around.hpp"

namespace libration::ode {

namespace {

// So many intervals between events in succession, each shorter than this power of 2 of the time since the initial point,
// end a path.
constexpr long most_short_intervals = 8;
constexpr long bits_of_short_intervals = 40;
// So many times resets at one time may make other conditions hold.
constexpr long most_rounds = 100;

// Of an expression in leaves.
ball value_in(const first_order_form& form, const expression& e, const std::vector<ball>& state, const ball& time) {
    expression_values<ball> values(form.leaves, time);
    for (const ball& each : state) {
        values.push_back(each);
    }
    return values.of(e);
}

}  // namespace

// The events of the crossing, in the order of the statements; std::nullopt for the reason end().
std::optional<std::vector<std::size_t>> hybrid_path::happening_events() {
    std::vector<std::size_t> happening;
    for (const crossed_surface& each : crossed_) {
        for (const crossing_effect& event : each.of.events) {
            if (happens(event, each.way)) {
                happening.push_back(event.index);
            }
        }
    }
    const auto& events = system_.events();
    if (std::ranges::any_of(events, [&](const state_event& each) { return each.holds && !system_.is_kept(each); })) {
        const branch_beginning unchanged(system_, next_->time, next_->exactly, system_.leaves(), zero_functions(),
                                         next_->state, piece_->kept);
        const initial_mode mode = mode_after(unchanged, piece_->steps, crossed_steps());
        if (!mode.values) {
            ended(path_end::undecided, "it is not decided which events happen: " + mode.reason(system_));
            return std::nullopt;
        }
        for (std::size_t i = 0; i < events.size(); ++i) {
            if (!system_.holds(events[i], piece_->steps) && system_.holds(events[i], *mode.values)) {
                happening.push_back(i);
            }
        }
    }
    std::ranges::sort(happening);
    const auto same_statement = [&](std::size_t i, std::size_t j) {
        return i == j || (events[i].at.line > 0 && events[i].at.line == events[j].at.line &&
                          events[i].at.column == events[j].at.column);
    };
    happening.erase(std::unique(happening.begin(), happening.end(), same_statement), happening.end());
    return happening;
}

// What the leaves are after an event, in terms of their values before: the resets of all statements that it meets, in
// the order of the statements.
std::vector<expression> hybrid_path::reset_leaves(const std::vector<std::size_t>& happening) {
    reset_values_.clear();
    const auto& leaves = system_.leaves();
    std::vector<expression> now = leaves;
    for (const std::size_t index : happening) {
        const std::vector<expression> before = now;
        for (const reset& value : system_.events()[index].resets) {
            const auto k =
                std::ranges::find_if(leaves, [&](const expression& leaf) { return same_form(leaf, value.of); });
            reset_values_.push_back(with_leaves(value.value, leaves, before));
            now[static_cast<std::size_t>(k - leaves.begin())] = reset_values_.back();
        }
    }
    return now;
}

std::vector<std::size_t> hybrid_path::crossed_steps() const {
    std::vector<std::size_t> all;
    for (const crossed_surface& each : crossed_) {
        for (const crossing_effect& effect : each.of.steps) {
            all.push_back(effect.index);
        }
    }
    return all;
}

// Functions of the state that are 0 at the event.
std::vector<expression> hybrid_path::zero_functions() const {
    std::vector<expression> all;
    for (const crossed_surface& each : crossed_) {
        all.push_back(each.of.g);
    }
    for (std::size_t i = 0; i < piece_->steps.size(); ++i) {
        if (system_.is_at_rest(i, piece_->steps)) {
            all.push_back(system_.argument(i, piece_->steps));
        }
    }
    return all;
}

// The beginning of the search for the zeros of a surface of the branch that was entered.
std::optional<search_start> hybrid_path::start_on(const surface& of, const branch_beginning& beginning) {
    search_start start{.begins = piece_->begins};
    if (of.time) {
        return start;
    }
    std::optional<int> sign;  // of the step functions that are signs
    for (const crossing_effect& each : of.steps) {
        if (system_.steps()[each.index].kind == step_kind::sign) {
            sign = piece_->steps[each.index].sign() * each.orientation;
        }
    }
    const auto here = beginning.sign(of.g);
    const auto leading = !here        ? std::optional(leading_derivative{0, sign.value_or(0)})
                         : *here != 0 ? std::optional(leading_derivative{0, *here})
                                      : beginning.leading(of.g, slopes_in_given(piece_->system));
    if (!leading || leading->sign == 0 || (sign && *sign != leading->sign)) {
        ended(path_end::undecided,
              here && *here == 0
                  ? "`" + of.text +
                        "` is not crossed transversally: the derivative of its two sides is not distinguished after "
                        "the event"
                  : "`" + of.text + "` is not distinguished from an event directly after this one");
        return std::nullopt;
    }
    start.order = leading->order;
    start.sign = leading->sign;
    return start;
}

// Whether intervals between events have become too short.
bool hybrid_path::accumulates() {
    const magnitude gone(next_->time - first_time_);
    shorter_ = magnitude(next_->time - last_time_) < gone.shifted(-bits_of_short_intervals) ? shorter_ + 1 : 0;
    return shorter_ >= most_short_intervals;
}

// Continues on the branch after the event; false for the reason end().
bool hybrid_path::take() {
    for (const crossed_surface& surface : crossed_) {
        for (const crossing_effect& each : surface.of.events) {
            const state_event& event = system_.events()[each.index];
            if (event.stop && happens(each, surface.way)) {
                last_time_ = next_->time;
                ++count_;
                return ended(path_end::stop, "`" + event.text + "` ends the solution");
            }
        }
    }
    if (!complete(*next_)) {
        return false;
    }
    if (count_ >= most_events) {
        return ended(path_end::accumulation, "no more than " + std::to_string(most_events) + " events are followed");
    }
    if (accumulates()) {
        return ended(path_end::accumulation, "the intervals between events became shorter than 2^-" +
                                                 std::to_string(bits_of_short_intervals) +
                                                 " of the time, as where infinitely many of them accumulate");
    }
    try {
        return continue_on_branch();
    } catch (const error&) {
        return ended(
            path_end::undecided,
            "the equations of the next branch cannot be expanded about its beginning, or need more bits there");
    }
}

bool hybrid_path::continue_on_branch() {
    last_time_ = next_->time;
    ++count_;
    if (emptied_) {
        return continue_emptied();
    }
    auto happening = happening_events();
    if (!happening) {
        return false;
    }
    step_values before = piece_->steps;
    for (long round = 0;; ++round) {
        if (is_stopped(*happening)) {
            return false;
        }
        entered_branch entered;
        if (!reset_state(*happening, entered)) {
            return ended(path_end::undecided, "the states after the event are not enclosed");
        }
        const branch_beginning beginning(system_, next_->time, next_->exactly, entered.leaves, zero_functions(),
                                         entered.state, piece_->kept);
        const initial_mode mode = mode_after(beginning, piece_->steps, crossed_steps());
        if (!mode.values) {
            return ended(mode.failure == mode_failure::sliding ? path_end::sliding : path_end::undecided,
                         mode.reason(system_));
        }
        const auto following = events_by_resets(before, *mode.values);
        if (following.empty()) {
            return enter_mode(entered, mode, beginning);
        }
        if (round == most_rounds) {
            return ended(path_end::accumulation, "the resets at one time make conditions hold again and again");
        }
        std::ranges::copy(following, std::back_inserter(*happening));
        before = *mode.values;
    }
}

// Whether one of the events ends the solution.
bool hybrid_path::is_stopped(const std::vector<std::size_t>& happening) {
    const auto& events = system_.events();
    const auto stop = std::ranges::find_if(happening, [&](std::size_t index) { return events[index].stop; });
    return stop != happening.end() && !ended(path_end::stop, "`" + events[*stop].text + "` ends the solution");
}

// False if a value is not enclosed.
bool hybrid_path::reset_state(const std::vector<std::size_t>& happening, entered_branch& entered) {
    entered = {.leaves = reset_leaves(happening), .state = {}};
    const first_order_form form(piece_->system);
    for (std::size_t k = 0; k < entered.leaves.size(); ++k) {
        const bool kept = same_form(entered.leaves[k], system_.leaves()[k]);
        entered.state.push_back(kept ? next_->state[k]
                                     : value_in(form, form.in_leaves(entered.leaves[k]), next_->state, next_->time));
    }
    return std::ranges::all_of(reset_values_, [&](const expression& each) {
        return is_finite(value_in(form, form.in_leaves(each), next_->state, next_->time));
    });
}

// The events with conditions on values that resets alone change, which these begin to hold by.
std::vector<std::size_t> hybrid_path::events_by_resets(const step_values& before, const step_values& after) const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < system_.events().size(); ++i) {
        const state_event& each = system_.events()[i];
        if (system_.is_kept(each) && !system_.holds(each, before) && system_.holds(each, after)) {
            all.push_back(i);
        }
    }
    return all;
}

// The branch with the values of the step functions that are decided.
bool hybrid_path::enter_mode(entered_branch& entered, const initial_mode& mode, const branch_beginning& beginning) {
    bool rests = false;
    for (std::size_t i = 0; i < mode.values->size(); ++i) {
        rests = rests || system_.is_at_rest(i, *mode.values);
    }
    if (rests && !system_.variations().empty()) {
        return ended(path_end::undecided,
                     "the solution remains on a switching surface, which nearby solutions may leave");
    }
    note_relations(mode.by_relation);
    return (system_.variations().empty() || add_saltation(entered, *mode.values)) &&
           enter(entered, *mode.values, beginning);
}

// From the beginning of the ball of times of the event.
explicit_system hybrid_path::branch_after(const entered_branch& entered, const step_values& values) const {
    const number begin = next_->exactly ? *next_->exactly : number_of(lower_bound(next_->time));
    return system_.branch(values, begin, midpoints_of(entered.state));
}

// The derivatives of the state after the event (theorem H, 4), from those before it in `entered`.
bool hybrid_path::add_saltation(entered_branch& entered, const step_values& values) {
    const auto& leaves = system_.leaves();
    const ball& time = next_->time;
    const first_order_form before(piece_->system);
    const first_order_form after(branch_after(entered, values));
    const auto slopes = before.slopes_at(next_->state, time);
    const auto slopes_after = after.slopes_at(entered.state, time);
    const auto value = [&](const expression& e) { return value_in(before, before.in_leaves(e), next_->state, time); };
    const expression& g = crossed_.front().of.g;
    const ball slope_of_g = value_in(before, before.slope_of(before.in_leaves(g)), next_->state, time);
    if (!next_->exactly && contains_zero(slope_of_g)) {
        return ended(path_end::undecided, "the derivative of the two sides of `" + crossed_.front().of.text +
                                              "` is not distinguished from 0 there");
    }
    for (const state_variation& each : system_.variations()) {
        ball of_time(0);
        for (std::size_t l = 0; l < leaves.size() && !next_->exactly; ++l) {
            if (each[l]) {
                of_time -= value(partial(g, leaves[l])) * next_->state[*each[l]] / slope_of_g;
            }
        }
        for (std::size_t k = 0; k < leaves.size(); ++k) {
            if (!each[k]) {
                continue;
            }
            const expression& now = entered.leaves[k];
            ball sum = (value(partial(now, variable())) - slopes_after[k]) * of_time;
            for (std::size_t l = 0; l < leaves.size(); ++l) {
                if (const expression by = partial(now, leaves[l]); !by.is(0)) {
                    const ball moved = slopes[l] * of_time;
                    sum += value(by) * (each[l] ? next_->state[*each[l]] + moved : moved);
                }
            }
            entered.state[*each[k]] = std::move(sum);
        }
    }
    return true;
}

// The derivatives of the state jump by another rule than it itself.
std::optional<state_set> hybrid_path::set_behind_event(const entered_branch& entered, const path_piece& next) {
    if (!system_.variations().empty() || emptied_) {
        return std::nullopt;
    }
    integration& along = *piece_->along;
    std::size_t k = along.first();
    const step* here = along[k];
    while (here != nullptr && !here->reaches(distance_between(next_->time, here->from().time))) {
        here = along[++k];
    }
    const ball begin = next_->exactly ? next_->time : lower_bound(next_->time);
    const expression* const g = next_->exactly ? nullptr : &crossed_.front().of.g;
    return here == nullptr ? std::nullopt
                           : set_after_crossing(*here, {first_order_form(piece_->system), first_order_form(next.system),
                                                        entered.leaves, g, next_->time, begin});
}

// From the states after the event at a time of its ball to the branch from the beginning of that ball.
bool hybrid_path::enter(const entered_branch& entered, const step_values& values, const branch_beginning& beginning) {
    if (!std::ranges::all_of(entered.state, [](const ball& x) { return is_finite(x); })) {
        return ended(path_end::undecided, "the states after the event are not enclosed");
    }
    const ball times = next_->time;
    const ball begin = lower_bound(times);
    auto piece = std::make_unique<path_piece>(branch_after(entered, values));
    piece->steps = values;
    piece->kept = beginning.kept();
    std::vector<ball> state = entered.state;
    put_kept(piece->kept, state);
    piece->state = state;
    piece->on_the_way = state;
    if (piece->system.singular()) {
        return ended(path_end::steps, "the next branch is singular at its beginning");
    }
    if (!next_->exactly) {
        const first_order_form form(piece->system);
        auto around = states_around(form, state, times);
        if (!around) {
            return ended(path_end::undecided, "the states after the event are not enclosed");
        }
        piece->state = states_moved(form, state, times, *around, begin);
        piece->begins = times;
        piece->on_the_way = *std::move(around);
    }
    piece->set = set_behind_event(entered, *piece);
    before_last_ = next_->on_the_way;
    reset_last_.clear();
    for (std::size_t k = 0; k < entered.leaves.size(); ++k) {
        reset_last_.push_back(!same_form(entered.leaves[k], system_.leaves()[k]));
    }
    steps_ = steps();
    unobserved_ += 1 + search_->most_steps();  // the step in which the branch ends is not counted there
    search_.reset();
    piece_ = std::move(piece);
    next_.reset();
    crossed_.clear();
    return search_branch(&beginning);
}

}  // namespace libration::ode
