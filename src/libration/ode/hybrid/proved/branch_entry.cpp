// Events of hybrid paths: the state and the branch after each.
#include <algorithm>
#include <iterator>
#include <utility>

#include "../../proved/needed_bits.hpp"
#include "branch_search.hpp"
#include "libration/ode/hybrid/proved/hybrid_path.hpp"
#include "states_around.hpp"

namespace libration::ode {

namespace {

// So many intervals between events in succession, each shorter than this power of 2 of the time since the initial point,
// end a path.
constexpr long most_short_intervals = 8;
constexpr long bits_of_short_intervals = 40;

int direction_of(crossing way) { return way == crossing::down ? -1 : 1; }

// Of an expression in leaves.
ball value_in(const first_order_form& form, const expression& e, const std::vector<ball>& state, const ball& time) {
    expression_values<ball> values(form.leaves, time);
    for (const ball& each : state) {
        values.push_back(each);
    }
    return values.of(e);
}

std::vector<number> midpoints(const std::vector<ball>& state) {
    std::vector<number> all;
    std::ranges::transform(state, std::back_inserter(all), [](const ball& x) { return number_of(midpoint_alone(x)); });
    return all;
}

}  // namespace

// What the leaves are after an event, in terms of their values before: the resets of each event in order.
std::vector<expression> hybrid_path::reset_leaves() const {
    const auto& leaves = system_.leaves();
    std::vector<expression> now = leaves;
    for (const crossing_effect& each : crossed_->events) {
        if (!happens(each, next_->way)) {
            continue;
        }
        const std::vector<expression> before = now;
        for (const reset& value : system_.events()[each.index].resets) {
            const auto k =
                std::ranges::find_if(leaves, [&](const expression& leaf) { return same_form(leaf, value.of); });
            now[static_cast<std::size_t>(k - leaves.begin())] = with_leaves(value.value, leaves, before);
        }
    }
    return now;
}

// The step functions after the event, the arguments of those that are not crossed by their signs.
std::optional<step_values> hybrid_path::steps_after(const entered_branch& entered) {
    step_values values = piece_->steps;
    const first_order_form form(piece_->system);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto effect = std::ranges::find(crossed_->steps, i, &crossing_effect::index);
        const bool crossed = effect != crossed_->steps.end();
        if (const auto constant = system_.constant_step(i, values)) {
            values[i] = *constant;
        } else if (system_.steps()[i].kind == step_kind::floor) {
            values[i] = crossed ? values[i] + number(rational(effect->orientation)) : values[i];
        } else {
            const expression u = system_.argument(i, values);
            const expression after = with_leaves(u, system_.leaves(), entered.leaves);
            if (crossed && (crossed_->time || relative_sign(after, crossed_->g) != 0)) {
                values[i] = number(rational(effect->orientation * direction_of(next_->way)));
            } else if (!linear_in_variable::of(u)) {
                const int sign = known_sign(value_in(form, form.in_leaves(u), entered.state, next_->time));
                if (sign == 0 && !same_form(after, u)) {
                    ended(path_end::undecided, "the sign of the argument of `" + system_.steps()[i].text +
                                                   "` is not decided after the event");
                    return std::nullopt;
                }
                values[i] = sign == 0 ? values[i] : number(rational(sign));
            }
        }
    }
    return values;
}

// The beginning of the search for the zeros of a surface of the branch that was entered.
std::optional<search_start> hybrid_path::start_on(const surface& of, const entered_branch& entered) {
    search_start start{.state = *piece_->state, .begins = piece_->begins};
    if (of.time) {
        return start;
    }
    const first_order_form form(piece_->system);
    const expression after = with_leaves(of.g, system_.leaves(), entered.leaves);
    const bool crossed = !entered.crossed.time && relative_sign(after, entered.crossed.g) != 0;
    start.at_zero = crossed || after.is(0);
    const auto& around = piece_->on_the_way;
    const expression g = form.in_leaves(of.g);
    start.sign = known_sign(value_in(form, start.at_zero ? form.slope_of(g) : g, around, last_time_));
    if (start.sign == 0) {
        ended(path_end::undecided,
              start.at_zero ? "`" + of.text +
                                  "` is not crossed transversally: the derivative of its two sides is not "
                                  "distinguished after the event"
                            : "`" + of.text + "` is not distinguished from an event directly after this one");
        return std::nullopt;
    }
    for (const crossing_effect& each : of.steps) {
        if (start.at_zero && piece_->steps[each.index].sign() * each.orientation != start.sign) {
            ended(path_end::sliding, "the solution slides along the surface of `" + system_.steps()[each.index].text +
                                         "`: both branches lead back to it");
            return std::nullopt;
        }
    }
    return start;
}

// Whether intervals between events have become too short.
bool hybrid_path::accumulates() {
    const magnitude gone(next_->time - first_time_);
    shorter_ = magnitude(next_->time - last_time_) < gone.shifted(-bits_of_short_intervals) ? shorter_ + 1 : 0;
    return shorter_ >= most_short_intervals || count_ >= most_events;
}

// Continues on the branch after the event; false for the reason end().
bool hybrid_path::take() {
    for (const crossing_effect& each : crossed_->events) {
        if (system_.events()[each.index].stop && happens(each, next_->way)) {
            last_time_ = next_->time;
            ++count_;
            return ended(path_end::stop, "`" + system_.events()[each.index].text + "` ends the solution");
        }
    }
    if (!complete(*next_)) {
        return false;
    }
    if (accumulates()) {
        return ended(path_end::accumulation, "the intervals between events became shorter than 2^-" +
                                                 std::to_string(bits_of_short_intervals) +
                                                 " of the time, as where infinitely many of them accumulate");
    }
    entered_branch entered{.crossed = *crossed_, .leaves = reset_leaves(), .state = {}};
    const first_order_form form(piece_->system);
    for (std::size_t k = 0; k < entered.leaves.size(); ++k) {
        const bool kept = same_form(entered.leaves[k], system_.leaves()[k]);
        entered.state.push_back(kept ? next_->state[k]
                                     : value_in(form, form.in_leaves(entered.leaves[k]), next_->state, next_->time));
    }
    const auto values = steps_after(entered);
    return values && (system_.variations().empty() || add_saltation(entered, *values)) && enter(entered, *values);
}

// From the beginning of the ball of times of the event.
explicit_system hybrid_path::branch_after(const entered_branch& entered, const step_values& values) const {
    const number begin = next_->exactly ? *next_->exactly : number_of(lower_bound(next_->time));
    return system_.branch(values, begin, midpoints(entered.state));
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
    const expression& g = crossed_->g;
    const ball slope_of_g = value_in(before, before.slope_of(before.in_leaves(g)), next_->state, time);
    if (!crossed_->time && contains_zero(slope_of_g)) {
        return ended(path_end::undecided,
                     "the derivative of the two sides of `" + crossed_->text + "` is not distinguished from 0 there");
    }
    for (const state_variation& each : system_.variations()) {
        ball of_time(0);
        for (std::size_t l = 0; l < leaves.size() && !crossed_->time; ++l) {
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

// From the states after the event at a time of its ball to the branch from the beginning of that ball.
bool hybrid_path::enter(const entered_branch& entered, const step_values& values) {
    if (!std::ranges::all_of(entered.state, [](const ball& x) { return is_finite(x); })) {
        return ended(path_end::undecided, "the states after the event are not enclosed");
    }
    const ball times = next_->time;
    const ball begin = lower_bound(times);
    auto piece = std::make_unique<path_piece>(branch_after(entered, values));
    piece->steps = values;
    piece->state = entered.state;
    piece->on_the_way = entered.state;
    if (piece->system.singular()) {
        return ended(path_end::steps, "the next branch is singular at its beginning");
    }
    if (!next_->exactly) {
        const first_order_form form(piece->system);
        auto around = states_around(form, entered.state, times);
        if (!around) {
            return ended(path_end::undecided, "the states after the event are not enclosed");
        }
        piece->state = states_moved(form, entered.state, times, *around, begin);
        piece->begins = times;
        piece->on_the_way = *std::move(around);
    }
    before_last_ = next_->on_the_way;
    reset_last_.clear();
    for (std::size_t k = 0; k < entered.leaves.size(); ++k) {
        reset_last_.push_back(!same_form(entered.leaves[k], system_.leaves()[k]));
    }
    last_time_ = times;
    ++count_;
    piece_ = std::move(piece);
    next_.reset();
    crossed_.reset();
    return search_branch(&entered);
}

}  // namespace libration::ode
