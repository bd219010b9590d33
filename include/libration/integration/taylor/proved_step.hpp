// A step of theorem V: the flow from one set, by Taylor series with proved tails.
#pragma once

#include <optional>
#include <vector>

#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/integration/enclosed_step.hpp"
#include "libration/integration/lohner_set.hpp"
#include "libration/integration/proof_route.hpp"

namespace libration::ode {

/// The series of the centre c of a set with tail, and, in low precision, the series of the whole set with the
/// variations of the flow. proved_march makes and uses it. Distances are from the beginning of the step, of either sign
/// and up to length(), in absolute value.
class proved_step : public enclosed_step {
public:
    /// The longest distance for which the step is valid.
    const magnitude& length() const { return length_; }
    ball length_of_step() const override { return length_.exact(); }
    /// The unknowns of the solution through c.
    std::vector<ball> flow_of_centre(const ball& distance) const;
    /// The derivative of the flow with respect to the state at the beginning, for every point of the set.
    ball_matrix derivative_of_flow(const ball& distance) const;
    /// The unknowns of every solution through the set, at every distance of a ball.
    std::vector<ball> values_at(const ball& distance) const override;

    /// The precision and the order of the series of the centre.
    long bits() const { return bits_; }
    int order() const { return of_centre_.order(); }

private:
    friend class proved_march;
    // To be constructed in a scope of so many bits.
    proved_step(const tape& centre, const tape& varied, long bits, int set_order, const proof_route& route);

    long bits_;
    long set_bits_ = 0;
    taylor_expansion<ball> of_centre_, of_set_;
    std::optional<tail_bound> tail_, set_tail_;
    lohner_set errors_;
    double log_of_radius_;
    magnitude length_;
    bool ready_ = false;
};

}  // namespace libration::ode
