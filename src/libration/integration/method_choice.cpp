#include "method_choice.hpp"

#include <algorithm>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "libration/expansion/tape.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// Products of series on the tape of a form, by the operations of its right-hand sides.
std::size_t products_of(const polynomial_form& of) {
    std::size_t count = 1;
    const tape all = tape::about_points(of.system);
    for (const tape_step& each : all.steps()) {
        count += is_linear(each.kind) ? 0 : 1;
    }
    return count;
}

// The state with a set of as many columns as unknowns.
flow_state in_columns(const flow_state& box) {
    return {box.time, {box.set.centre, lohner_set(box.set.errors.added())}, box.derivative, box.more};
}

}  // namespace

method_choice::method_choice(const polynomial_form& of, const run_bits& bits, const proof_route& route,
                             error_weights weights, step_before other)
    : form_(of),
      bits_(bits),
      route_(route),
      weights_(weights),
      other_(std::move(other)),
      costs_(of.given, 1),
      collocation_(of, bits.bits, route) {}

void method_choice::allow_boxes(const explicit_system& system) {
    if (route_.integrator == integrator_choice::comparison ||
        (route_.integrator == integrator_choice::automatic && route_.comparison &&
         form_.given >= least_unknowns_of_box)) {
        of_box_ = system;
        costs_ = box_choice(form_.given, products_of(form_));
    }
}

void method_choice::require_integrator(bool with_derivative) const {
    if (route_.integrator == integrator_choice::comparison && with_derivative) {
        throw error(error_kind::argument, error_subject::integrator, "comparison",
                    "carries no derivative of the flow, which is needed here: use automatic or taylor");
    }
    if (route_.integrator != integrator_choice::collocation) {
        return;
    }
    if (const std::string reason = collocation_.obstacle(with_derivative); !reason.empty()) {
        throw error(error_kind::argument, error_subject::integrator, "collocation",
                    reason + ": use automatic or taylor");
    }
}

bool method_choice::begins_by_box(const flow_state& start) const {
    return of_box_ && !start.derivative && weights_ == error_weights::relative;
}

void method_choice::begin(const flow_state& start) {
    require_integrator(start.derivative.has_value());
    collocation_.begin();
    costs_.begin();
    by_box_ = begins_by_box(start);
    series_begun_ = false;
    cost_ = 0;
}

next_step method_choice::next(const flow_state& from, const ball& rest) {
    next_step result = collocation_.made(from) ? next_after_collocation(from, rest) : next_by_series(from, rest);
    count(result.made ? result.made->cost() : 0);
    return result;
}

bool method_choice::loses_an_unknown(const std::vector<ball>& hull) const {
    return by_box_ ? box_->loses_an_unknown(hull) : taylor_->loses_an_unknown(hull);
}

next_step method_choice::next_after_collocation(const flow_state& from, const ball& rest) {
    const bool continues = collocation_.continues(cost_) && !loses_an_unknown(collocation_.hull());
    if (continues && !contains_zero(rest)) {
        if (auto made = collocation_.next(from)) {
            return {std::move(made), stop::none};
        }
    }
    return next_by_series(collocation_.end_of(from), rest);
}

next_step method_choice::next_by_series(const flow_state& from, const ball& rest) {
    if (by_box_) {
        if (next_step made = next_by_box(from, rest); by_box_) {
            return made;
        }
    }
    return of_box_ && from.set.errors.columns().empty() ? next_with_columns(in_columns(from), rest)
                                                        : next_with_columns(from, rest);
}

// Instead of it nothing, and by_box_ is false, if theorem V is to continue.
next_step method_choice::next_by_box(const flow_state& from, const ball& rest) {
    if (!box_) {
        box_ = std::make_unique<box_rule>(form_, *of_box_, bits_, route_);
    }
    if (!std::exchange(series_begun_, true)) {
        box_->begin(from);
    }
    const bool may_change = route_.integrator == integrator_choice::automatic;
    next_step made = may_change && costs_.prefers_columns(as_double(rest)) ? next_step{} : box_->next(from, rest);
    const bool fails = !made.made && made.why != stop::precision && form_.given <= most_unknowns_with_columns;
    if (may_change && fails) {
        by_box_ = series_begun_ = false;
        return {};
    }
    if (made.made) {
        costs_.add(box_->growth(), as_double(made.made->length()), static_cast<double>(box_->accuracy()));
    }
    return or_collocation(std::move(made), rest);
}

next_step method_choice::next_with_columns(const flow_state& from, const ball& rest) {
    if (!taylor_) {
        taylor_ = std::make_unique<taylor_rule>(form_, bits_, route_, weights_);
    }
    if (!std::exchange(series_begun_, true)) {
        taylor_->begin(from);
    }
    return or_collocation(taylor_->next(from, rest), rest);
}

// A step by series, or instead of it one of another rule or of collocation.
next_step method_choice::or_collocation(next_step by_series, const ball& rest) {
    if (!by_series.made || by_series.made->reaches(rest)) {
        return by_series;
    }
    const step& made = *by_series.made;
    if (const auto* const whole = dynamic_cast<const series_step*>(&made); whole != nullptr && other_) {
        if (auto part = other_(*whole, arb_is_negative(rest.handle()) != 0 ? -1 : 1)) {
            return {std::move(part), stop::none};
        }
    }
    const flow_state& from = made.from();
    const magnitude length(made.length());
    if (auto first = of_box_ && from.set.errors.columns().empty()
                         ? collocation_.first(cost_, in_columns(from), length, rest)
                         : collocation_.first(cost_, from, length, rest)) {
        return {std::move(first), stop::none};
    }
    return by_series;
}

}  // namespace libration::ode
