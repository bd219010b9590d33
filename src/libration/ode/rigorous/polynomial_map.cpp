#include "polynomial_map.hpp"

#include <algorithm>
#include <stdexcept>

namespace libration::ode {

namespace {

std::vector<std::pair<std::size_t, std::size_t>> places_of_derivatives(const lifted_system& of,
                                                                       std::vector<expression>& derivatives) {
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (std::size_t i = 0; i < of.leaves.size(); ++i) {
        for (std::size_t j = 0; j < of.leaves.size(); ++j) {
            expression by = partial(of.system.right()[i], of.leaves[j]);
            if (!by.is(0)) {
                places.emplace_back(i, j);
                derivatives.push_back(std::move(by));
            }
        }
    }
    return places;
}

tape with_derivatives(const lifted_system& of, std::vector<std::pair<std::size_t, std::size_t>>& places) {
    std::vector<expression> derivatives;
    places = places_of_derivatives(of, derivatives);
    return tape::about_points(of.system, derivatives);
}

int degree_of(const tape_step& step, const std::vector<int>& degrees) {
    const auto left = [&] { return degrees[static_cast<std::size_t>(step.left)]; };
    const auto right = [&] { return degrees[static_cast<std::size_t>(step.right)]; };
    switch (step.kind) {
        case operation::constant: return 0;
        case operation::variable:
        case operation::state: return 1;
        case operation::sum:
        case operation::difference: return std::max(left(), right());
        case operation::scaled:
        case operation::raised: return left();
        case operation::by_variable: return left() + 1;
        case operation::product: return left() + right();
        case operation::square: return 2 * left();
        case operation::delayed:
        case operation::quotient:
        case operation::slope:
        case operation::square_root:
        case operation::power:
        case operation::function:
        case operation::primitive:
        case operation::companion: break;
    }
    throw std::logic_error("a polynomial form has an operation that is neither a product nor linear");
}

}  // namespace

polynomial_map::polynomial_map(const lifted_system& of)
    : count_(of.leaves.size()), tape_(with_derivatives(of, places_)), of_slopes_(tape_.steps().size()) {
    std::vector<int> degrees;
    for (const tape_step& each : tape_.steps()) {
        degrees.push_back(degree_of(each, degrees));
    }
    for (const int step : tape_.outputs()) {
        degree_ = std::max(degree_, degrees[static_cast<std::size_t>(step)]);
        of_slopes_[static_cast<std::size_t>(step)] = true;
    }
    for (std::size_t k = of_slopes_.size(); k-- > 0;) {
        const tape_step& step = tape_.steps()[k];
        for (const int operand : {step.left, step.right}) {
            if (of_slopes_[k] && operand >= 0) {
                of_slopes_[static_cast<std::size_t>(operand)] = true;
            }
        }
    }
}

}  // namespace libration::ode
