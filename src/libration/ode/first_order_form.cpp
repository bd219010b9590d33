#include "libration/ode/first_order_form.hpp"

#include <algorithm>
#include <optional>

namespace libration::ode {

first_order_form::first_order_form(const explicit_system& system) : unknowns_(system.unknowns()) {
    for (const unknown_function& each : system.unknowns()) {
        for (int j = 0; j < each.order; ++j) {
            leaves.push_back(unknown("y" + std::to_string(leaves.size())));
            names.push_back(primed(each.name, j));
            given.push_back(unknown(each.name, j));
        }
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        for (int j = 1; j <= system.unknowns()[i].order; ++j, ++k) {
            slopes.push_back(j < system.unknowns()[i].order ? leaves[k + 1] : in_leaves(system.right()[i]));
        }
    }
    for (const auto& of_unknown : system.starts()) {
        starts.insert(starts.end(), of_unknown.begin(), of_unknown.end());
    }
}

expression first_order_form::in_leaves(const expression& e) const {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        std::size_t first = 0;
        for (const unknown_function& each : unknowns_) {
            if (leaf.kind() == node_kind::unknown && leaf.name() == each.name) {
                if (leaf.derivative() >= each.order) {
                    refuse(primed(leaf.name(), leaf.derivative()), {},
                           "is no part of the state in a condition: write what the equation has for it");
                }
                return leaves[first + static_cast<std::size_t>(leaf.derivative())];
            }
            first += static_cast<std::size_t>(each.order);
        }
        return std::nullopt;
    });
}

expression first_order_form::slope_of(const expression& e) const {
    expression sum = partial(e, variable());
    for (std::size_t k = 0; k < leaves.size(); ++k) {
        const expression by = partial(e, leaves[k]);
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
