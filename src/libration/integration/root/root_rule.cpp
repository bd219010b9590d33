#include "root_rule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The phase begins where tau is within so many steps in t: near tau a step is at least a tenth of the distance.
constexpr unsigned long steps_to_root = 16;

// side w^degree, exactly for an exact w.
ball raised(const ball& w, const root_time& about) {
    ball result;
    arb_pow_ui(result.handle(), w.handle(), static_cast<ulong>(about.degree),
               is_exact(w) ? ARF_PREC_EXACT : ball::working_bits());
    return about.side < 0 ? -result : result;
}

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

// w at a distance from tau: of those on the side without roots, as at tau.
ball root_of(const ball& distance, const root_time& about) {
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

magnitude least_root(const magnitude& distance, int degree) {
    return magnitude::below(exact_root(distance.exact(), degree));
}

}  // namespace

root_rule::root_rule(const explicit_system& of, std::vector<root_time> times, long bits, long error_bits,
                     proof_route route)
    : form_(of), times_(std::move(times)), bits_(bits), error_bits_(error_bits), route_(std::move(route)) {}

// Exact, and not shorter than the distance; it is longer only if the time of the roots is not a dyadic number.
ball root_rule::entry_step::length_of_step() const {
    ball length;
    arb_abs(length.handle(), distance_.handle());
    return is_exact(length) ? length : upper_bound(length);
}

const root_rule::entry_step* root_rule::entry(const ball& time, const proved_step& step, int direction) {
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
    if (nearest == nullptr || step.length() * magnitude(steps_to_root) < least) {
        return nullptr;
    }
    const magnitude root = least_root(least, nearest->degree);
    if (!std::isnormal(as_double(root.exact()))) {
        return nullptr;  // w, of 30 bits, is not exact as a double
    }
    about_ = nearest;
    direction_ = about_->both ? direction : -1;
    begins_ = direction_ < 0 ? root.exact() : -root.exact();
    ends_ = ball(0);
    if (about_->both) {
        // Up to as far beyond tau, but not beyond the middle of the way to the next roots.
        magnitude beyond = root;
        if (!second.is_zero()) {
            const ball gap = second.exact() - upper_bound(constant_value<ball>::of(about_->time) - time) * direction;
            beyond = std::min(beyond, least_root(magnitude::below(gap).shifted(-1), about_->degree));
        }
        ends_ = direction_ < 0 ? -beyond.exact() : beyond.exact();
    }
    ball distance = constant_value<ball>::of(about_->time) - time;
    const slong bits = is_exact(distance) ? ARF_PREC_EXACT : ball::working_bits();
    arb_add(distance.handle(), distance.handle(), raised(begins_, *about_).handle(), bits);
    return step.reaches(distance) ? &entry_.emplace(step, std::move(distance)) : nullptr;
}

void root_rule::begin(state_set set, bool with_derivative) {
    const auto hull = set.hull();
    const explicit_system system = in_root(form_, *about_, number(rational(as_double(begins_))));
    begin_with(
        std::unique_ptr<proved_march>(new proved_march(system, std::move(set), hull, bits_, error_bits_, {}, route_)));
    leads_beyond_ = about_->both;
    if (with_derivative) {
        inner_->keep_derivative();
    }
}

void root_rule::begin_at_start(const explicit_system& system) {
    start_ = {system.point(), system.singular()->root, 1, false};
    about_ = &start_;
    direction_ = 1;
    ends_ = ball(0);
    leads_beyond_ = true;
    begin_with(std::make_unique<proved_march>(in_root_of_start(system), bits_, march_watch(), error_bits_, route_));
}

void root_rule::begin_with(std::unique_ptr<proved_march> inner) {
    slopes_.clear();
    for (const expression& each : form_.slopes) {
        slopes_.push_back(in_root(each, *about_));
    }
    inner_ = std::move(inner);
    prepared_ = nullptr;
    at_last_time_ = false;
    has_moved_ = false;
    entry_.reset();
}

bool root_rule::prepare() {
    prepared_ = at_last_time_ ? nullptr : inner_->prepare();
    return prepared_ != nullptr;
}

// w after the step, but not beyond tau if the roots are not real there.
ball root_rule::root_after_step() const {
    ball after = prepared_->length_of_step() * direction_;
    arb_add(after.handle(), after.handle(), inner_->reached().handle(), ARF_PREC_EXACT);
    return about_->both || arb_is_positive(after.handle()) != 0 ? after : ball(0);
}

void root_rule::step() {
    at_last_time_ = !about_->both && arb_is_zero(root_after_step().handle()) != 0;
    if (!at_last_time_) {
        has_moved_ = true;
        inner_->take(*prepared_, direction_);
    }
}

bool root_rule::leads_towards(int direction) const {
    const ball rest = (ends_ - inner_->reached()) * direction_;
    const bool is_beyond = leads_beyond_ && has_moved_ && arb_is_positive(rest.handle()) == 0;
    return at_last_time_ || (direction_ * about_->side == direction && !is_beyond);
}

ball root_rule::time() const {
    ball result = constant_value<ball>::of(about_->time);
    if (!at_last_time_) {
        arb_add(result.handle(), result.handle(), raised(inner_->reached(), *about_).handle(), ARF_PREC_EXACT);
    }
    return result;
}

// From the time reached to that of w.
ball root_rule::distance_of(const ball& w) const {
    ball result;
    const ball here = raised(inner_->reached(), *about_);
    arb_sub(result.handle(), raised(w, *about_).handle(), here.handle(), ARF_PREC_EXACT);
    return result;
}

ball root_rule::root_at(const ball& distance) const {
    ball away = raised(inner_->reached(), *about_);
    arb_add(away.handle(), away.handle(), distance.handle(),
            is_exact(distance) ? ARF_PREC_EXACT : ball::working_bits());
    return root_of(away, *about_);
}

ball root_rule::length_of_step() const {
    ball length = distance_of(root_after_step());
    arb_abs(length.handle(), length.handle());
    return length;
}

std::vector<ball> root_rule::values_in_root(const ball& w) const { return prepared_->values_at(w - inner_->reached()); }

std::vector<ball> root_rule::slopes_in_root(const ball& w, const std::vector<ball>& state) const {
    expression_values<ball> values(form_.leaves, w);
    for (const ball& each : state) {
        values.push_back(each);
    }
    std::vector<ball> result;
    for (const expression& each : slopes_) {
        result.push_back(values.of(each));
    }
    return result;
}

// Near tau a narrow ball of times is a wide one of w. There the values are also y(m) + y' (t - m), m the midpoint of the
// ball of times, or tau if that is beyond it.
std::vector<ball> root_rule::values_at(const ball& distance) const {
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

std::vector<ball> root_rule::slopes_at(const ball& distance) const {
    const ball w = root_at(distance);
    return slopes_in_root(w, values_in_root(w));
}

}  // namespace libration::ode
