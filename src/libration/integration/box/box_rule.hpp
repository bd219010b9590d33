// Steps of theorem G: the error set is a box, and no derivative of the flow is carried.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "box_step.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/rule.hpp"
#include "libration/integration/taylor/step_length.hpp"
#include "slope_bounds.hpp"
#include "step_plan.hpp"

namespace libration::ode {

/// Theorem G (comparison) [THEOREMS]. On a piece of length h let z be the solution through the middle c of a box, exact,
/// from theorem T; R > 0; M >= the slopes of f at all |x - z(t)| <= R (slope_bounds). If r' >= M r, r >= 0, r(0) >= the
/// radii of the box, and r < R on ALL of the piece, every solution that begins in the box exists on it and satisfies
/// |y - z| <= r. The box at the end of a step has the radii r(h) + the tail of theorem T + the rounding of its middle.
///
/// Unknowns Z that are exactly 0 in the box and along z, with f_i exactly 0 for i in Z on all of the tube with x_Z = 0 (in
/// balls, in which a product with an exact 0 is 0), stay 0: M is that of the other unknowns on this tube. Their solution in
/// the theorem, with zeros, solves the whole system, and f is continuously differentiable: there is no other.
///
/// A step has several pieces, each with its own M, since the range over the whole step overestimates. R is a trial of a
/// few r(0) in the scales of the unknowns, or twice the r that was found with a smaller R.
///
/// One series system per step instead of 1 + n of theorem V, for log2 of the growth of r more bits: for many unknowns.
/// Precision and scales are chosen as in taylor_rule, and the steps too unless they are planned (step_plan).
class box_rule : public step_rule {
public:
    /// The form is that of the system, with the same given unknowns.
    box_rule(const polynomial_form& of, const explicit_system& system, const run_bits& bits, const proof_route& route);

    /// Throws error of the subject "integrator" if the derivative of the flow is kept.
    void begin(const flow_state& start) override;
    next_step next(const flow_state& from, const ball& rest) override;

    /// As taylor_rule::loses_an_unknown.
    bool loses_an_unknown(const std::vector<ball>& hull) const;
    /// log2 of the largest radius, in the scales of the unknowns, at the end of the last step over that at its
    /// beginning; 0 if that was exact.
    double growth() const { return growth_; }
    /// The relative accuracy, in bits, of the most accurate unknown at the beginning of the last step.
    long accuracy() const { return scales_.accuracy(bits_.bits); }

private:
    struct expansion {
        long bits;
        taylor_expansion<ball> of_centre;
    };

    // Part of a step.
    struct piece_of_time {
        ball times, distances;
        magnitude length;
        int direction;
    };

    void make_expansion(const flow_state& from, const ball& rest);
    void plan_step(const flow_state& from, const ball& rest, long bits);
    bool loses_a_decaying_unknown(const std::vector<ball>& centre);
    bool expand_centre(const flow_state& from);
    std::shared_ptr<box_series> made_series() const;
    tail_bound visible_tail() const;
    magnitude length_by_slopes(const flow_state& from, int direction);
    bool add_pieces(box_series& series, const ball& time, const magnitude& length, int direction);
    std::vector<magnitude> first_tube(const std::vector<magnitude>& start) const;
    std::optional<grown_radii> over_piece(const box_series& series, const piece_of_time& on,
                                          const std::vector<magnitude>& start);

    polynomial_form lifted_;
    tape tape_;
    slope_bounds slopes_;
    run_bits bits_;
    proof_route route_;
    unknown_scales scales_;
    std::unique_ptr<expansion> now_;
    std::unique_ptr<step_planner> planner_;
    std::optional<planned_step> plan_;
    ball origin_;
    long steps_ = 0;
    double growth_ = 0;
    std::optional<magnitude> most_length_;  // after a step that was halved
    std::vector<double> largest_;           // log2 of the largest value of an unknown while it is distinguished from 0
    std::vector<magnitude> shape_;          // the radii on the piece before

    // Of the step in preparation.
    std::vector<magnitude> radii_, weights_;
    std::optional<tail_bound> tail_;
};

}  // namespace libration::ode
