#include "varied_form.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace libration::ode {

namespace {

// Not a name that can be typed.
expression derivative_leaf(const expression& leaf) { return unknown("the derivative of " + leaf.name()); }

const expression& leaf_of_added(const polynomial_form& of, const expression& definition) {
    const auto found =
        std::ranges::find_if(of.added, [&](const expression& each) { return same_form(each, definition); });
    if (found == of.added.end()) {
        throw std::logic_error("a polynomial form without the derivative of one of its functions");
    }
    return of.leaves[of.given + static_cast<std::size_t>(found - of.added.begin())];
}

const expression& argument_of(const expression& definition) {
    return definition.kind() == node_kind::quotient ? definition.right() : definition.left();
}

// dw/du of the function w of u.
expression slope_by_argument(const polynomial_form& of, const expression& definition, const expression& w) {
    const expression& u = argument_of(definition);
    if (definition.kind() == node_kind::quotient) {
        return -(w * w);
    }
    if (definition.kind() == node_kind::power) {
        const auto r = definition.right().fraction();
        return r && numerator(*r) == -1 ? definition.right() * pow(w, expression(1 + static_cast<int>(denominator(*r))))
                                        : definition.right() * w * leaf_of_added(of, expression(1) / u);
    }
    if (definition.function() == function_kind::exp) {
        return w;
    }
    if (definition.function() == function_kind::log) {
        return leaf_of_added(of, expression(1) / u);
    }
    return definition.function() == function_kind::sin ? leaf_of_added(of, cos(u)) : -leaf_of_added(of, sin(u));
}

}  // namespace

polynomial_form with_derivatives(const polynomial_form& of) {
    const auto given = static_cast<std::ptrdiff_t>(of.given);
    std::vector<expression> derivatives;
    std::transform(of.leaves.begin(), of.leaves.begin() + given, std::back_inserter(derivatives), derivative_leaf);
    std::vector<expression> leaves = of.leaves;
    leaves.insert(leaves.begin() + given, derivatives.begin(), derivatives.end());
    for (std::size_t k = 0; k < of.added.size(); ++k) {
        const expression slope = slope_by_argument(of, of.added[k], of.leaves[of.given + k]);
        derivatives.push_back(slope * derivative_along(argument_of(of.added[k]), of.leaves, derivatives));
    }
    std::vector<expression> right = of.system.right();
    for (std::size_t i = 0; i < of.given; ++i) {
        right.insert(right.begin() + given + static_cast<std::ptrdiff_t>(i),
                     derivative_along(of.system.right()[i], of.leaves, derivatives));
    }
    std::vector<gradient> gradients = of.gradients;
    for (gradient& each : gradients) {
        for (auto& [k, by] : each) {
            k += k >= of.given ? of.given : 0;
        }
    }
    return {explicit_system::first_order(leaves, std::move(right), of.system.point()), 2 * of.given, of.added,
            std::move(gradients), leaves};
}

}  // namespace libration::ode
