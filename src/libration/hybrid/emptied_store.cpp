// A store that becomes empty at a time at which its outflow is not differentiable: theorem H, "Emptying".
#include "../equation/emptied_store.hpp"
#include "../equation/sign_by_form.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "../equation/bound_text.hpp"
#include "branch_search.hpp"
#include "emptying_flow.hpp"
#include "libration/equation/identities.hpp"
#include "libration/hybrid/hybrid_path.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long steps_to_emptying = 300;

expression at_zero_of(const expression& e, const expression& leaf) {
    return replaced(
        e, [&](const expression& each) { return same_form(each, leaf) ? std::optional(expression()) : std::nullopt; });
}

// [0, 2^e] with 2^e >= x, without an end below 0.
ball from_zero_beyond(const ball& x) {
    fmpz_t e;
    fmpz_init(e);
    arf_abs_bound_lt_2exp_fmpz(e, arb_midref(upper_bound(x).handle()));
    ball result(1);
    mag_one(arb_radref(result.handle()));
    arb_mul_2exp_fmpz(result.handle(), result.handle(), e);
    arb_mul_2exp_si(result.handle(), result.handle(), -1);
    fmpz_clear(e);
    return result;
}

// The states from a time on until an unknown h with -h' = h^exponent outflow is 0.
class emptying_box {
public:
    emptying_box(const explicit_system& system, std::size_t leaf, const std::vector<ball>& state, const ball& begin)
        : form_(system), leaf_(leaf), highest_(from_zero_beyond(state[leaf])), box_(state), begin_(begin), end_(begin) {
        box_[leaf] = highest_;
    }

    const std::vector<ball>& states() const { return box_; }
    ball times() const { return hull(begin_, end_); }

    // Over the box; powers of h are enclosed as such, since balls of roots about 0 are not.
    ball value(const expression& e) const {
        std::vector<expression> leaves = form_.leaves;
        std::vector<ball> known = box_;
        const expression open = with_nodes_replaced(form_.in_leaves(e), [&](const expression& node) {
            const bool root = node.kind() == node_kind::function || node.kind() == node_kind::power;
            const leaf_power power = root ? power_of_leaf(node, form_.leaves[leaf_]) : leaf_power{0, node};
            if (power.exponent <= 0 || power.rest.kind() != node_kind::constant) {
                return std::optional<expression>();
            }
            leaves.push_back(unknown("power " + std::to_string(leaves.size())));
            known.push_back(enclosed_number(power.rest.constant()) *
                            from_zero_beyond(power_of_ball(upper_bound(highest_), power.exponent)));
            return std::optional(leaves.back());
        });
        expression_values<ball> values(leaves, times());
        for (const ball& each : known) {
            values.push_back(each);
        }
        return values.of(open);
    }

    // Up to a time at which h is certainly 0: twice what the box at the beginning gives, with the others moved by twice
    // their slopes there. False if that is not confirmed on the box.
    bool extend(const rational& exponent, const expression& outflow, const std::vector<expression>& slopes) {
        const rational rest = 1 - exponent;
        const auto lasts = [&] {
            return upper_bound(power_of_ball(upper_bound(highest_), rest) /
                               (lower_bound(value(outflow)) * constant_value<ball>::of(number(rest))));
        };
        const ball room = ball(2) * lasts();
        if (!is_finite(room) || known_sign(room) <= 0) {
            return false;
        }
        end_ = begin_ + room;
        const auto moves = [&](std::size_t j) { return magnitude(value(slopes[j])) * magnitude(room); };
        std::vector<magnitude> most;
        for (std::size_t j = 0; j < box_.size(); ++j) {
            most.push_back(j == leaf_ ? magnitude() : moves(j) * magnitude(2U));
        }
        for (std::size_t j = 0; j < box_.size(); ++j) {
            box_[j] = j == leaf_ ? box_[j] : widened(box_[j], most[j]);
        }
        bool inside = known_sign(value(outflow)) > 0 && certainly_less(lasts(), room);
        for (std::size_t j = 0; j < box_.size(); ++j) {
            inside = inside && is_finite(box_[j]) && (j == leaf_ || moves(j) <= most[j]);
        }
        return inside;
    }

private:
    first_order_form form_;
    std::size_t leaf_;
    ball highest_;
    std::vector<ball> box_;
    ball begin_, end_;
};

}  // namespace

// The outflow -h' = h^exponent outflow of an unknown h, the argument of this sign, at a state; std::nullopt if it does not
// empty as in the theorem.
std::optional<hybrid_path::emptying> hybrid_path::emptying_of(std::size_t step, const std::vector<ball>& state) const
    try {
    const expression leaf = system_.argument(step, piece_->steps);
    const auto& leaves = system_.leaves();
    const auto found = std::ranges::find_if(leaves, [&](const expression& each) { return same_form(each, leaf); });
    // The other steps that influence it have fixed values here unless their arguments remain 0; after a
    // change of one of them mode_after decides anew.
    const auto influences = system_.influences_on(leaf);
    bool others = false;
    for (std::size_t i = 0; i < influences.size(); ++i) {
        others = others ||
                 (influences[i] && i != step && system_.is_at_rest(i, piece_->steps) && !is_emptied(piece_->steps[i]));
    }
    if (found == leaves.end() || others || system_.steps()[step].kind != step_kind::sign ||
        is_emptied(piece_->steps[step]) || piece_->steps[step].sign() <= 0 || is_in_other_argument(step)) {
        return std::nullopt;
    }
    const auto k = static_cast<std::size_t>(found - leaves.begin());
    const auto above = slopes_in_given(piece_->system);
    const leaf_power flow = power_of_leaf(above[k], leaf);
    const expression last = at_zero_of(flow.rest, leaf);
    if (flow.exponent <= 0 || flow.exponent >= 1 || sign_by_form(last) >= 0) {
        return std::nullopt;
    }
    std::vector<number> starts = midpoints_of(state);
    starts[k] = number();
    for (const number& beside : {emptied_value(), number(rational(-1))}) {
        step_values values = piece_->steps;
        values[step] = beside;
        const auto slopes = slopes_in_given(system_.branch(values, piece_->system.point(), starts));
        for (std::size_t j = 0; j < slopes.size(); ++j) {
            const expression jump = j == k ? slopes[j] : at_zero_of(slopes[j], leaf) - at_zero_of(above[j], leaf);
            if (!is_identically_zero(jump)) {
                return std::nullopt;
            }
        }
    }
    return emptying{step, k, flow.exponent, -flow.rest};
} catch (const error&) {  // a branch without equations at 0
    return std::nullopt;
}

bool hybrid_path::is_in_other_argument(std::size_t step) const {
    return std::ranges::any_of(system_.steps(), [&](const step_function& each) {
        bool found = false;
        each_leaf(each.argument, [&](const expression& leaf) {
            found = found || (leaf.kind() == node_kind::parameter && system_.step_of(leaf.name()) == step);
        });
        return found;
    });
}

// Where the steps of a branch become too small because a store becomes empty: the event at which it is. Let h be in (0, h1]
// at the time s, and -h' >= c h^a on a box Z of the states in [0, h1] and the others within w of those at s, and the others
// move by at most w in the time h1^(1 - a)/(c (1 - a)): h is 0 at the end of it at the latest.
bool hybrid_path::find_empty_store() {
    if (observed_ != nullptr || !system_.variations().empty() || piece_->along->made() == 0) {
        return false;
    }
    const std::vector<ball> state = piece_->along->last().set.hull();
    const auto surfaces = system_.surfaces(piece_->steps);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const surface& each = surfaces[i];
        const bool store = each.steps.size() == 1 && each.events.empty() && !each.time;
        const auto of = store ? emptying_of(each.steps.front().index, state) : std::nullopt;
        if (!of || !search_->is_last_before_end(i)) {
            continue;
        }
        emptying_box box(piece_->system, of->leaf, state, piece_->along->reached());
        const bool alone = box.extend(of->exponent, of->outflow, slopes_in_given(piece_->system)) &&
                           std::ranges::all_of(surfaces, [&](const surface& other) {
                               return same_form(other.g, each.g) || known_sign(box.value(other.g)) != 0;
                           });
        if (alone) {
            next_ = path_event{.time = box.times(), .way = crossing::down, .state = box.states(), .text = each.text};
            next_->on_the_way = next_->state;
            next_->state[of->leaf] = ball(0);
            crossed_ = {{each, crossing::down}};
            emptied_ = of->step;
            return true;
        }
    }
    return false;
}

// Before a store becomes empty, by a run with few bits, on which no proof depends: at 3/4 of the way.
void hybrid_path::look_for_emptying() {
    constexpr long few_bits = 64;
    search_->emptying = emptying_plan{};
    if (!system_.variations().empty()) {
        return;
    }
    const flow_state& start = piece_->along->start();
    const std::vector<ball> state = start.set.hull();
    std::vector<ball> middle;
    std::ranges::transform(state, std::back_inserter(middle), [](const ball& x) { return midpoint_alone(x); });
    const auto surfaces = system_.surfaces(piece_->steps);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const bool store = surfaces[i].steps.size() == 1 && surfaces[i].events.empty() && !surfaces[i].time;
        const auto of = store ? emptying_of(surfaces[i].steps.front().index, state) : std::nullopt;
        if (!of || known_sign(state[of->leaf]) <= 0) {
            continue;
        }
        try {
            emptying_flow scout(piece_->system, {of->leaf, of->exponent, of->outflow}, middle, start.time, few_bits,
                                route_);
            const bool first = scout.reach(steps_to_emptying) && certainly_less(start.time, scout.time()) &&
                               (!search_->emptying->surface ||
                                certainly_less(scout.time(), enclosed_number(search_->emptying->about)));
            if (first) {
                search_->emptying =
                    emptying_plan{.surface = i, .about = number_of(midpoint_alone(scout.time())), .left = 4};
                search_->emptying->advance(number_of(start.time));
            }
        } catch (const error&) {  // no analytic flow
        }
    }
}

// The event at which the store of the plan becomes empty, from the time before it up to which no surface is crossed; false if
// that is not proved from there.
bool hybrid_path::find_planned_emptying() {
    emptying_plan& plan = *search_->emptying;
    const auto surfaces = system_.surfaces(piece_->steps);
    const surface& own = surfaces[*plan.surface];
    const auto state = state_before(plan.before);
    const auto of = state ? emptying_of(own.steps.front().index, *state) : std::nullopt;
    if (of && known_sign((*state)[of->leaf]) > 0) {
        try {
            emptying_flow flow(piece_->system, {of->leaf, of->exponent, of->outflow}, *state,
                               enclosed_number(plan.before), bits_, route_);
            const auto is_excluded = [&](const surface& other) {
                return same_form(other.g, own.g) || flow.excludes_zero(other.g);
            };
            if (flow.reach(steps_to_emptying) && std::ranges::all_of(surfaces, is_excluded) &&
                (observed_ == nullptr || observed_orientation(own) != 0 || flow.excludes_zero(*observed_))) {
                plan.event = path_event{.time = flow.time(),
                                        .way = crossing::any,
                                        .state = flow.state(),
                                        .on_the_way = flow.states_before(),
                                        .text = own.text};
                plan.step = of->step;
                return true;
            }
        } catch (const error&) {  // no analytic flow
        }
    }
    plan.advance(plan.before);
    return false;
}

// Whether the branch ends where a store becomes empty, or is followed up to the end before that; std::nullopt if neither is
// known.
std::optional<bool> hybrid_path::find_emptying(const std::optional<number>& end) {
    emptying_plan& plan = *search_->emptying;
    if (!plan.event && !find_planned_emptying()) {
        return std::nullopt;
    }
    if (end && certainly_less(enclosed_number(*end), plan.event->time)) {
        return ended(path_end::time);
    }
    next_ = plan.event;
    crossed_ = {{system_.surfaces(piece_->steps)[*plan.surface], crossing::down}};
    emptied_ = plan.step;
    if (is_observed(crossed_.front().of, crossing::any)) {
        observed_event_ = next_;
    }
    return true;
}

// What is known where the steps become too small next to the surface of a store.
std::string hybrid_path::reason_at_store() const {
    constexpr long bits_of_near = 40;
    const std::vector<ball> state = piece_->along->last().set.hull();
    const std::vector<ball> first = piece_->along->start().set.hull();
    for (const surface& each : system_.surfaces(piece_->steps)) {
        const auto& leaves = system_.leaves();
        const auto found =
            std::ranges::find_if(leaves, [&](const expression& leaf) { return same_form(leaf, each.g); });
        if (each.steps.empty() || found == leaves.end()) {
            continue;
        }
        const auto k = static_cast<std::size_t>(found - leaves.begin());
        const magnitude now(state[k]);
        if (now < magnitude(first[k]).shifted(-bits_of_near)) {
            return ", where the two sides of `" + each.text + "` differ by at most " + upper_bound_text(now.exact()) +
                   ": a store is followed beyond the time at which it becomes empty only if it has no inflow, its "
                   "outflow is h^a, "
                   "0 < a < 1, times a function that is positive by its form at h = 0, and nothing else jumps or "
                   "switches then";
        }
    }
    return "";
}

bool hybrid_path::continue_emptied() {
    step_values values = piece_->steps;
    values[*emptied_] = emptied_value();
    const entered_branch entered{system_.leaves(), next_->state};
    const branch_beginning beginning(system_, next_->time, std::nullopt, entered.leaves, zero_functions(),
                                     entered.state, piece_->kept);
    const bool entering = enter(entered, values, beginning);
    emptied_.reset();
    return entering;
}

}  // namespace libration::ode
