// Steps of theorem V.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "libration/digits/precision_loop.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/rule.hpp"
#include "libration/integration/taylor/step_length.hpp"
#include "series_step.hpp"
#include "set_expansion.hpp"

namespace libration::ode {

/// Theorem V. The solution remains in c + Q [-r, r], c exact, from step to step: Phi, the flow over a step h, maps c
/// into c' + [-tau, tau] by theorem T from the exact point (tau contains the tail, the radii of its balls, the rounding
/// of c'), and A, from theorem T for the system with its variations over the whole set, contains the derivative of Phi
/// at every point of the set, which is convex; so Phi of the set lies in c' + A Q [-r, r] + [-tau, tau]
/// (lohner_set). Proof: Phi(z) - Phi(c) = (int_0^1 DPhi(c + x (z - c)) dx)(z - c).
///
/// The unknowns are those of the given system with their lower derivatives; the other unknowns of theorem T
/// (polynomial_form) are computed from them in each step. The precision decreases as the set grows: digits below its
/// width are noise.
///
/// Each unknown has its own relative precision: the set is kept in scales 2^k near the sizes of the unknowns on the
/// step (lohner_set::settled), and tails are bounded relative to the size of their unknown or to the set's own width
/// (step_length.hpp). An unknown that is 0 at all times remains an exact 0: its centre, tail and row of A are exact
/// zeros. One that is not distinguished from 0 for another reason has no effect on the steps; one that was
/// distinguished before, and is no longer, ends the proof for lack of precision.
class taylor_rule : public step_rule {
public:
    taylor_rule(const polynomial_form& of, const run_bits& bits, const proof_route& route, error_weights weights);

    void begin(const flow_state& start) override;
    next_step next(const flow_state& from, const ball& rest) override;

    /// By the state alone, also for an unknown near 0; the next step decides.
    bool loses_an_unknown(const std::vector<ball>& hull) const;

private:
    // The expansions, with the bits of the centre.
    struct expansions {
        long bits;
        taylor_expansion<ball> of_centre;
        set_expansion of_set;
    };

    void make_expansions();
    bool expand_centre();
    bool expand_set();
    bool settles();
    bool expand_variations();
    std::shared_ptr<taylor_series> made_series() const;
    double wanted_length(double& growth);
    magnitude shortened_for_width(const taylor_series& series, magnitude length) const;
    stop end_without_bounds() const;

    polynomial_form lifted_;
    tape tape_;
    set_form varied_;
    run_bits bits_;
    proof_route route_;
    error_weights weights_;
    int set_order_;
    unknown_scales scales_;
    long set_bits_;  // of the error map: those of errors plus the loss by its largest terms
    std::unique_ptr<expansions> now_;
    ball origin_;
    long steps_ = 0;
    int unsettled_ = 0;  // steps with the same frame

    // Of the step in preparation.
    ball time_;
    state_set set_;
    double log_of_radius_ = 0;
    std::optional<tail_bound> tail_, set_tail_;
};

}  // namespace libration::ode
