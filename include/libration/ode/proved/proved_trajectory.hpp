// The solution of any system at a list of times, every digit proved.
#pragma once

#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/text/printed_number.hpp"

namespace libration::ode {

/// The unknowns and their lower derivatives, in order, at times in any order on both sides of the start: `digits`
/// significant digits each, proved to one unit in the last (proved_march, with the bits that the flow loses taken more
/// from run to run, as the runs before show).
/// Throws error of the kind undecided where a time is not reached, for the steps become too small before it: it says up
/// to which time the solution is proved to exist; and where a value is not told from 0. Throws error where the start is
/// singular.
std::vector<std::vector<proved_decimal>> proved_trajectory(const explicit_system& system,
                                                           const std::vector<number>& times, long digits,
                                                           const march_watch& watch = {},
                                                           const proof_route& route = {});

/// The same states as balls, by one march of so many bits on either side of the start; nothing where one of them needs
/// more. Throws as proved_trajectory for a time that is not reached.
std::optional<std::vector<std::vector<ball>>> enclosed_trajectory(const explicit_system& system,
                                                                  const std::vector<number>& times, long bits);

}  // namespace libration::ode
