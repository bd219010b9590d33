// The further columns of a problem with events and piecewise right-hand sides.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// The names of the state, and behind them those of the expressions to show.
inline std::vector<std::string> names_with_shown(const hybrid_system& system) {
    auto names = names_of_state(system);
    for (const definition& each : system.shown()) {
        names.push_back(each.name);
    }
    return names;
}

/// Appends to a state on a branch, at a time, the values of the expressions to show; those that contain step functions as
/// of_steps(values, expression on the branch) gives them.
template <class R, class OfSteps>
void append_shown(std::vector<R>& state, const hybrid_system& system, const explicit_system& branch,
                  const step_values& steps, const R& time, const OfSteps& of_steps) {
    if (system.shown().empty()) {
        return;
    }
    const first_order_form form(branch);
    expression_values<R> values(form.leaves, time);
    for (const R& each : state) {
        values.push_back(each);
    }
    for (const definition& each : system.shown()) {
        const bool jumps = each.value.has_parameters();
        state.push_back(jumps ? of_steps(values, form.in_leaves(system.on_branch(each.value, steps)))
                              : values.of(form.in_leaves(each.value)));
    }
}

/// The same where no step function changes.
template <class R>
void append_shown(std::vector<R>& state, const hybrid_system& system, const explicit_system& branch,
                  const step_values& steps, const R& time) {
    append_shown(state, system, branch, steps, time,
                 [](expression_values<R>& values, const expression& on_branch) { return values.of(on_branch); });
}

/// Why an expression to show has no value at a state in which unknowns are exactly 0; std::nullopt if it may have one.
inline std::optional<std::string> reason_without_value(const definition& shown, const hybrid_system& system,
                                                       const explicit_system& branch, const step_values& steps,
                                                       const std::vector<ball>& state) {
    const first_order_form form(branch);
    const auto names = names_of_state(branch);
    std::string zeros;
    const auto at_zero = [&](const expression& leaf) -> std::optional<expression> {
        for (std::size_t k = 0; k < form.leaves.size(); ++k) {
            if (same_form(leaf, form.leaves[k]) && arb_is_zero(state[k].handle()) != 0) {
                zeros = " at " + names[k] + " = 0";
                return expression();
            }
        }
        return std::nullopt;
    };
    try {
        replaced(form.in_leaves(system.on_branch(shown.value, steps)), at_zero);
        return std::nullopt;
    } catch (const error& none) {
        return "has no value of " + shown.name + ", which " + none.reason() + zeros;
    }
}

}  // namespace libration::ode
