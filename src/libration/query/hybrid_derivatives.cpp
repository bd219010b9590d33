#include "libration/query/hybrid_derivatives.hpp"

#include <utility>

#include "../expansion/differentiated_numbers.hpp"
#include "../hybrid/saltation.hpp"
#include "libration/hybrid/initial_mode.hpp"
#include "libration/query/hybrid_trajectory.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// The sign of an expression in the leaves of the form at its initial point, by exact arithmetic.
int sign_at(const first_order_form& form, const number& point, const expression& e) {
    std::vector<expression> leaves = form.leaves;
    std::vector<expression> values(form.starts.begin(), form.starts.end());
    leaves.push_back(variable());
    values.emplace_back(point);
    return with_leaves(e, leaves, values).constant().sign();
}

// Whether the solutions for all nearby numbers are on the same side of a surface directly after the initial point.
bool is_same_side(const varied_system& of, const explicit_system& branch, std::size_t index, const expression& g) {
    const dependence_on_number& dependence = of.dependences[index];
    const first_order_form form(branch);
    const expression in_leaves = form.in_leaves(g);
    if (!dependence.has(g) || sign_at(form, branch.point(), in_leaves) != 0) {
        return true;
    }
    const expression at_start = with_leaves(g, of.leaves, dependence.starts);
    return partial(at_start, dependence.leaf).is(0) && sign_at(form, branch.point(), form.slope_of(in_leaves)) != 0;
}

// For a solution that remains on the surface g = 0.
void require_no_dependence(const varied_system& of, const std::vector<std::string>& numbers, const expression& g,
                           const std::string& text) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (of.dependences[i].has(g)) {
            refuse_derivative(numbers[i], "is not supported for a solution that remains on the surface of `" + text +
                                              "`, which nearby solutions may leave: choose another number or initial "
                                              "point");
        }
    }
}

void require_same_side(const varied_system& of, const std::vector<std::string>& numbers) {
    const step_values steps = values_at_start(of.system);
    const explicit_system branch = of.system.first_branch(steps);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (of.system.is_at_rest(i, steps)) {
            require_no_dependence(of, numbers, of.system.argument(i, steps), of.system.steps()[i].text);
        }
    }
    for (const surface& each : of.system.surfaces(steps)) {
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (!each.time && !is_same_side(of, branch, i, each.g)) {
                refuse_derivative(numbers[i], "is not supported for a solution that begins on the surface of `" +
                                                  each.text +
                                                  "`, which nearby solutions may cross: choose another number or "
                                                  "initial point");
            }
        }
    }
}

// The solution itself is defined where its equations are as written, which those of its derivatives are derived from.
void keep_reached(partial_trajectory& all, const hybrid_system& given, const std::vector<number>& times) {
    constexpr long few_digits = 2;
    const auto reached = proved_part_of_hybrid(given, times, few_digits);
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (reached.states[i].empty()) {
            all.states[i].clear();
            all.missing = reached.missing;
        }
    }
}

}  // namespace

partial_derivatives proved_derivatives_of_hybrid(const equation_system& given, const std::vector<number>& times,
                                                 const std::vector<std::string>& numbers, long digits,
                                                 const march_watch& watch, const proof_route& route) {
    const varied_system varied = system_with_variations(given, numbers);
    require_same_side(varied, numbers);
    auto all = proved_part_of_hybrid(varied.system, times, digits, watch, route);
    keep_reached(all, hybrid_system(given), times);
    const known_value zero{proved_decimal{"0", "0"}, ""};
    partial_derivatives result;
    result.by.resize(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto state = std::move(all.states[i]);
        all.states[i].clear();
        for (const std::size_t k : state.empty() ? std::vector<std::size_t>() : varied.own) {
            all.states[i].push_back(state[k]);
            auto& row = result.by[i].emplace_back();
            for (const state_variation& each : varied.system.variations()) {
                row.push_back(each[k] ? state[*each[k]] : zero);
            }
        }
    }
    result.trajectory = std::move(all);
    return result;
}

}  // namespace libration::ode
