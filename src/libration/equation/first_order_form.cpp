#include "libration/equation/first_order_form.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace libration::ode {

namespace {

using state_places = std::map<std::string, std::pair<std::size_t, int>>;

// For each unknown: its first leaf and its order.
state_places states_of(const std::vector<unknown_function>& unknowns) {
    state_places states;
    std::size_t first = 0;
    for (const unknown_function& each : unknowns) {
        states.emplace(each.name, std::pair(first, each.order));
        first += static_cast<std::size_t>(each.order);
    }
    return states;
}

expression in_states(const expression& e, const state_places& states, const std::vector<expression>& leaves) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        const auto found = leaf.kind() == node_kind::unknown ? states.find(leaf.name()) : states.end();
        if (found == states.end()) {
            return std::nullopt;
        }
        const auto& [first, order] = found->second;
        if (leaf.derivative() >= order) {
            refuse(primed(leaf.name(), leaf.derivative()), {},
                   "is not part of the state in a condition: replace it by its right-hand side");
        }
        return leaves[first + static_cast<std::size_t>(leaf.derivative())];
    });
}

}  // namespace

first_order_form::first_order_form(const explicit_system& system)
    : names(names_of_state(system)), unknowns_(system.unknowns()) {
    const state_places states = states_of(unknowns_);
    for (const unknown_function& each : system.unknowns()) {
        for (int j = 0; j < each.order; ++j) {
            leaves.push_back(unknown("y" + std::to_string(leaves.size())));
            given.push_back(unknown(each.name, j));
        }
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        for (int j = 1; j <= system.unknowns()[i].order; ++j, ++k) {
            slopes.push_back(j < system.unknowns()[i].order ? leaves[k + 1]
                                                            : in_states(system.right()[i], states, leaves));
        }
    }
    for (const auto& of_unknown : system.starts()) {
        starts.insert(starts.end(), of_unknown.begin(), of_unknown.end());
    }
}

expression first_order_form::in_leaves(const expression& e) const { return in_states(e, states_of(unknowns_), leaves); }

expression first_order_form::slope_of(const expression& e) const {
    std::set<std::string> occurring;
    each_leaf(e, [&](const expression& leaf) { occurring.insert(leaf.name()); });
    expression sum = partial(e, variable());
    for (std::size_t k = 0; k < leaves.size(); ++k) {
        const expression by = occurring.contains(leaves[k].name()) ? partial(e, leaves[k]) : expression();
        if (!by.is(0)) {
            sum = sum + by * slopes[k];
        }
    }
    return sum;
}

explicit_system beyond_start(const explicit_system& system) {
    return system.singular() ? first_order_form(system).about_points(system.point()) : system;
}

}  // namespace libration::ode
