// Steps of the integrators of proofs, by the enclosures that they give.
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
    /// The same, more narrowly where more work allows it.
    virtual std::vector<ball> narrow_values_at(const ball& distance) const { return values_at(distance); }
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

/// The reason why a proof cannot continue.
enum class march_end {
    none,
    precision,  ///< the enclosure is too wide: more bits are needed
    steps       ///< the steps become too small: a singularity of the solution is near, in real or complex time
};

/// The steps of an integrator, one after the other.
class enclosed_steps {
public:
    enclosed_steps() = default;
    enclosed_steps(const enclosed_steps&) = delete;
    enclosed_steps& operator=(const enclosed_steps&) = delete;
    virtual ~enclosed_steps() = default;

    /// The step from reached() towards times at this distance, infinite if there is no last one, computed once and valid
    /// until the next one is taken. Returns nullptr if the proof ends here, for the reason end().
    virtual const enclosed_step* prepare_towards(const ball& rest) = 0;
    /// Takes the whole step that prepare_towards() has returned, forwards for direction >= 0.
    virtual void take_prepared(int direction) = 0;

    virtual march_end end() const = 0;
    /// The time up to which the solution is proved to exist.
    virtual const ball& reached() const = 0;
    virtual long steps() const = 0;
    /// The initial number of bits.
    virtual long bits() const = 0;
};

}  // namespace libration::ode
