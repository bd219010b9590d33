// A well with conditions at its ends: how many eigenvalues are below E, and on which side of the one of an index E is.
#pragma once

#include <cmath>
#include <optional>

#include "well_side.hpp"

namespace libration::ode {

/// psi'' = (V - c E) psi between two ends.
class well_problem {
public:
    /// m is between the ends.
    well_problem(const well_equation& of, const well_end& left, const well_end& right, const rational& m);

    /// The number of eigenvalues below an exact E; std::nullopt if the precision is too low, or E an eigenvalue.
    std::optional<long> eigenvalues_below(const ball& e) const;
    /// w = psi_left' psi_right - psi_left psi_right' at m for solutions of length 1 there that are positive near their
    /// ends: its sign is that of (-1)^n, n the number of eigenvalues below E.
    std::optional<ball> wronskian(const ball& e) const;
    std::optional<rational> continuum() const;
    /// The least of some values of V between the ends, and the least power of 2, s, such that V rises by at most s within 1/sqrt(s) of that
    /// place, about the distance of eigenvalues; 1 where V is a function of exp(r x).
    struct bottom_of_well {
        double least = INFINITY, size = 1;
    };
    bottom_of_well bottom() const;

private:
    struct both_states {
        end_state left, right;
    };
    std::optional<both_states> states(const ball& e, bool counts_zeros) const;

    double first_ = -INFINITY, last_ = INFINITY;  // the ends, as s
    well_side left_, right_;
};

}  // namespace libration::ode
