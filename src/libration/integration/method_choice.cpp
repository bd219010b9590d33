#include "method_choice.hpp"

#include <stdexcept>
#include <utility>

#include "../expansion/set_values.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/scalar/error.hpp"
#include "singular/first_step.hpp"

namespace libration::ode {

namespace {

// Then the first steps are those of a root_rule.
bool begins_at_root(const explicit_system& system) { return system.singular() && system.singular()->root > 1; }

}  // namespace

method_choice::method_choice(const explicit_system& of, const run_bits& bits, const proof_route& route,
                             error_weights weights)
    : of_(of), bits_(bits), route_(route) {
    if (of.singular() && !begins_at_root(of)) {
        singular_ = proved_singular_step(of, bits.bits, route);
    }
    const explicit_system regular = begins_at_root(of) ? first_order_form(of).about_points(of.point())
                                    : singular_        ? singular_->beyond
                                                       : of;
    const polynomial_form form = lifted(regular);
    taylor_ = std::make_unique<taylor_rule>(form, bits, route, weights);
    collocation_ = std::make_unique<collocation_rule>(form, bits.bits, route);
    if (auto times = root_times(regular); !times.empty() || begins_at_root(of)) {
        roots_ = std::make_unique<root_rule>(begins_at_root(of) ? of : regular, std::move(times), bits, route, weights);
    }
    first_passage_ = begins_at_root(of) ? roots_->passage_from_start(of) : nullptr;
    require_integrator(false);
}

void method_choice::require_integrator(bool with_derivative) const {
    if (route_.integrator != integrator_choice::collocation) {
        return;
    }
    if (const std::string reason = collocation_->obstacle(with_derivative); !reason.empty()) {
        throw error(error_kind::argument, error_subject::integrator, "collocation",
                    reason + ": use automatic or taylor");
    }
}

// Theorem S begins from the initial values of the system alone. lifted() throws the error of a singular point.
void method_choice::require_given_start(const flow_state& start) const {
    const auto given = start_of(of_, bits_.bits).set.hull();
    const auto found = start.set.hull();
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (arb_equal(given[i].handle(), found[i].handle()) == 0) {
            lifted(of_);
            throw std::logic_error("a set about a singular initial point");
        }
    }
}

void method_choice::begin(const flow_state& start) {
    if (of_.singular()) {
        require_given_start(start);
    }
    require_integrator(start.derivative.has_value());
    collocation_->begin();
    at_start_ = of_.singular().has_value();
    series_begun_ = false;
    cost_ = 0;
}

next_step method_choice::next(const flow_state& from, const ball& rest) {
    next_step result = next_method(from, rest);
    cost_ += result.made ? result.made->cost() : 0;
    return result;
}

next_step method_choice::next_method(const flow_state& from, const ball& rest) {
    const int direction = arb_is_negative(rest.handle()) != 0 ? -1 : 1;
    if (std::exchange(at_start_, false)) {
        return next_at_start(from, direction);
    }
    if (dynamic_cast<const root_state*>(from.more.get()) != nullptr) {
        return root_rule::leads_towards(from, direction) ? root_rule::next(from)
                                                         : next_by_series(root_rule::end_of(from), rest);
    }
    return collocation_->made(from) ? next_after_collocation(from, rest) : next_by_series(from, rest);
}

next_step method_choice::next_at_start(const flow_state& from, int direction) {
    if (direction < 0) {
        return {{}, stop::step_too_small};
    }
    if (first_passage_) {
        return root_rule::next(root_rule::begin_at_start(first_passage_, from));
    }
    return {std::make_shared<singular_first_step>(from, of_, *singular_, bits_.bits, bits_.error_bits, route_),
            stop::none};
}

next_step method_choice::next_after_collocation(const flow_state& from, const ball& rest) {
    const bool continues = collocation_->continues(cost_) && !taylor_->loses_an_unknown(collocation_->hull());
    if (continues && !contains_zero(rest)) {
        if (auto made = collocation_->next(from)) {
            return {std::move(made), stop::none};
        }
    }
    return next_by_series(collocation_->end_of(from), rest);
}

next_step method_choice::next_by_series(const flow_state& from, const ball& rest) {
    if (!std::exchange(series_begun_, true)) {
        taylor_->begin(from);
    }
    next_step by_series = taylor_->next(from, rest);
    if (!by_series.made || by_series.made->reaches(rest)) {
        return by_series;
    }
    const auto& made = dynamic_cast<const series_step&>(*by_series.made);
    if (auto entry = roots_ ? roots_->entry(made, arb_is_negative(rest.handle()) != 0 ? -1 : 1) : nullptr) {
        return {std::move(entry), stop::none};
    }
    if (auto first = collocation_->first(cost_, made.from(), magnitude(made.length()), rest)) {
        return {std::move(first), stop::none};
    }
    return by_series;
}

std::unique_ptr<step_rule> rule_for(const explicit_system& system, const run_bits& bits, const proof_route& route,
                                    error_weights weights) {
    return std::make_unique<method_choice>(system, bits, route, weights);
}

flow_state start_of(const explicit_system& system, long bits) {
    const precision_scope scope(decimal_digits(bits));
    return {constant_value<ball>::of(system.point()), box_around(enclosed_start(system, bits), bits), {}, {}};
}

}  // namespace libration::ode
