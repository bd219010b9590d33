// Bounds over a step of the polynomials from which theorem K is checked, by two rules.
#pragma once

#include <cstddef>
#include <vector>

#include "../../algebra/bound_matrix.hpp"
#include "../../algebra/dense_matrix.hpp"
#include "ball_polynomial.hpp"
#include "libration/integration/collocation/tube.hpp"
#include "polynomial_map.hpp"

namespace libration::ode {

/// V and an approximate inverse W of it, exact polynomials by rows. W is (1 + H) times `inverse`, H having the columns
/// of `change`, one for each slow mode, and then zeros; without `change`, H = 0.
struct moving_frame {
    std::vector<ball_polynomial> columns, inverse;
    std::vector<std::size_t> blocks;
    std::size_t slow = 0;
    std::vector<ball_polynomial> change = {};
};

/// W at a place, from the values of `inverse` and of `change` there; in the working precision.
dense_matrix inverse_of_frame(dense_matrix inverse, std::vector<ball> change, std::size_t slow);

/// The data from which a step is proved. They are arbitrary: the proof checks them.
struct tube_candidate {
    step_interval on;
    std::vector<long> scales;
    std::vector<ball_polynomial> curve;
    moving_frame frame;
};

/// Of scaled unknowns, with the time x; matrices by rows.
struct step_suprema {
    bound_matrix linear;            ///< |W (J V - V')|
    bound_matrix unit;              ///< |W V - 1|
    bound_matrix frame, inverse;    ///< |V|, |W|
    std::vector<magnitude> curve;   ///< |p|
    std::vector<magnitude> defect;  ///< |W (p' - f(t, p))|
    std::vector<ball> rates;        ///< upper bounds of mu(W (J V - V')) of blocks
};

/// Upper bounds, with their signs, of the diagonal entries of a block of two, of the sum of the others and of minus that
/// sum on the parts of a step; for a block of one the first list alone.
struct block_bounds {
    std::vector<ball> first, second, plus, minus;
};

/// An upper bound of mu of the block over the step: the largest eigenvalue of a symmetric 2 by 2 matrix increases with
/// its diagonal entries and with the absolute value of the other one.
ball rate_of(const block_bounds& of);

/// The parts of a step in which the rate of a fast mode is bounded.
constexpr int parts_of_rate = 8;

class node_frames;

/// By sums of |Chebyshev coefficients| of the polynomials multiplied out: what can be checked in integers. For frames
/// without `change`.
class coefficient_suprema {
public:
    /// Defects in `bits`, frames in `frame_bits`.
    coefficient_suprema(const polynomial_map& map, const std::vector<ball>& constants, long bits, long frame_bits)
        : map_(map), constants_(constants), frame_bits_(frame_bits), forms_(bits) {}

    step_suprema of(const tube_candidate& found);
    /// p' - f(t, p), of scaled unknowns and with the time x.
    std::vector<ball_polynomial> defect(const step_interval& on, const std::vector<long>& scales,
                                        const std::vector<ball_polynomial>& curve) const;
    chebyshev_form& forms() { return forms_; }

private:
    polynomial_map::result<ball_polynomial> on_curve(const step_interval& on, const std::vector<long>& scales,
                                                     const std::vector<ball_polynomial>& curve,
                                                     bool with_entries) const;
    void add_linear(const tube_candidate& found, const std::vector<ball_polynomial>& derivative, step_suprema& to);
    block_bounds bounds_of(const std::vector<ball_polynomial>& linear, std::size_t size, column_block b);

    const polynomial_map& map_;
    const std::vector<ball>& constants_;
    long frame_bits_;
    chebyshev_form forms_;
};

/// By values at the M zeros of T_M. For a polynomial a of degree at most m < M [EhlichZeller1964]
///     max |a(x)| on [-1, 1] <= max_k |a(x_k)| / cos(pi m/(2M)):
/// t(u) = a(cos u) is a trigonometric polynomial of degree m, at most 1 in absolute value and 1 at u*, say; then
/// t(u) >= cos(m (u - u*)) for |u - u*| <= pi/m [Riesz1914], and an angle (2k - 1) pi/(2M) is at a distance of at most
/// pi/(2M). With M >= 3m/2 the factor is at most 2. Products of polynomials become products of matrices at nodes, so
/// that for many unknowns the cost is a small part of that of coefficients.
class node_suprema {
public:
    /// Defects in `bits`; coefficients of frames in `frame_bits`, their values in `node_bits`.
    node_suprema(const polynomial_map& map, const std::vector<ball>& constants, long bits, long frame_bits,
                 long node_bits)
        : map_(map), constants_(constants), bits_(bits), frame_bits_(frame_bits), node_bits_(node_bits) {}

    step_suprema of(const tube_candidate& found);

private:
    struct sampled;
    struct degrees;
    using block_values = std::vector<std::vector<ball>>;

    void add_node(const sampled& values, node_frames& frames, int k, step_suprema& most, block_values& in_blocks) const;

    const polynomial_map& map_;
    const std::vector<ball>& constants_;
    long bits_, frame_bits_, node_bits_;
};

}  // namespace libration::ode
