// The steps of an integration as values that are kept, and the states between them.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "libration/integration/lohner_set.hpp"
#include "libration/integration/proof_route.hpp"

namespace libration::ode {

/// The reason why nothing follows the last step of an integration.
enum class stop {
    none,
    precision,      ///< the enclosure is too wide: more bits are needed
    step_too_small  ///< or too many steps: a singularity of the solution is near, in real or complex time
};

/// What only the rule that made a step can continue from.
struct carried {
    carried() = default;
    carried(const carried&) = delete;
    carried& operator=(const carried&) = delete;
    virtual ~carried() = default;
};

/// All that passes from one step to the next.
struct flow_state {
    ball time;      ///< exact, unless that of the initial point or of a breaking point is not
    state_set set;  ///< of all solutions that are followed: the given unknowns with their lower derivatives
    /// By the initial state, for all solutions; only if it is kept.
    std::optional<ball_matrix> derivative = {};
    std::shared_ptr<const carried> more = {};
};

/// An immutable enclosure of every solution that begins in the set of a step. Distances are from its beginning, with the
/// sign of the direction, and up to length(); of a ball that is rounded beyond that, only the part within the step
/// counts. The precision is that of the caller.
class step {
public:
    /// How a step was made.
    struct origin {
        long bits = 0;
        int order = 0;
        step_method method = step_method::taylor;
        long cost = 1;  ///< in steps of Taylor series that take about as long
    };

    step(flow_state from, ball length, const origin& made)
        : from_(std::move(from)), length_(std::move(length)), made_(made) {}
    step(const step&) = delete;
    step& operator=(const step&) = delete;
    virtual ~step() = default;

    const flow_state& from() const { return from_; }
    /// Exact, with the sign of the direction.
    const ball& length() const { return length_; }
    long cost() const { return made_.cost; }
    const origin& made() const { return made_; }
    step_report report() const;
    /// Whether every distance of the ball is at most the length, in absolute value.
    bool reaches(const ball& distance) const;
    /// Whether every distance of the ball is in the step.
    virtual bool covers(const ball& distance) const;

    /// The given unknowns, at every distance of a ball.
    virtual std::vector<ball> values(const ball& distance) const = 0;
    /// The same, more narrowly where more work allows it.
    virtual std::vector<ball> narrow_values(const ball& distance) const { return values(distance); }
    /// Their derivatives there, if they are enclosed more narrowly than the right-hand sides by values(); empty
    /// otherwise.
    virtual std::vector<ball> slopes(const ball& /*distance*/) const { return {}; }
    /// The derivative of the values by the initial state, if that of from() is kept.
    virtual ball_matrix derivative(const ball& distance) const = 0;
    virtual flow_state end() const = 0;
    /// values(), kept for others that ask for the same distance in the same precision.
    std::vector<ball> shared_values(const ball& distance) const;
    /// The time of end().
    virtual ball end_time() const;

private:
    struct kept_values {
        ball distance;
        long bits;
        std::vector<ball> values;
    };

    flow_state from_;
    ball length_;
    origin made_;
    mutable std::mutex kept_guard_;
    mutable std::vector<kept_values> kept_;
};

/// The box of balls as a set, in so many bits.
state_set box_around(const std::vector<ball>& values, long bits);

/// a - b, without rounding if both are exact, so that the end of a step is in it.
ball distance_between(const ball& a, const ball& b);

/// The unit matrix.
ball_matrix unit_derivative(std::size_t size);

}  // namespace libration::ode
