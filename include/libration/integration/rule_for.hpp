// The methods of proofs, nested.
#pragma once

#include <memory>

#include "libration/digits/precision_loop.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/integration/rule.hpp"

namespace libration::ode {

/// The methods for a system, nested: a singular initial point is left by a step of theorem S; times with roots
/// (root_time.hpp) are crossed by steps in a root of the distance from them, in which the solution is analytic; elsewhere
/// method_choice.hpp chooses between Taylor series (theorem V) and collocation (theorem K). From a singular initial point
/// it begins with start_of() alone. Throws error for such a point that theorem S does not support, and of the subject
/// "integrator" if the route is by collocation, which does not support this system or precision.
std::unique_ptr<step_rule> rule_for(const explicit_system& system, const run_bits& bits, const proof_route& route = {},
                                    error_weights weights = error_weights::relative);

/// The initial point of the system, as the state from which rule_for() begins.
flow_state start_of(const explicit_system& system, long bits);

}  // namespace libration::ode
