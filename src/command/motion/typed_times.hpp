// The state at times as they were typed for --times.
#pragma once

#include <string>

#include "libration/pendulum/proved_states.hpp"

namespace libration {

/// The state at one of the times. Throws input_error if omega is too small to be printed: on the separatrix it
/// decreases like exp(-t), below every exponent.
pendulum::proved_states::state_text state_at(pendulum::proved_states& states, const exact& time,
                                             const std::string& typed);

}  // namespace libration
