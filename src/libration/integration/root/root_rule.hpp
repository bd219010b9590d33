// The steps of a proof across a time with roots, in a root of the distance from it.
#pragma once

#include <memory>
#include <vector>

#include "root_step.hpp"

namespace libration::ode {

/// Near a time tau with roots the solution y(tau + side w^degree) is analytic in w, and is continued in w by theorem V:
/// from a time before tau up to one after it where the roots are real on both sides, otherwise up to tau itself, where it
/// ends; and from tau on if that is the initial point.
class root_rule {
public:
    root_rule(const explicit_system& of, std::vector<root_time> times, const run_bits& bits, proof_route route,
              error_weights weights);

    /// The part of a step that leads to where a passage is to begin; null if no roots are near ahead.
    std::shared_ptr<const step> entry(const series_step& whole, int direction) const;
    /// From an initial point with a series in powers of (t - t0)^(1/degree), at w = 0. Throws like proved_singular_step.
    std::shared_ptr<const root_passage> passage_from_start(const explicit_system& system) const;
    /// Begins there.
    static flow_state begin_at_start(const std::shared_ptr<const root_passage>& passage, flow_state start);
    /// Whether a state is one of a passage that leads in this direction of t, and not yet beyond the roots.
    static bool leads_towards(const flow_state& from, int direction);
    static next_step next(const flow_state& from);
    /// A state of a passage, from which another rule continues.
    static flow_state end_of(const flow_state& from) { return {from.time, from.set, from.derivative, {}}; }

private:
    std::shared_ptr<root_passage> passage_about(const root_time& about) const;

    first_order_form form_;
    std::vector<root_time> times_;
    run_bits bits_;
    proof_route route_;
    error_weights weights_;
};

}  // namespace libration::ode
