// The ways to make steps.
#pragma once

#include <memory>

#include "libration/digits/precision_loop.hpp"
#include "libration/equation/explicit_system.hpp"
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

/// The methods of proofs for a system, nested: the series about a singular initial point (theorem S), roots of the
/// distance from times with roots, Taylor series (theorem V) and collocation (theorem K). From a singular initial point
/// it begins with start_of() alone. Throws error for such a point that theorem S does not support, and of the subject "integrator" if the route is by collocation, which
/// does not support this system or precision.
std::unique_ptr<step_rule> rule_for(const explicit_system& system, const run_bits& bits, const proof_route& route = {},
                                    error_weights weights = error_weights::relative);

/// The initial point of the system, as the state from which rule_for() begins.
flow_state start_of(const explicit_system& system, long bits);

}  // namespace libration::ode
