#include "libration/ode/proved/event_search.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

constexpr int first_pieces = 4;
constexpr int deepest = 60;
constexpr int most_newton_steps = 100;

bool vanishes_at_start(const expression& g, const first_order_form& form, const number& point) {
    const expression value = replaced(g, [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() == node_kind::variable) {
            return expression(point);
        }
        for (std::size_t k = 0; k < form.leaves.size(); ++k) {
            if (same_form(leaf, form.leaves[k])) {
                return expression(form.starts[k]);
            }
        }
        return std::nullopt;
    });
    return value.is(0);
}

}  // namespace

event_search::event_search(const explicit_system& system, const expression& g, long bits, int direction,
                           const proof_route& route)
    : form_(system),
      g_(form_.in_leaves(g)),
      slope_(form_.slope_of(g_)),
      zero_at_start_(vanishes_at_start(g_, form_, system.point())),
      march_(system, bits, {}, proved_march::usual_error_bits, route),
      direction_(direction < 0 ? -1 : 1) {
    if (march_.before().empty()) {
        return;
    }
    if (direction_ < 0) {
        throw error(error_kind::argument, "problem", "",
                    "starts where its equation is singular, behind which alone events are searched");
    }
    // After a singular start: no event on the way to the first step.
    zero_at_start_ = false;
    const ball start = constant_value<ball>::of(system.point());
    expression_values<ball> values(form_.leaves, hull(start, march_.reached()));
    for (const ball& each : march_.before()) {
        values.push_back(each);
    }
    if (contains_zero(values.of(g_))) {
        throw error(error_kind::undecided, "event", "",
                    "is not told from one within the first step from the start, where the equation is singular");
    }
}

event_search::sample event_search::sampled(const ball& distance) const {
    expression_values<ball> values(form_.leaves, march_.reached() + distance);
    auto state = march_.values_at(distance);
    for (const ball& each : state) {
        values.push_back(each);
    }
    return {values.of(g_), values.of(slope_), std::move(state)};
}

bool event_search::is_start(const ball& distance) const {
    return zero_at_start_ && march_.steps() == 0 && arb_is_zero(distance.handle()) != 0;
}

// The piece, a little longer, where g has opposite signs at its ends; nothing where it has the same.
std::optional<ball> event_search::bracket(const ball& from, const ball& to, const ball& slope) const {
    const auto sign_at = [&](const ball& distance) {
        const ball value = sampled(distance).value;
        return contains_zero(value) ? 0 : arb_is_positive(value.handle()) != 0 ? 1 : -1;
    };
    if (is_start(from)) {
        return std::nullopt;  // g is monotone, and 0 at the start
    }
    const int forwards = (arb_is_positive(slope.handle()) != 0 ? 1 : -1) * direction_;
    int before = sign_at(from);
    int behind = sign_at(to);
    ball first = from;
    ball last = to;
    // An end too near to a zero is moved outwards, where the derivative still has its sign.
    const ball more = (to - from) / 8;
    if (before == 0) {
        first = from - more;
    }
    if (behind == 0) {
        last = to + more;
    }
    if (before == 0 || behind == 0) {
        if (contains_zero(sampled(hull(first, last)).slope)) {
            throw precision_exhausted("an event");
        }
        before = before == 0 ? sign_at(first) : before;
        behind = behind == 0 ? sign_at(last) : behind;
    }
    if (before == 0 || behind == 0) {
        throw precision_exhausted("an event");
    }
    if (before == behind) {
        return std::nullopt;
    }
    if (behind != forwards) {
        throw std::logic_error("a monotone function that turns");
    }
    return hull(first, last);
}

void event_search::add_event(const ball& within) {
    ball place = within;
    for (int i = 0; i < most_newton_steps; ++i) {
        ball middle;
        arf_set(arb_midref(middle.handle()), arb_midref(place.handle()));
        const ball next = middle - sampled(middle).value / sampled(place).slope;
        ball narrower;
        if (!is_finite(next) ||
            arb_intersection(narrower.handle(), place.handle(), next.handle(), ball::working_bits()) == 0) {
            break;
        }
        const bool done = magnitude::radius_of(place) <= magnitude::radius_of(narrower) * magnitude(2U);
        place = narrower;
        if (done) {
            break;
        }
    }
    sample here = sampled(place);
    proved_event event{march_.reached() + place, std::move(here.state),
                       (arb_is_positive(here.slope.handle()) != 0) == (direction_ > 0) ? crossing::up : crossing::down};
    if (last_ && overlaps(*last_, event.time)) {
        return;  // the same one, seen from the step before
    }
    last_ = event.time;
    found_.push_back(std::move(event));
}

void event_search::examine(const ball& from, const ball& to, int depth) {
    sample all;
    {
        const precision_scope few(20);
        all = sampled(hull(from, to));
    }
    if (!contains_zero(all.value)) {
        return;
    }
    if (!contains_zero(all.slope)) {
        if (const auto place = bracket(from, to, all.slope)) {
            add_event(*place);
        }
        return;
    }
    if (depth == 0) {
        throw precision_exhausted("an event");
    }
    ball middle;
    const ball centre = (from + to) / 2;
    arf_set(arb_midref(middle.handle()), arb_midref(centre.handle()));
    examine(from, middle, depth - 1);
    examine(middle, to, depth - 1);
}

std::optional<proved_event> event_search::next(crossing way, const std::optional<number>& end) {
    for (const long first = march_.steps();;) {
        if (march_.steps() - first > most_steps_between) {
            throw error(error_kind::undecided, "event", "",
                        "is not found within " + std::to_string(most_steps_between) + " steps");
        }
        while (!found_.empty()) {
            proved_event event = std::move(found_.front());
            found_.erase(found_.begin());
            if (way == crossing::any || way == event.way) {
                return event;
            }
        }
        if (examined_) {
            march_.step(direction_);
            examined_ = false;
        }
        if (end) {
            const ball rest = (constant_value<ball>::of(*end) - march_.reached()) * direction_;
            if (arb_is_nonpositive(rest.handle()) != 0) {
                return std::nullopt;
            }
        }
        if (!march_.prepare()) {
            stopped_ = true;
            return std::nullopt;
        }
        const ball length = march_.length().exact() * direction_;
        for (int piece = 0; piece < first_pieces; ++piece) {
            examine(length * piece / first_pieces, length * (piece + 1) / first_pieces, deepest);
        }
        examined_ = true;
    }
}

}  // namespace libration::ode
