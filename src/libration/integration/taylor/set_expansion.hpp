// The series of a set with the derivative of the flow, as theorem V needs them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "../../expansion/flow_variations.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/taylor/step_length.hpp"

namespace libration::ode {

/// From so many unknowns on, with their lower derivatives, V' = J V is expanded as a product of matrices (flow_variations),
/// if J has no more entries than the Jacobian matrix of the polynomial form. Otherwise, and for relative functions, the form
/// with the variations of all of its unknowns is expanded (with_variations).
inline constexpr std::size_t least_unknowns_of_jacobian = 6;

/// How the variations of a form are expanded; shared by all expansions.
class set_form {
public:
    explicit set_form(const polynomial_form& of);

    const polynomial_form& form() const { return *form_; }
    const jacobian_form* jacobian() const { return jacobian_.get(); }
    const tape& varied() const { return *varied_; }
    /// Where the tail has its entries.
    variation_places places() const { return {form_->given, jacobian_ ? form_->given : form_->leaves.size()}; }

private:
    const polynomial_form* form_;
    std::unique_ptr<const jacobian_form> jacobian_;
    std::unique_ptr<const tape> varied_;  // if there is no Jacobian matrix
};

class set_expansion {
public:
    /// The form must outlive it.
    set_expansion(const set_form& of, int order, const series::block_product<ball>* fast);

    /// False if an unknown of the polynomial form is not finite on the set.
    bool about(const ball& time, const std::vector<ball>& hull);
    int order() const { return jacobian_ ? jacobian_->order() : varied_->order(); }
    /// Coefficients 0 .. order of the derivative of unknown i by the initial value of unknown j.
    const ball* coefficients(std::size_t i, std::size_t j) const;
    double estimated_radius() const;
    /// Of theorem T, its entries at set_form::places.
    std::optional<tail_bound> tail(const ball& time, double log_of_radius) const;

private:
    const set_form* of_;
    std::optional<flow_variations> jacobian_;
    std::optional<taylor_expansion<ball>> varied_;
};

}  // namespace libration::ode
