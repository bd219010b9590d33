#include "constant_unknowns.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "libration/equation/defined_zero.hpp"

namespace libration::ode {

namespace {

bool has_unknown(const expression& e, const std::set<std::string>& names) {
    bool found = false;
    each_leaf(e, [&](const expression& leaf) {
        found = found || (leaf.kind() == node_kind::unknown && names.contains(leaf.name()));
    });
    return found;
}

// Whether no part with a restricted domain, except constant ones, disappears from the right-hand sides.
bool keeps_domain(const explicit_system& of, const std::set<std::string>& constant) {
    const replacement by = at_starts(of, constant);
    std::vector<expression> kept;
    for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
        if (!constant.contains(of.unknowns()[i].name)) {
            kept.push_back(replaced(of.right()[i], by));
        }
    }
    return parts_lost(of.right(), by, kept).empty();
}

}  // namespace

std::set<std::string> constant_unknowns(const explicit_system& of, const std::vector<expression>& starts,
                                        const expression& used) {
    std::set<std::string> constant;
    auto start = starts.begin();
    for (const unknown_function& each : of.unknowns()) {
        const auto next = start + each.order;
        if (std::all_of(start, next, [](const expression& e) { return e.kind() == node_kind::constant; }) &&
            std::all_of(start + 1, next, [](const expression& e) { return e.is(0); }) &&
            !has_unknown(used, {each.name})) {
            constant.insert(each.name);
        }
        start = next;
    }
    constant = resting_unknowns(of, std::move(constant));
    return keeps_domain(of, constant) ? constant : std::set<std::string>();
}

explicit_system without(const explicit_system& of, const std::set<std::string>& constant) {
    const replacement by = at_starts(of, constant);
    equation_system others;
    others.variable = of.variable();
    for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
        const auto& [name, order] = of.unknowns()[i];
        if (constant.contains(name)) {
            continue;
        }
        others.add(unknown(name, order), replaced(of.right()[i], by));
        for (int j = 0; j < order; ++j) {
            others.begin(unknown(name, j), expression(of.starts()[i][static_cast<std::size_t>(j)]),
                         expression(of.point()));
        }
    }
    return explicit_system(others);
}

}  // namespace libration::ode
