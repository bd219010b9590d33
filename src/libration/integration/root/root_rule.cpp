#include "root_rule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "../taylor/taylor_rule.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The passage begins where tau is within so many steps in t: near tau a step is at least a tenth of the distance.
constexpr unsigned long steps_to_root = 16;

magnitude least_root(const magnitude& distance, const root_time& about) {
    root_passage of;
    of.about = {about.time, about.degree, 1, true};
    return magnitude::below(of.root_of(distance.exact()));
}

}  // namespace

root_rule::root_rule(const explicit_system& of, std::vector<root_time> times, const run_bits& bits, proof_route route,
                     error_weights weights)
    : form_(of), times_(std::move(times)), bits_(bits), route_(std::move(route)), weights_(weights) {}

std::shared_ptr<root_passage> root_rule::passage_about(const root_time& about) const {
    auto passage = std::make_shared<root_passage>();
    passage->about = about;
    passage->leaves = form_.leaves;
    for (const expression& each : form_.slopes) {
        passage->slopes.push_back(in_root(each, about));
    }
    return passage;
}

std::shared_ptr<const step> root_rule::entry(const series_step& whole, int direction) const {
    const ball& time = whole.from().time;
    const root_time* nearest = nullptr;
    magnitude least;
    magnitude second;  // 0 if there is none
    for (const root_time& each : times_) {
        const ball away = constant_value<ball>::of(each.time) - time;
        const bool ahead = direction < 0 ? arb_is_negative(away.handle()) != 0 : arb_is_positive(away.handle()) != 0;
        if (!ahead || (!each.both && each.side == direction)) {
            continue;
        }
        const magnitude here = magnitude::below(away);
        if (nearest == nullptr || here < least) {
            second = nearest == nullptr ? magnitude() : least;
            least = here;
            nearest = &each;
        } else if (second.is_zero() || here < second) {
            second = here;
        }
    }
    if (nearest == nullptr || magnitude(whole.length()) * magnitude(steps_to_root) < least) {
        return nullptr;
    }
    const magnitude root = least_root(least, *nearest);
    if (!std::isnormal(as_double(root.exact()))) {
        return nullptr;  // w, of 30 bits, is not exact as a double
    }
    auto passage = passage_about(*nearest);
    const ball tau = constant_value<ball>::of(nearest->time);
    passage->direction = nearest->both ? direction : -1;
    passage->begins = passage->direction < 0 ? root.exact() : -root.exact();
    passage->ends = ball(0);
    passage->leads_beyond = nearest->both;
    if (nearest->both) {
        // Up to as far beyond tau, but not beyond the middle of the way to the next roots.
        magnitude beyond = root;
        if (!second.is_zero()) {
            const ball gap = second.exact() - upper_bound(tau - time) * direction;
            beyond = std::min(beyond, least_root(magnitude::below(gap).shifted(-1), *nearest));
        }
        passage->ends = passage->direction < 0 ? -beyond.exact() : beyond.exact();
    }
    ball distance = tau - time;
    const slong bits = is_exact(distance) ? ARF_PREC_EXACT : ball::working_bits();
    arb_add(distance.handle(), distance.handle(), passage->raised(passage->begins).handle(), bits);
    if (!whole.reaches(distance)) {
        return nullptr;
    }
    const explicit_system system = in_root(form_, *nearest, number(rational(as_double(passage->begins))));
    auto rule = std::make_shared<taylor_rule>(lifted(system, relative_functions::kept), bits_, route_, weights_);
    passage->rule = rule;
    auto made = std::make_shared<root_entry>(whole, distance, std::move(passage));
    rule->begin(dynamic_cast<const root_state&>(*made->end().more).inner);
    return made;
}

std::shared_ptr<const root_passage> root_rule::passage_from_start(const explicit_system& system) const {
    auto passage = passage_about({system.point(), system.singular()->root, 1, false});
    const explicit_system inner = in_root_of_start(system);
    passage->direction = 1;
    passage->ends = ball(0);
    passage->leads_beyond = true;
    proof_route in_series = route_;
    in_series.integrator = integrator_choice::taylor;
    passage->rule = rule_for(inner, bits_, in_series, weights_);
    return passage;
}

flow_state root_rule::begin_at_start(const std::shared_ptr<const root_passage>& passage, flow_state start) {
    start.time = ball(0);
    passage->rule->begin(start);
    return state_in_root(passage, std::move(start), false);
}

bool root_rule::leads_towards(const flow_state& from, int direction) {
    const auto& at = dynamic_cast<const root_state&>(*from.more);
    const root_passage& passage = *at.passage;
    const ball rest = (passage.ends - at.inner.time) * passage.direction;
    const bool is_beyond = passage.leads_beyond && at.has_moved && arb_is_positive(rest.handle()) == 0;
    return passage.direction * passage.about.side == direction && !is_beyond;
}

next_step root_rule::next(const flow_state& from) {
    const auto& at = dynamic_cast<const root_state&>(*from.more);
    next_step inner = at.passage->rule->next(at.inner, infinite_distance(at.passage->direction));
    if (!inner.made) {
        return inner;
    }
    const auto made = std::make_shared<root_step>(from, at, std::move(inner.made));
    return {made, made->is_last() ? stop::step_too_small : inner.why};
}

}  // namespace libration::ode
