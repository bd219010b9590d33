// A system as one of first order, in separate leaves: the form used for events, periodic orbits and condition numbers.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/polynomial_form.hpp"

namespace libration::ode {

/// The unknowns and their lower derivatives in order, each a leaf: y_k' = slopes[k] in leaves and the variable.
struct first_order_form {
    explicit first_order_form(const explicit_system& system);

    /// An expression in the unknowns of the system. Throws error for a derivative that is not part of the state.
    expression in_leaves(const expression& e) const;
    /// The derivative of an expression in leaves along the solution.
    expression slope_of(const expression& e) const;

    /// The system itself in leaves, without initial values: for expansions about points given with their states.
    explicit_system about_points(const number& point) const {
        return explicit_system::first_order(leaves, slopes, point);
    }

    /// All slopes at a state and a time.
    template <field R>
    std::vector<R> slopes_at(const std::vector<R>& state, const R& time) const {
        expression_values<R> values(leaves, time);
        for (const R& each : state) {
            values.push_back(each);
        }
        std::vector<R> result;
        for (const expression& each : slopes) {
            result.push_back(values.of(each));
        }
        return result;
    }

    std::vector<expression> leaves;
    /// The unknowns and derivatives that they represent.
    std::vector<expression> given;
    std::vector<expression> slopes;
    std::vector<std::string> names;
    std::vector<number> starts;

private:
    std::vector<unknown_function> unknowns_;
};

/// The system from which the polynomial form is derived to continue a solution: the system itself, or its first-order
/// form in leaves if its initial point is singular.
explicit_system beyond_start(const explicit_system& system);

}  // namespace libration::ode
