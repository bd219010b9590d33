#include "lifted_functions.hpp"

#include <string>
#include <utility>

namespace libration::ode {

namespace {

// Not a name that can be typed.
std::string name_of_integral(std::size_t k) { return "the integral " + std::to_string(k); }

// The system with the integrals of the functions as further unknowns, the last ones.
explicit_system with_integrals(const explicit_system& of, const std::vector<expression>& functions) {
    equation_system given;
    given.variable = of.variable();
    const expression at(of.point());
    for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
        const expression each = unknown(of.unknowns()[i].name);
        given.add(derivative(each, of.unknowns()[i].order), of.right()[i]);
        for (std::size_t j = 0; j < of.starts()[i].size(); ++j) {
            given.begin(derivative(each, static_cast<int>(j)), expression(of.starts()[i][j]), at);
        }
    }
    for (std::size_t k = 0; k < functions.size(); ++k) {
        const expression integral = unknown(name_of_integral(k));
        given.add(derivative(integral), functions[k]);
        given.begin(integral, expression(0), at);
    }
    return explicit_system(given);
}

// The form without unknowns first .. first + count - 1, on which no other depends.
polynomial_form without(const polynomial_form& all, std::size_t first, std::size_t count) {
    std::vector<expression> leaves = all.leaves;
    std::vector<expression> right = all.system.right();
    const auto erase = [&](std::vector<expression>& from) {
        const auto at = from.begin() + static_cast<std::ptrdiff_t>(first);
        from.erase(at, at + static_cast<std::ptrdiff_t>(count));
    };
    erase(leaves);
    erase(right);
    std::vector<gradient> gradients = all.gradients;
    for (gradient& each : gradients) {
        for (auto& [k, by] : each) {
            k -= k >= first ? count : 0;
        }
    }
    return {explicit_system::first_order(leaves, std::move(right), all.system.point()), all.given - count, all.added,
            std::move(gradients), leaves};
}

expression slope_of(const expression& of, const polynomial_form& form) {
    expression sum = partial(of, variable());
    for (std::size_t k = 0; k < form.leaves.size(); ++k) {
        sum = sum + partial(of, form.leaves[k]) * form.system.right()[k];
    }
    return sum;
}

}  // namespace

lifted_functions lifted_with(const explicit_system& of, const std::vector<expression>& functions) {
    if (functions.empty()) {
        return {lifted(of), {}, {}};
    }
    const polynomial_form all = lifted(with_integrals(of, functions));
    const std::size_t first = all.given - functions.size();
    const auto& right = all.system.right();
    lifted_functions made{without(all, first, functions.size()), {}, {}};
    for (std::size_t k = 0; k < functions.size(); ++k) {
        made.functions.push_back(right[first + k]);
        made.slopes.push_back(slope_of(made.functions.back(), made.form));
    }
    return made;
}

}  // namespace libration::ode
