// The solution of any system at a list of times, with every digit proved.
#pragma once

#include <optional>
#include <vector>

#include "libration/digits/known_value.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

using libration::known_value;

/// The proved part of a solution at a list of times.
struct partial_trajectory {
    /// At each time, in order, the unknowns and their lower derivatives; empty at a time that none of them reached.
    std::vector<std::vector<known_value>> states;
    /// The reason for a missing state or decimal, an error of the kind undecided, if one is missing: the solution is
    /// not proved to exist up to a time (the message contains the time up to which it is), or a value is not
    /// distinguished from 0.
    std::optional<error> missing;
    /// Of the last run of each independent subsystem in each direction, where collocation was used.
    std::vector<collocation_use> collocation = {};
    /// hybrid_path::by_relation.
    std::vector<std::string> by_relation = {};
};

/// The unknowns and their lower derivatives, in order, at times in any order on both sides of the initial point:
/// `digits` significant digits each, proved to one unit in the last (proved_march, with the bits lost by the flow added
/// from run to run, as observed in the runs before). Unknowns that do not influence each other are integrated
/// separately. An undecided value or time does not affect the others. Throws error if the initial point is singular and
/// theorem S does not apply to it, for times before a singular initial point, and for an integrator that is not
/// possible (proved_march). The observer is called for each step of each run; with kept steps for those that are made.
partial_trajectory proved_part_of_trajectory(const explicit_system& system, const std::vector<number>& times,
                                             long digits, const march_watch& watch = {}, const proof_route& route = {},
                                             const step_observer& observer = {}, kept_integrations* kept = nullptr);

/// The same if nothing is missing; otherwise throws the reason.
std::vector<std::vector<proved_decimal>> proved_trajectory(const explicit_system& system,
                                                           const std::vector<number>& times, long digits,
                                                           const march_watch& watch = {},
                                                           const proof_route& route = {});

/// The same states as balls, by one integration with so many bits on either side of the initial point; std::nullopt if
/// one of them needs more bits. Throws like proved_trajectory for a time that is not reached.
std::optional<std::vector<std::vector<ball>>> enclosed_trajectory(const explicit_system& system,
                                                                  const std::vector<number>& times, long bits);

}  // namespace libration::ode
