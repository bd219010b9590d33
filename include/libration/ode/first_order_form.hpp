// A system as one of first order, in leaves of its own: what events, periodic orbits and condition numbers are written
// in.
#pragma once

#include <string>
#include <vector>

#include "libration/ode/lifted_system.hpp"

namespace libration::ode {

/// The unknowns and their lower derivatives in order, each a leaf: y_k' = slopes[k] in leaves and the variable.
struct first_order_form {
    explicit first_order_form(const explicit_system& system);

    /// An expression in the unknowns of the system. Throws error for a derivative that is no part of the state.
    expression in_leaves(const expression& e) const;
    /// The derivative of an expression in leaves along the solution.
    expression slope_of(const expression& e) const;

    /// The system itself in leaves, without starts: for expansions about points that are given with their states.
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
    /// What they stand for.
    std::vector<expression> given;
    std::vector<expression> slopes;
    std::vector<std::string> names;
    std::vector<number> starts;

private:
    std::vector<unknown_function> unknowns_;
};

/// What the polynomial form of a system is made of, from which its solution goes on: the system itself, or that in
/// leaves where its start is singular.
explicit_system beyond_start(const explicit_system& system);

}  // namespace libration::ode
