#include "root_step.hpp"

#include "../first_step.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// An exact number x >= 0 or, of a root that is real on both sides, any x.
ball exact_root(const ball& x, int degree) {
    ball result;
    if (arb_is_zero(x.handle()) != 0) {
        return result;  // of which arb_root_ui is not a number
    }
    arb_abs(result.handle(), x.handle());
    arb_root_ui(result.handle(), result.handle(), static_cast<ulong>(degree), ball::working_bits());
    return arb_is_negative(x.handle()) != 0 ? -result : result;
}

// w after a step, but not beyond tau if the roots are not real there.
ball root_after(const step& inner, const root_passage& passage) {
    const ball after = inner.end_time();
    return passage.about.both || arb_is_positive(after.handle()) != 0 ? after : ball(0);
}

ball exact_difference(const ball& a, const ball& b) {
    ball result;
    arb_sub(result.handle(), a.handle(), b.handle(), ARF_PREC_EXACT);
    return result;
}

// Exact, and not shorter than a distance.
ball length_to(const ball& distance) {
    return is_exact(distance)                        ? distance
           : arb_is_negative(distance.handle()) != 0 ? lower_bound(distance)
                                                     : upper_bound(distance);
}

}  // namespace

ball root_passage::raised(const ball& w) const {
    ball result;
    arb_pow_ui(result.handle(), w.handle(), static_cast<ulong>(about.degree),
               is_exact(w) ? ARF_PREC_EXACT : ball::working_bits());
    return about.side < 0 ? -result : result;
}

ball root_passage::root_of(const ball& distance) const {
    const ball power = about.side < 0 ? -distance : distance;
    ball lower = lower_bound(power);
    ball upper = upper_bound(power);
    if (!about.both) {
        for (ball* const each : {&lower, &upper}) {
            if (arb_is_negative(each->handle()) != 0) {
                *each = ball(0);
            }
        }
    }
    return hull(exact_root(lower, about.degree), exact_root(upper, about.degree));
}

ball root_passage::time_of(const ball& w) const {
    ball result = constant_value<ball>::of(about.time);
    arb_add(result.handle(), result.handle(), raised(w).handle(), ARF_PREC_EXACT);
    return result;
}

flow_state state_in_root(std::shared_ptr<const root_passage> passage, flow_state inner, bool has_moved) {
    flow_state result{passage->time_of(inner.time), inner.set, inner.derivative, {}};
    result.more = std::make_shared<root_state>(std::move(passage), std::move(inner), has_moved);
    return result;
}

root_entry::root_entry(const series_step& whole, const ball& distance, std::shared_ptr<const root_passage> passage)
    : series_step(whole.from(), whole.series(), length_to(distance), distance), passage_(std::move(passage)) {}

flow_state root_entry::end() const {
    flow_state inner = series_step::end();
    inner.time = passage_->begins;
    return state_in_root(passage_, std::move(inner), false);
}

root_step::root_step(const flow_state& from, const root_state& at, std::shared_ptr<const step> inner)
    : root_step(from, at, inner, root_after(*inner, *at.passage)) {}

root_step::root_step(const flow_state& from, const root_state& at, std::shared_ptr<const step> inner, const ball& last)
    : step({from.time, inner->from().set, inner->from().derivative, {}},
           exact_difference(at.passage->raised(last), at.passage->raised(at.inner.time)), inner->made()),
      passage_(at.passage),
      inner_(std::move(inner)),
      is_last_(!passage_->about.both && arb_is_zero(last.handle()) != 0),
      end_time_(passage_->time_of(last)) {}

ball root_step::root_at(const ball& distance) const {
    ball away = passage_->raised(inner_->from().time);
    arb_add(away.handle(), away.handle(), distance.handle(),
            is_exact(distance) ? ARF_PREC_EXACT : ball::working_bits());
    return passage_->root_of(away);
}

std::vector<ball> root_step::slopes_in_root(const ball& w, const std::vector<ball>& state) const {
    expression_values<ball> values(passage_->leaves, w);
    for (const ball& each : state) {
        values.push_back(each);
    }
    std::vector<ball> result;
    for (const expression& each : passage_->slopes) {
        result.push_back(values.of(each));
    }
    return result;
}

// Near tau a narrow ball of times is a wide one of w. There the values are also y(m) + y' (t - m), m the midpoint of the
// ball of times, or tau if that is beyond it.
std::vector<ball> root_step::values(const ball& distance) const {
    const ball w = root_at(distance);
    auto state = values_in_root(w);
    if (is_exact(distance)) {
        return state;
    }
    const ball gone = distance - exact_midpoint(distance);
    const auto middle = values_in_root(root_at(exact_midpoint(distance)));
    const auto slopes = slopes_in_root(w, state);
    for (std::size_t k = 0; k < state.size(); ++k) {
        ball other = middle[k] + slopes[k] * gone;
        if (is_finite(other) && magnitude::radius_of(other) < magnitude::radius_of(state[k])) {
            state[k] = std::move(other);
        }
    }
    return state;
}

std::vector<ball> root_step::slopes(const ball& distance) const {
    const ball w = root_at(distance);
    return slopes_in_root(w, values_in_root(w));
}

ball_matrix root_step::derivative(const ball& distance) const {
    return inner_->derivative(root_at(distance) - inner_->from().time);
}

// After the first step of theorem S in w another one follows.
flow_state root_step::end() const {
    return state_in_root(passage_, inner_->end(), dynamic_cast<const singular_first_step*>(inner_.get()) == nullptr);
}

}  // namespace libration::ode
