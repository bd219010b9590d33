// An approximate solution over a step by collocation of high degree, and a frame that moves with it. No proof depends
// on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collocation_matrix.hpp"
#include "collocation_points.hpp"
#include "fast_modes.hpp"
#include "stiff_guide.hpp"
#include "tube_proof.hpp"

namespace libration::ode {

/// The precisions of a run of collocation.
struct collocation_accuracy {
    int degree = 0;
    double accepted = 0;      ///< decimal digits: the last Chebyshev coefficients of an unknown, relative to its scale
    double aimed = 0;         ///< the target of the step size, somewhat larger
    long bits = 0;            ///< of values at nodes
    long frame_bits = 0;      ///< of frames in powers of x
    long node_bits = 0;       ///< of frames and derivatives at nodes
    long product_bits = 0;    ///< of polynomials in powers of x
    double slowest_fast = 0;  ///< the limit between slow and fast modes (modes_of)
    double digits_below_width = 0;  ///< of the smallest scales

    /// For values to so many bits.
    static collocation_accuracy for_bits(long bits, int more_terms);
};

/// A step by Newton's method on the equations u(x_i) = u(-1) + sum_k S_ik f(u(x_k)): the matrix in double, in a basis in
/// which fast and slow modes of the middle of the step are apart (collocation_matrix), residuals in many digits.
class collocation_solver {
public:
    collocation_solver(const polynomial_map& map, const stiff_guide& guide, const collocation_points& nodes,
                       const collocation_accuracy& accuracy, const std::vector<ball>& constants);

    enum class outcome { solved, too_long, failed };
    /// From the set, scales of unknowns at least `floors`.
    outcome solve(const step_interval& on, const tube_set& start, const std::vector<magnitude>& floors);
    /// The factor by which the length is to change, for the next step or a repetition of this one.
    double factor() const { return factor_; }
    /// The curve and a frame, after `solved`; std::nullopt if no frame is found. With by_change, the inverse of the frame
    /// has a `change`, and the frame is computed in double.
    std::optional<tube_candidate> candidate(bool by_change);

private:
    bool guess(const tube_set& start, const std::vector<magnitude>& floors);
    bool factor_matrix();
    std::vector<std::vector<double>> jacobians_in_modes() const;
    void compute_jacobians();
    void compute_slopes();
    std::vector<ball> residual() const;
    magnitude correct(std::vector<ball>& residual, std::size_t columns) const;
    outcome iterate();
    bool measure_tail();
    bool slow_start(ball_columns& slow);
    std::vector<ball> slopes_of_columns(const std::vector<ball>& at_nodes, std::size_t columns) const;
    std::optional<std::vector<ball>> slow_columns(const ball_columns& start) const;
    std::optional<std::vector<ball>> rounded_slow_columns(const ball_columns& start);
    dense_matrix frame_at(const std::vector<ball>& slow, std::size_t node) const;
    bool interpolate_frame(const std::vector<ball>& slow, moving_frame& frame) const;
    bool interpolate_by_change(const std::vector<ball>& slow, moving_frame& frame) const;
    void interpolate_columns(const std::vector<ball>& slow, double below, moving_frame& frame) const;
    ball_polynomial interpolated(const ball* in_nodes, int stride, double below) const;
    std::size_t count() const { return map_.size(); }
    ball half() const { return shifted(on_.length, -1); }

    const polynomial_map& map_;
    const stiff_guide& guide_;
    const collocation_points& nodes_;
    collocation_accuracy accuracy_;
    const std::vector<ball>& constants_;
    step_interval on_;
    const tube_set* start_ = nullptr;
    std::vector<long> scales_;
    std::vector<ball> values_;  ///< scaled, node after node
    std::vector<ball> slopes_;  ///< f times half of the length, scaled
    std::vector<dense_matrix> jacobians_;
    std::optional<divided_modes> modes_;
    dense_matrix basis_, to_basis_;
    double stiffness_ = 1;  ///< the largest entry of Jacobians in the basis of modes
    collocation_matrix matrix_;
    double factor_ = 1;
};

}  // namespace libration::ode
