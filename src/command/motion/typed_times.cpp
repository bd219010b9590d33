#include "motion/typed_times.hpp"

#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

proved_states::state_text state_at(proved_states& states, const exact& time, const std::string& typed) {
    try {
        return states.at(time);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::range) {
            throw;
        }
        throw input_error("--times", typed, "has '" + time.text + "', where omega is too small to be printed",
                          "choose times closer to 0");
    }
}

}  // namespace libration
