// Directions in which the derivative of the flow over one period of an orbit is known exactly.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "../../equation/first_integrals.hpp"
#include "libration/algebra/ball_matrix.hpp"

namespace libration::ode {

/// What of the derivative M of the flow over one period is known exactly at a point x of the orbit.
///
/// L M = L for the gradients of integrals, the rows of L, and M X(x) = X(x) for f and for fields whose flow maps solutions
/// to solutions. With L X = 0 the spaces span X, ker L, R^n are invariant, M is the identity on the first and on the
/// quotient R^n/ker L, and the multipliers are 1, as often as X and L have columns and rows, and the eigenvalues of M on ker L/span X.
///
/// L X = 0 is decided exactly: it is an expression that is 0 identically, or after the linear integrals are set to 0
/// that are derivatives of linear functions along the solutions: over one period such a function changes by T times the
/// integral.
class known_directions {
public:
    known_directions(const first_order_form& form, const std::vector<first_integral>& integrals);

    /// Of those that are independent at the middle of a state.
    struct at_state {
        ball_matrix gradients, fields;
        std::vector<std::string> names;  ///< of the multipliers that are 1
    };
    at_state at(const std::vector<ball>& state) const;

private:
    struct field {
        std::vector<expression> components;
        std::vector<std::size_t> conflicts;  ///< the integrals whose gradient is not orthogonal to it
    };
    const first_order_form& form_;
    std::vector<first_integral> integrals_;
    std::vector<field> fields_;
};

}  // namespace libration::ode
