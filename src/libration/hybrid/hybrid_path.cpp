#include "libration/hybrid/hybrid_path.hpp"

#include <algorithm>
#include <utility>

#include "../equation/bound_text.hpp"
#include "../equation/condition_system.hpp"
#include "branch_search.hpp"
#include "libration/hybrid/initial_mode.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/error.hpp"
#include "states_around.hpp"

namespace libration::ode {

namespace {

// The direction in which a function crosses 0 where the other one, of this orientation to it, crosses in `way`.
crossing turned(crossing way, int orientation) {
    return orientation > 0 || way == crossing::any ? way : way == crossing::up ? crossing::down : crossing::up;
}

}  // namespace

hybrid_path::hybrid_path(const hybrid_system& system, long bits, proof_route route, march_watch watch,
                         const expression* observed, crossing observed_way)
    : system_(system),
      bits_(bits),
      route_(std::move(route)),
      watch_(std::move(watch)),
      observed_(observed),
      observed_way_(observed_way) {
    const precision_scope scope(decimal_digits(bits) + 10);
    const initial_mode mode = mode_at_start(system);
    note_relations(mode.by_relation);
    piece_ = std::make_unique<path_piece>(system.first_branch(*mode.values));
    if (piece_->system.singular()) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "has a singular initial point, where events and piecewise right-hand sides are not supported: "
                    "choose another initial point");
    }
    piece_->steps = *mode.values;
    piece_->kept = branch_beginning(system).kept();
    first_time_ = enclosed_number(system.point());
    last_time_ = first_time_;
    search_branch(nullptr);
}

hybrid_path::~hybrid_path() = default;

long hybrid_path::steps() const {
    return steps_ + (search_ ? search_->steps() : 0) + (piece_->along ? piece_->along->cost() : 0);
}

bool hybrid_path::ended(path_end why, std::string reason) {
    end_ = why;
    reason_ = std::move(reason);
    return false;
}

void hybrid_path::note_relations(const std::vector<std::size_t>& steps) {
    for (const std::size_t i : steps) {
        const std::string& text = system_.steps()[i].text;
        if (std::ranges::find(by_relation_, text) == by_relation_.end()) {
            by_relation_.push_back(text);
        }
    }
}

// Of the present branch, from branches before with the same equations if there are any.
std::shared_ptr<step_rule> hybrid_path::rule_of_branch() {
    const first_order_form form(piece_->system);
    const auto known = std::ranges::find_if(modes_, [&](const followed_mode& each) {
        return std::ranges::equal(each.slopes, form.slopes,
                                  [](const expression& a, const expression& b) { return same_form(a, b); });
    });
    if (known != modes_.end()) {
        return known->rule;
    }
    modes_.push_back({form.slopes, rule_for(piece_->system, {bits_}, route_)});
    return modes_.back().rule;
}

void hybrid_path::begin_steps() {
    flow_state start = start_of(piece_->system, bits_);
    if (piece_->state) {
        start.set = piece_->set ? *piece_->set : box_around(*piece_->state, bits_);
    }
    state_step_ = 0;
    piece_->along =
        std::make_unique<integration>(std::move(start), rule_of_branch(), infinite_distance(1), bits_, watch_);
    if (watch_) {
        watch_(last_time_, bits_);
    }
}

// The surfaces of the branch with the signs of their functions directly after its beginning.
bool hybrid_path::search_branch(const branch_beginning* beginning) {
    begin_steps();
    auto surfaces = system_.surfaces(piece_->steps);
    if (observed_ != nullptr) {
        hybrid_system::add_surface(surfaces, *observed_, "the condition");
    }
    std::vector<watched_surface> watched;
    for (surface& each : surfaces) {
        const crossing way = way_of(each);
        std::optional<search_start> start;
        if (beginning != nullptr) {
            start = start_on(each, *beginning);
            if (!start) {
                return false;
            }
        }
        watched.push_back({std::move(each), way, std::move(start)});
    }
    search_ = std::make_unique<branch_search>(piece_->system, std::move(watched), last_time_, bits_, *piece_->along);
    return true;
}

// The only direction in which a crossing matters; `any` if both do.
crossing hybrid_path::way_of(const surface& of) const {
    if (!of.steps.empty()) {
        return crossing::any;
    }
    std::vector<crossing> ways;
    for (const crossing_effect& each : of.events) {
        ways.push_back(turned(system_.events()[each.index].way, each.orientation));
    }
    if (const int same = observed_orientation(of); same != 0) {
        ways.push_back(turned(observed_way_, same));
    }
    const bool one = std::ranges::all_of(ways, [&](crossing way) { return way == ways.front(); });
    return one ? ways.front() : crossing::any;
}

// 1 or -1 if the zeros of the observed function are those of the surface; 0 otherwise.
int hybrid_path::observed_orientation(const surface& of) const {
    if (observed_ == nullptr) {
        return 0;
    }
    if (const auto linear = linear_in_variable::of(*observed_); linear && of.time) {
        return (linear->time_of(number()) - *of.time).sign() == 0 ? linear->slope.sign() : 0;
    }
    return relative_sign(of.g, *observed_);
}

bool hybrid_path::is_observed(const surface& of, crossing way) const {
    const int orientation = observed_orientation(of);
    return orientation != 0 && (observed_way_ == crossing::any || turned(observed_way_, orientation) == way);
}

bool hybrid_path::happens(const crossing_effect& event, crossing way) const {
    const crossing own = system_.events()[event.index].way;
    return way != crossing::any && (own == crossing::any || turned(own, event.orientation) == way);
}

// A step function whose argument touches 0 does not change the branch: a single moment counts for nothing.
bool hybrid_path::has_effect(const surface& of, crossing way) const {
    return (way != crossing::any && !of.steps.empty()) ||
           std::ranges::any_of(of.events, [&](const crossing_effect& each) { return happens(each, way); });
}

// The next crossing that ends the branch or is observed; false for the reason end().
bool hybrid_path::find(const std::optional<number>& end, const std::optional<number>& farthest, long horizon) {
    if (!search_) {
        return false;  // the path has ended
    }
    piece_->along->aim(farthest ? enclosed_number(*farthest) : infinite_distance(1));
    if (next_) {
        return true;
    }
    end_ = path_end::none;
    for (;;) {
        if (!search_->emptying) {
            look_for_emptying();
        }
        const emptying_plan& plan = *search_->emptying;
        const bool empties = plan.surface && (!end || (plan.before - *end).sign() < 0);
        const auto found = search_->next(empties ? plan.before : end, horizon);
        if (!found && empties && search_->end() == path_end::time) {
            if (const auto emptied = find_emptying(end)) {
                return *emptied;
            }
            continue;
        }
        if (!found) {
            const bool steps_end = search_->end() == path_end::steps || search_->end() == path_end::precision;
            if (steps_end && find_empty_store()) {
                return true;
            }
            const bool small = search_->end() == path_end::steps;
            return ended(search_->end(), search_->reason() + (small ? reason_at_store() : ""));
        }
        path_event event = event_of(*found);
        const auto observed = std::ranges::find_if(
            found->crossed, [&](const crossed_surface& each) { return is_observed(each.of, each.way); });
        if (observed != found->crossed.end()) {
            event.way = observed->way;
            observed_event_ = event;
        }
        if (std::ranges::any_of(found->crossed,
                                [&](const crossed_surface& each) { return has_effect(each.of, each.way); })) {
            crossed_ = found->crossed;
            next_ = std::move(event);
            return true;
        }
        for (const crossed_surface& each : found->crossed) {
            if (each.way == crossing::any && std::ranges::any_of(each.of.events, [&](const crossing_effect& effect) {
                    return system_.events()[effect.index].way == crossing::any;
                })) {
                return ended(path_end::undecided,
                             "the sides of `" + each.of.text +
                                 "` are equal at a time at which the sign of their difference does "
                                 "not change, which is not an event: write the time, as `when t = 1`");
            }
        }
        for (const std::size_t each : found->surfaces) {
            search_->resume(each);
        }
        if (observed != found->crossed.end()) {
            return true;
        }
    }
}

// With the state at the time, if that is not known exactly.
path_event hybrid_path::event_of(const found_crossing& found) const {
    const crossed_surface& first = found.crossed.front();
    path_event event = {.time = {}, .exactly = found.exactly, .way = first.way, .state = {}, .text = first.of.text};
    if (!found.event) {
        event.time = enclosed_number(*found.exactly);
        return event;
    }
    event.time = found.event->time;
    event.state = found.event->state;
    event.on_the_way = event.state;
    const auto given = given_values(piece_->system, first.of.g);
    for (std::size_t k = 0; k < given.size(); ++k) {
        event.state[k] = given[k] ? enclosed_number(*given[k]) : event.state[k];
    }
    put_kept(piece_->kept, event.state);
    put_kept(piece_->kept, event.on_the_way);
    return event;
}

// The state before an event at a known time; false if it is not reached.
bool hybrid_path::complete(path_event& event) {
    if (event.state.empty()) {
        auto state = state_before(*event.exactly);
        event.state = state ? *std::move(state) : std::vector<ball>();
    }
    return !event.state.empty();
}

// The state on the branch, which does not end before this time.
std::optional<std::vector<ball>> hybrid_path::state_before(const number& time) {
    integration& along = *piece_->along;
    state_step_ = std::max(state_step_, along.first());
    const auto place = steps_about(along, state_step_, enclosed_number(time));
    if (place) {
        std::vector<ball> state = values_at(*place);
        put_kept(piece_->kept, state);
        // The argument of a sign along the surface of which the solution remains is 0.
        for (std::size_t i = 0; i < piece_->steps.size(); ++i) {
            if (system_.is_at_rest(i, piece_->steps)) {
                const auto given = given_values(piece_->system, system_.argument(i, piece_->steps));
                for (std::size_t k = 0; k < given.size(); ++k) {
                    state[k] = given[k] ? enclosed_number(*given[k]) : state[k];
                }
            }
        }
        return state;
    }
    ended(along.why() == stop::step_too_small ? path_end::steps : path_end::precision,
          "the step size falls below its minimum at time " + proved_reach_text(along.reached(), true) +
              " (probably a singularity)");
    return std::nullopt;
}

// -1 before the event, 0 if that is not decided, 1 at a known time or after it.
int hybrid_path::before_or_after(const number& time, const path_event& event) {
    if (event.exactly) {
        return (time - *event.exactly).sign() < 0 ? -1 : 1;
    }
    return known_sign(enclosed_number(time) - event.time);
}

std::optional<std::vector<ball>> hybrid_path::at(const number& time, const number& last) {
    const precision_scope scope(decimal_digits(bits_) + 10);
    at_event_ = false;
    try {
        for (;;) {
            if (piece_->begins && overlaps(enclosed_number(time), *piece_->begins)) {
                at_event_ = true;
                return state_at_event();
            }
            if (!find(time, last, 0)) {
                const bool before_end =
                    end_ == path_end::time || (search_ && search_->has_reached() && certainly_before(time));
                return before_end ? state_before(time) : std::nullopt;
            }
            if (before_or_after(time, *next_) < 0) {
                return state_before(time);
            }
            if (!take()) {
                return std::nullopt;
            }
        }
    } catch (const precision_exhausted&) {
        ended(path_end::precision);
    }
    return std::nullopt;
}

// Before and after the event at which the branch begins. There a value that jumps has no derivative with respect to a
// number that moves the event, nor has one whose derivative jumps.
std::vector<ball> hybrid_path::state_at_event() const {
    ball unbounded;
    arb_zero_pm_inf(unbounded.handle());
    std::vector<ball> both;
    for (std::size_t k = 0; k < before_last_.size(); ++k) {
        both.push_back(hull(before_last_[k], piece_->on_the_way[k]));
    }
    for (const state_variation& each : system_.variations()) {
        for (std::size_t k = 0; k < each.size(); ++k) {
            if (each[k] && (reset_last_[k] || !overlaps(before_last_[*each[k]], piece_->on_the_way[*each[k]]))) {
                both[*each[k]] = unbounded;
            }
        }
    }
    return both;
}

bool hybrid_path::certainly_before(const number& time) const {
    return arb_lt(enclosed_number(time).handle(), search_->reached().handle()) != 0;
}

std::optional<path_event> hybrid_path::next_observed(const std::optional<number>& end, long horizon) {
    const precision_scope scope(decimal_digits(bits_) + 10);
    try {
        for (;;) {
            if (observed_event_) {
                unobserved_ = search_ ? -search_->most_steps() : 0;
                return complete(*observed_event_) ? std::exchange(observed_event_, std::nullopt) : std::nullopt;
            }
            if (!end && unobserved_ >= horizon) {
                ended(path_end::horizon);
                return std::nullopt;
            }
            if (next_ ? !take() : !find(end, end, horizon)) {
                return std::nullopt;
            }
        }
    } catch (const precision_exhausted&) {
        ended(path_end::precision);
    }
    return std::nullopt;
}

}  // namespace libration::ode
