// The ways to make steps.
#pragma once

#include <memory>

#include "libration/integration/step.hpp"

namespace libration::ode {

/// A step, or the reason why there is none; both for a last step.
struct next_step {
    std::shared_ptr<const step> made = {};
    stop why = stop::none;
};

/// Owns what is used for step after step, such as arrays, and what adapts from step to step, but not the solution.
class step_rule {
public:
    step_rule() = default;
    step_rule(const step_rule&) = delete;
    step_rule& operator=(const step_rule&) = delete;
    virtual ~step_rule() = default;

    /// Begins anew, from this state. Throws error of the subject "integrator" if the requested method does not support it.
    virtual void begin(const flow_state& start) = 0;
    /// The step from a state, towards times at this distance, infinite if there is no last one, with the sign of the
    /// direction. Throws precision_exhausted.
    virtual next_step next(const flow_state& from, const ball& rest) = 0;
};

/// How steps are measured.
enum class error_weights {
    relative,  ///< each unknown has its own relative precision
    absolute,  ///< for a solution that tends to a constant while its derivative vanishes much faster
    any_width  ///< for a set of any width: the proof ends when no step is found, instead of when an unknown is not
               ///< distinguished from 0
};

}  // namespace libration::ode
