// A step of either integrator of proofs, by the enclosures that it gives.
#pragma once

#include <vector>

#include "libration/scalar/ball/value.hpp"

namespace libration::ode {

/// Enclosures of every solution that begins in the set of a step. Distances are from the beginning of the step, with the
/// sign of the direction, and up to length() in absolute value; of a ball that is rounded beyond that, only the part
/// within the step counts.
class enclosed_step {
public:
    enclosed_step() = default;
    enclosed_step(const enclosed_step&) = default;
    enclosed_step(enclosed_step&&) = default;
    enclosed_step& operator=(const enclosed_step&) = default;
    enclosed_step& operator=(enclosed_step&&) = default;
    virtual ~enclosed_step() = default;

    /// Exact, positive.
    virtual ball length_of_step() const = 0;
    /// The given unknowns, at every distance of a ball.
    virtual std::vector<ball> values_at(const ball& distance) const = 0;
    /// Their derivatives there, if they are enclosed more narrowly than the right-hand sides by values_at(); empty
    /// otherwise.
    virtual std::vector<ball> slopes_at(const ball& /*distance*/) const { return {}; }

    /// Whether every distance of the ball is in the step.
    bool reaches(const ball& distance) const {
        ball size;
        arb_abs(size.handle(), distance.handle());
        return arb_le(size.handle(), length_of_step().handle()) != 0;
    }
};

}  // namespace libration::ode
