#include "shorthand.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "libration/equation/text/parse.hpp"

namespace libration::ode {

namespace {

bool contains_one(const expression& e, const std::set<std::string>& names) {
    bool found = false;
    each_leaf(e, [&](const expression& leaf) {
        found = found || (leaf.kind() == node_kind::parameter && names.contains(leaf.name()));
    });
    return found;
}

}  // namespace

std::set<std::string> shorthands_of(const equation_system& system) {
    std::set<std::string> names;
    for (bool added = true; std::exchange(added, false);) {
        for (const definition& each : system.parameters) {
            if (!each.value.is_constant() || (!names.empty() && contains_one(each.value, names))) {
                added = names.insert(each.name).second || added;
            }
        }
    }
    return names;
}

void replace_shorthands(equation_system& in) {
    const std::set<std::string> names = shorthands_of(in);
    if (names.empty()) {
        return;
    }
    std::map<std::string, expression> kept;
    const auto keep = [&](const std::string& name) { kept.emplace(name, parameter(name)); };
    for (const definition& each : in.parameters) {
        if (!names.contains(each.name)) {
            keep(each.name);
        }
    }
    for (const number_set& each : in.sets) {
        keep(each.name);
    }
    for (const open_parameter& each : in.open) {
        keep(each.name);
    }
    kept.merge(kept_steps(in.steps));
    for (const delayed_value& each : in.delays) {
        keep(each.parameter);
    }
    const equation_system definitions = in;
    parameter_values values(definitions, std::move(kept));
    const auto replace = [&](expression& e) { e = values.in(e); };
    for (definition& each : in.parameters) {
        if (names.contains(each.name)) {
            replace(each.value);
        }
    }
    for (auto* const list : {&in.equations, &in.invariants}) {
        for (equation& each : *list) {
            replace(each.left);
            replace(each.right);
        }
    }
    for (step_function& each : in.steps) {
        replace(each.argument);
    }
    for (delayed_value& each : in.delays) {
        replace(each.delay);
    }
    for (history& each : in.histories) {
        replace(each.value);
    }
    for (state_event& each : in.events) {
        replace(each.condition);
        for (reset& after : each.resets) {
            replace(after.value);
        }
    }
}

namespace {

// Whether it depends on unknowns, the variable or a step function.
bool is_expression(const expression& e, const equation_system& in) {
    const auto steps = kept_steps(in.steps);
    bool found = !e.is_constant();
    each_leaf(e, [&](const expression& leaf) {
        found = found || (leaf.kind() == node_kind::parameter && steps.contains(leaf.name()));
    });
    return found;
}

}  // namespace

equation_system with_column(equation_system system, const std::string& name) {
    const std::string undashed = name.substr(0, name.find('\''));
    if (std::ranges::count(system.unknowns(), undashed) > 0) {
        const bool given = static_cast<int>(name.size() - undashed.size()) < system.order_of(undashed);
        refuse(name, {},
               given ? "already has a column, like every unknown and lower derivative"
                     : "is a derivative: name it in the problem, as v = " + name);
    }
    const auto found = std::ranges::find(system.parameters, name, &definition::name);
    if (found == system.parameters.end() || !is_expression(found->value, system)) {
        refuse(name, {},
               "is not a name for an expression in unknowns or time: define it in the problem, as " + name +
                   " = x^2 + y^2");
    }
    if (!system.is_smooth()) {
        system.shown.push_back(*found);
        return system;
    }
    const expression value = found->value;
    system.parameters.erase(found);
    return system.add(unknown(name), value);
}

}  // namespace libration::ode
