// Theorem K for one step.
#pragma once

#include <optional>

#include "libration/integration/collocation/tube.hpp"
#include "step_suprema.hpp"

namespace libration::ode {

/// By which suprema over a step are bounded: values at nodes cost less from some number of unknowns on, coefficients can
/// be checked in integers.
enum class supremum_rule { coefficients, nodes };

class tube_proof {
public:
    /// Defects in `bits`, coefficients of frames in `frame_bits`, their values at nodes in `node_bits`.
    tube_proof(const polynomial_map& map, long bits, long frame_bits, long node_bits);

    long bits() const { return bits_; }
    /// Chebyshev coefficients of a polynomial, in `bits`.
    std::vector<ball> chebyshev(const ball_polynomial& of);
    /// A tube that contains every solution beginning in the set; std::nullopt if the inequalities are not proved.
    std::optional<solution_tube> tube(const tube_candidate& of, const tube_set& start, supremum_rule by);
    /// Bounds of |y' - P'| on the step for every solution y in a proved tube, P(t) its curve: y' = f(t, y), so that it
    /// is at most |P' - f(t, P)| + |f(t, y) - f(t, P)|.
    std::vector<magnitude> slope_errors(const solution_tube& of);

private:
    struct bounds;
    std::vector<magnitude> start_radii(const tube_candidate& of, const tube_set& start,
                                       const bound_matrix& correction) const;

    const polynomial_map& map_;
    long bits_;
    std::vector<ball> constants_;
    std::vector<magnitude> constant_bounds_;
    coefficient_suprema by_coefficients_;
    node_suprema by_nodes_;
};

}  // namespace libration::ode
