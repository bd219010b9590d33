// Values of the solution of a delay differential equation to proved digits.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/delay_system.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/query/states.hpp"

namespace libration::ode {

/// The unknowns and their lower derivatives at times from the initial point on, in any order: `digits` significant
/// digits each, proved by the method of steps with theorem M, in runs with increasing precision. `missing` is an error
/// of the kind undecided where the steps become too small, as near a singularity, and for values that are not
/// distinguished from 0, and for times beyond the last one of the system. Throws error of the kind argument for times
/// before the initial point. A step ends where a
/// delayed value passes the end of one of its own steps, so that with several incommensurable delays their number grows as
/// that of the breaking points does. Errors of delayed values are intervals: the bits that this costs are added to the
/// precision.
partial_trajectory proved_part_of_delay(const delay_system& system, const std::vector<number>& times, long digits,
                                        const march_watch& watch = {});

/// The same states as balls, by one integration with so many bits, for ascending times; std::nullopt if it does not reach
/// the last one.
std::optional<std::vector<std::vector<ball>>> enclosed_delay(const delay_system& system,
                                                             const std::vector<number>& times, long bits);

/// The same states in a scalar of fixed precision, with the accuracy of one integration by the same method without
/// bounds: at each time a single list of all leaves, empty if the time is not reached.
template <ordered_scalar T>
partial_states<T> part_of_delay(const delay_system& system, const std::vector<number>& times,
                                const march_watch& watch = {});

}  // namespace libration::ode
