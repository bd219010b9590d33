// The state at times as they were typed for --times.
#pragma once

#include <string>

#include "libration/pendulum/proved/proved_states.hpp"

namespace libration {

/// The state at one of the times. Throws input_error where omega is too small to be printed: on the separatrix it falls
/// like exp(-t), until no exponent holds it.
pendulum::proved_states::state_text state_at(pendulum::proved_states& states, const exact& time,
                                             const std::string& typed);

}  // namespace libration
