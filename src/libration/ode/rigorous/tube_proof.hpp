// Theorem K for one step.
#pragma once

#include <optional>

#include "ball_polynomial.hpp"
#include "libration/ode/rigorous/tube.hpp"

namespace libration::ode {

/// V and an approximate inverse W of it, exact polynomials by rows.
struct moving_frame {
    std::vector<ball_polynomial> columns, inverse;
    std::vector<std::size_t> blocks;
    std::size_t slow = 0;
};

/// What a step is proved with: all of it is arbitrary, and the proof holds or does not.
struct tube_candidate {
    step_interval on;
    std::vector<long> scales;
    std::vector<ball_polynomial> curve;
    moving_frame frame;
};

/// Columns of V that are bounded together, in the Euclidean norm.
struct column_block {
    std::size_t begin, size;
};

class tube_proof {
public:
    /// Defects in `bits`, frames in `frame_bits`.
    tube_proof(const polynomial_map& map, long bits, long frame_bits);

    /// Every solution that begins in the set is in the tube; std::nullopt where the inequalities are not shown.
    std::optional<solution_tube> tube(const tube_candidate& of, const tube_set& start);

private:
    struct bounds;
    bool bound_linear_part(const tube_candidate& of, bounds& to);
    std::optional<std::vector<magnitude>> start_radii(const tube_candidate& of, const tube_set& start) const;

    const polynomial_map& map_;
    long bits_, frame_bits_;
    chebyshev_form forms_;
    std::vector<ball> constants_;
    std::vector<magnitude> constant_bounds_;
};

}  // namespace libration::ode
