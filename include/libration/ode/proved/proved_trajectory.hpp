// The solution of any system at a list of times, every digit proved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/printed_number.hpp"

namespace libration::ode {

/// A value at a time: its digits or, where no run within the limits proved them, a bound alone; neither where the
/// equations that it depends on are not proved to reach the time.
struct trajectory_value {
    std::optional<proved_decimal> decimal;  ///< every digit proved
    std::string bound;                      ///< without one: |value| < bound, three digits, proved, or empty
};

/// What was proved of a solution at a list of times.
struct partial_trajectory {
    /// At each time in order the unknowns and their lower derivatives; nothing at a time that none of them reached.
    std::vector<std::vector<trajectory_value>> states;
    /// Why a state or a decimal is missing, an error of the kind undecided, where one is: the solution is not proved to
    /// exist up to a time (the message has the time up to which it is), or a value is not distinguished from 0.
    std::optional<error> missing;
};

/// The unknowns and their lower derivatives, in order, at times in any order on both sides of the start: `digits`
/// significant digits each, proved to one unit in the last (proved_march, with the bits that the flow loses taken more
/// from run to run, as the runs before show). Unknowns that do not influence each other are integrated apart from each
/// other. One value or time that is not decided leaves the others as they are. Throws error where the start is singular
/// and theorem S does not hold for it, and for times before a singular start.
partial_trajectory proved_part_of_trajectory(const explicit_system& system, const std::vector<number>& times,
                                             long digits, const march_watch& watch = {}, const proof_route& route = {});

/// The same where nothing is missing; throws what is.
std::vector<std::vector<proved_decimal>> proved_trajectory(const explicit_system& system,
                                                           const std::vector<number>& times, long digits,
                                                           const march_watch& watch = {},
                                                           const proof_route& route = {});

/// The same states as balls, by one march of so many bits on either side of the start; nothing where one of them needs
/// more. Throws as proved_trajectory for a time that is not reached.
std::optional<std::vector<std::vector<ball>>> enclosed_trajectory(const explicit_system& system,
                                                                  const std::vector<number>& times, long bits);

}  // namespace libration::ode
