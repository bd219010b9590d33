// Theorem K for one step.
#pragma once

#include <optional>

#include "ball_polynomial.hpp"
#include "bound_matrix.hpp"
#include "libration/ode/rigorous/tube.hpp"

namespace libration::ode {

/// V and an approximate inverse W of it, exact polynomials by rows.
struct moving_frame {
    std::vector<ball_polynomial> columns, inverse;
    std::vector<std::size_t> blocks;
    std::size_t slow = 0;
};

/// The data from which a step is proved. They are arbitrary: the proof checks them.
struct tube_candidate {
    step_interval on;
    std::vector<long> scales;
    std::vector<ball_polynomial> curve;
    moving_frame frame;
};

class tube_proof {
public:
    /// Defects in `bits`, frames in `frame_bits`.
    tube_proof(const polynomial_map& map, long bits, long frame_bits);

    long bits() const { return bits_; }
    /// Chebyshev coefficients of a polynomial, in `bits`.
    std::vector<ball> chebyshev(const ball_polynomial& of);
    /// A tube that contains every solution beginning in the set; std::nullopt if the inequalities are not proved.
    std::optional<solution_tube> tube(const tube_candidate& of, const tube_set& start);

private:
    struct bounds;
    bool bound_linear_part(const tube_candidate& of, bounds& to);
    std::vector<magnitude> start_radii(const tube_candidate& of, const tube_set& start,
                                       const bound_matrix& correction) const;

    const polynomial_map& map_;
    long bits_, frame_bits_;
    chebyshev_form forms_;
    std::vector<ball> constants_;
    std::vector<magnitude> constant_bounds_;
};

}  // namespace libration::ode
