#include "libration/ode/equation_system.hpp"

#include <algorithm>
#include <unordered_set>

#include "libration/ode/dependency.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// Parameters replaced from the outermost inwards; `open` are those being replaced.
expression value_of(const expression& e, const equation_system& system, std::vector<std::string>& open) {
    if (!e.has_parameters()) {
        return e;
    }
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() != node_kind::parameter) {
            return std::nullopt;
        }
        const definition* const found = system.parameter_of(leaf.name());
        if (found == nullptr) {
            refuse(leaf.name(), {}, "has no value: write " + leaf.name() + " = number");
        }
        if (std::ranges::find(open, leaf.name()) != open.end()) {
            std::string circle;
            for (const std::string& name : open) {
                circle += name + " -> ";
            }
            refuse(leaf.name(), found->at, "needs itself: " + circle + leaf.name() + ": give one of them a number");
        }
        open.push_back(leaf.name());
        expression value = value_of(found->value, system, open);
        open.pop_back();
        return value;
    });
}

}  // namespace

void refuse(const std::string& what, const place& at, const std::string& reason) {
    const std::string where =
        at.line == 0 ? "" : "at line " + std::to_string(at.line) + ", column " + std::to_string(at.column) + " ";
    throw error(error_kind::argument, "problem", what, where + reason);
}

equation_system& equation_system::add(const expression& left, const expression& right) {
    equations.push_back({left, right, {}});
    return *this;
}

equation_system& equation_system::begin(const expression& of, const expression& value, const expression& point) {
    starts.push_back({of, point, value, {}});
    return *this;
}

equation_system& equation_system::set(const std::string& name, const expression& value) {
    const auto found = std::ranges::find(parameters, name, &definition::name);
    if (found != parameters.end()) {
        found->value = value;
    } else {
        parameters.push_back({name, value, {}});
    }
    return *this;
}

std::vector<std::string> equation_system::unknowns() const {
    std::vector<std::string> names;
    std::unordered_set<const void*> done;
    for (const equation& each : equations) {
        for (const expression* side : {&each.left, &each.right}) {
            each_leaf(*side, done, [&](const expression& leaf) {
                if (leaf.kind() == node_kind::unknown && std::ranges::find(names, leaf.name()) == names.end()) {
                    names.push_back(leaf.name());
                }
            });
        }
    }
    return names;
}

const definition* equation_system::parameter_of(const std::string& name) const {
    const auto found = std::ranges::find(parameters, name, &definition::name);
    return found == parameters.end() ? nullptr : &*found;
}

expression with_values(const expression& e, const equation_system& system) {
    std::vector<std::string> open;
    return value_of(e, system, open);
}

}  // namespace libration::ode
