// Equilibria that a solution with given limits tends to, exactly.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

/// The equilibria with given limits: a point, or a line or surface of them with free coordinates.
struct far_state {
    std::vector<expression> values;       ///< of all leaves, in the leaves of the free numbers and coordinates
    std::vector<expression> coordinates;  ///< the leaves of the free ones
    std::vector<std::string> names;       ///< of these, as f(inf)
    std::vector<bool> ignored;            ///< leaves on which those with given limits do not depend
};

/// Where the slopes of all leaves vanish identically: `given` are the limits of some leaves and the free numbers. Each
/// slope that is linear in one of the other leaves, with a number as its factor, determines it; leaves that occur in no
/// slope then are free coordinates. Throws error of the subject "conditions" for limits for which a slope is not seen to
/// vanish, and where a limit is missing.
far_state far_state_of(const first_order_form& form, const std::vector<std::pair<std::size_t, expression>>& given,
                       int direction);

}  // namespace libration::ode
