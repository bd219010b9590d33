#include "set_expansion.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "../../expansion/set_values.hpp"

namespace libration::ode {

namespace {

// Of the Jacobian matrix of all right-hand sides of a form.
std::size_t dependences_of(const polynomial_form& of) {
    std::size_t count = 0;
    for (const expression& each : of.system.right()) {
        std::set<std::string> names;
        each_leaf(each, [&](const expression& leaf) { names.insert(leaf.name()); });
        count += names.size();
    }
    return count;
}

}  // namespace

set_form::set_form(const polynomial_form& of) : form_(&of) {
    if (of.given >= least_unknowns_of_jacobian && !of.has_functions) {
        auto jacobian = std::make_unique<const jacobian_form>(of);
        if (jacobian->entries().size() <= dependences_of(of)) {
            jacobian_ = std::move(jacobian);
        }
    }
    if (!jacobian_) {
        varied_ = std::make_unique<const tape>(tape::about_points(with_variations(of)));
    }
}

set_expansion::set_expansion(const set_form& of, int order, const series::block_product<ball>* fast) : of_(&of) {
    if (of.jacobian() != nullptr) {
        jacobian_.emplace(*of.jacobian(), order, fast);
    } else {
        varied_.emplace(of.varied(), order, fast);
    }
}

bool set_expansion::about(const ball& time, const std::vector<ball>& hull) {
    const auto values = jacobian_ ? lifted_values(of_->form(), time, hull) : varied_values(of_->form(), time, hull);
    if (!all_finite(values)) {
        return false;
    }
    if (jacobian_) {
        jacobian_->about(time, values);
    } else {
        varied_->about(time, as_state(values));
    }
    return true;
}

const ball* set_expansion::coefficients(std::size_t i, std::size_t j) const {
    return jacobian_ ? jacobian_->coefficients(i, j) : varied_->coefficients(static_cast<int>(of_->places().of(i, j)));
}

double set_expansion::estimated_radius() const {
    return jacobian_ ? jacobian_->estimated_radius() : ode::estimated_radius(*varied_, of_->varied().orders().size());
}

std::optional<tail_bound> set_expansion::tail(const ball& time, double log_of_radius) const {
    return jacobian_ ? jacobian_->tail(time, log_of_radius) : tail_near(of_->varied(), *varied_, time, log_of_radius);
}

}  // namespace libration::ode
