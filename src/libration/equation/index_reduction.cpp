#include "index_reduction.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace libration::ode {

namespace {

// d/dt along a solution.
expression total_derivative(const expression& of) {
    std::map<std::string, expression> unknowns;
    each_leaf(of, [&](const expression& leaf) {
        if (leaf.kind() == node_kind::unknown) {
            unknowns.emplace(primed(leaf.name(), leaf.derivative()), leaf);
        }
    });
    std::vector<expression> leaves;
    std::vector<expression> derivatives;
    for (const auto& [name, leaf] : unknowns) {
        leaves.push_back(leaf);
        derivatives.push_back(derivative(leaf));
    }
    return partial(of, variable()) + derivative_along(of, leaves, derivatives);
}

std::size_t size_of_state(const std::vector<expression>& highest) {
    std::size_t size = 0;
    for (const expression& each : highest) {
        size += static_cast<std::size_t>(each.derivative());
    }
    return size;
}

}  // namespace

reduced_system reduced(std::vector<equation> equations, const std::vector<expression>& highest,
                       const nonzero_test& may_divide) {
    reduced_system result;
    const std::size_t most = size_of_state(highest);
    while (true) {
        linear_result found = linear_solution(equations, highest, may_divide);
        std::ranges::move(found.divisors, std::back_inserter(result.divisors));
        std::ranges::move(found.doubtful, std::back_inserter(result.doubtful));
        if (found.constraints.empty()) {
            result.right = std::move(found.values);
            return result;
        }
        for (const constraint& each : found.constraints) {
            equation& of = equations[each.equation];
            const std::string name = "equation " + std::to_string(each.equation + 1);
            if (!each.remainder.has_unknowns()) {
                refuse(name, of.at,
                       "depends on the others or contradicts them: give as many independent equations as unknowns");
            }
            if (result.algebraic.size() == most) {
                refuse(name, of.at,
                       "and its derivatives, with the other equations, do not determine the highest derivatives: give "
                       "an equation that does");
            }
            result.algebraic.push_back({each.remainder, of.at});
            of = {total_derivative(each.remainder), 0, of.at};
        }
    }
}

}  // namespace libration::ode
