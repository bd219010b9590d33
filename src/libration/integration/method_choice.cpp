#include "method_choice.hpp"

#include <utility>

#include "libration/scalar/error.hpp"

namespace libration::ode {

method_choice::method_choice(const polynomial_form& of, const run_bits& bits, const proof_route& route,
                             error_weights weights, step_before other)
    : integrator_(route.integrator),
      other_(std::move(other)),
      taylor_(of, bits, route, weights),
      collocation_(of, bits.bits, route) {}

void method_choice::require_integrator(bool with_derivative) const {
    if (integrator_ != integrator_choice::collocation) {
        return;
    }
    if (const std::string reason = collocation_.obstacle(with_derivative); !reason.empty()) {
        throw error(error_kind::argument, error_subject::integrator, "collocation",
                    reason + ": use automatic or taylor");
    }
}

void method_choice::begin(const flow_state& start) {
    require_integrator(start.derivative.has_value());
    collocation_.begin();
    series_begun_ = false;
    cost_ = 0;
}

next_step method_choice::next(const flow_state& from, const ball& rest) {
    next_step result = collocation_.made(from) ? next_after_collocation(from, rest) : next_by_series(from, rest);
    count(result.made ? result.made->cost() : 0);
    return result;
}

next_step method_choice::next_after_collocation(const flow_state& from, const ball& rest) {
    const bool continues = collocation_.continues(cost_) && !taylor_.loses_an_unknown(collocation_.hull());
    if (continues && !contains_zero(rest)) {
        if (auto made = collocation_.next(from)) {
            return {std::move(made), stop::none};
        }
    }
    return next_by_series(collocation_.end_of(from), rest);
}

next_step method_choice::next_by_series(const flow_state& from, const ball& rest) {
    if (!std::exchange(series_begun_, true)) {
        taylor_.begin(from);
    }
    next_step by_series = taylor_.next(from, rest);
    if (!by_series.made || by_series.made->reaches(rest)) {
        return by_series;
    }
    const auto& made = dynamic_cast<const series_step&>(*by_series.made);
    if (auto part = other_ ? other_(made, arb_is_negative(rest.handle()) != 0 ? -1 : 1) : nullptr) {
        return {std::move(part), stop::none};
    }
    if (auto first = collocation_.first(cost_, made.from(), magnitude(made.length()), rest)) {
        return {std::move(first), stop::none};
    }
    return by_series;
}

}  // namespace libration::ode
