// Derivatives of solutions with events with respect to initial values and parameters, with every digit proved.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/query/flow_derivatives.hpp"

namespace libration::ode {

/// proved_part_of_hybrid with the derivatives of every value with respect to `numbers`, as proved_derivatives: at an
/// event by the saltation matrix (theorem H, 4), so that events move with the numbers. Throws the errors of both, and
/// error of the subject "derivatives" if the condition of an event holds at the initial point and nearby solutions may
/// cross its surface there.
partial_derivatives proved_derivatives_of_hybrid(const equation_system& given, const std::vector<number>& times,
                                                 const std::vector<std::string>& numbers, long digits,
                                                 const march_watch& watch = {}, const proof_route& route = {});

}  // namespace libration::ode
