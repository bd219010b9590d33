#include "polynomial_map.hpp"

#include "libration/equation/constant_value.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace libration::ode {

namespace {

std::vector<std::pair<std::size_t, std::size_t>> places_of_derivatives(const polynomial_form& of,
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

tape with_derivatives(const polynomial_form& of, std::vector<std::pair<std::size_t, std::size_t>>& places) {
    std::vector<expression> derivatives;
    places = places_of_derivatives(of, derivatives);
    return tape::about_points(of.system, derivatives);
}

}  // namespace

polynomial_map::polynomial_map(const polynomial_form& of)
    : count_(of.leaves.size()),
      given_(of.given),
      tape_(with_derivatives(of, places_)),
      of_slopes_(tape_.steps().size()) {
    for (const int step : tape_.outputs()) {
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

std::vector<ball> polynomial_map::enclosed_constants(long bits) const {
    const precision_scope scope(decimal_digits(bits));
    std::vector<ball> all;
    for (const number& each : constants()) {
        all.push_back(constant_value<ball>::of(each));
    }
    return all;
}

}  // namespace libration::ode
