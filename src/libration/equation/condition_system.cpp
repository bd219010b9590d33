#include "condition_system.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

namespace {

constexpr const char* name_of_condition = "the condition";  // not a name that can be typed

// The expression with the leaves replaced by `values`, and the variable by `time`.
expression with_leaves(const expression& e, const first_order_form& form, const std::vector<expression>& values,
                       const expression& time) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() == node_kind::variable) {
            return time;
        }
        const auto found = std::ranges::find_if(form.leaves, [&](const expression& l) { return same_form(l, leaf); });
        return found == form.leaves.end()
                   ? std::nullopt
                   : std::optional(values[static_cast<std::size_t>(found - form.leaves.begin())]);
    });
}

std::vector<std::size_t> places_in(const explicit_system& whole, const explicit_system& part) {
    const auto all = names_of_state(whole);
    std::vector<std::size_t> places;
    for (const std::string& each : names_of_state(part)) {
        places.push_back(static_cast<std::size_t>(std::ranges::find(all, each) - all.begin()));
    }
    return places;
}

}  // namespace

condition_system with_condition(const explicit_system& system, const expression& g) {
    if (system.singular()) {
        throw std::logic_error("a condition as an unknown needs a nonsingular initial point");
    }
    const first_order_form form(system);
    const expression value = form.in_leaves(g);
    const expression slope = form.slope_of(value);
    const expression curvature = form.slope_of(slope);
    equation_system given;
    given.variable = system.variable();
    const expression at(system.point());
    std::vector<expression> starts;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        const expression of = unknown(system.unknowns()[i].name);
        given.add(derivative(of, system.unknowns()[i].order), system.right()[i]);
        for (std::size_t j = 0; j < system.starts()[i].size(); ++j) {
            starts.emplace_back(system.starts()[i][j]);
            given.begin(derivative(of, static_cast<int>(j)), starts.back(), at);
        }
    }
    const expression condition = unknown(name_of_condition);
    given.add(derivative(condition, 2), with_leaves(curvature, form, form.given, variable()));
    given.begin(condition, with_leaves(value, form, starts, at), at);
    given.begin(derivative(condition), with_leaves(slope, form, starts, at), at);
    condition_system made{explicit_system(given), condition, {}};
    made.places = places_in(made.system, system);
    return made;
}

std::vector<std::optional<number>> given_values(const explicit_system& system, const expression& g) {
    std::vector<std::optional<number>> values;
    for (const unknown_function& each : system.unknowns()) {
        for (int j = 0; j < each.order; ++j) {
            const expression leaf = unknown(each.name, j);
            const expression factor = partial(g, leaf);
            values.emplace_back();
            if (factor.kind() != node_kind::constant || factor.is(0)) {
                continue;  // g is not linear in it, and may have no value where the leaf is 0
            }
            const expression rest = replaced(g, [&](const expression& other) -> std::optional<expression> {
                return same_form(other, leaf) ? std::optional(expression()) : std::nullopt;
            });
            if (rest.kind() == node_kind::constant) {
                values.back() = -(rest.constant() / factor.constant());
            }
        }
    }
    return values;
}

}  // namespace libration::ode
