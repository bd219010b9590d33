// The solutions whose states `libration reference` prints: of a problem, a motion, or the motions of a file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/problem/known/pendulum_solution.hpp"
#include "option/options.hpp"
#include "problem/motion_options.hpp"
#include "problem/solution_table.hpp"

namespace libration {

/// The argument of --times for the limits.
inline constexpr const char* infinite_time = "inf";

// A solution with the requested times.
struct asked_solution {
    std::unique_ptr<solution> of;
    std::vector<exact> times;
    std::string typed;  ///< the argument that gave the times, for messages
    std::optional<chosen_motion> motion = {};
};

/// The states at the times, or the limits. Throws input_error for times far from 0 at which a motion cannot be printed.
partial_table states_of(const asked_solution& asked, const request& how);

/// A motion at these times.
asked_solution asked_motion(const motion_options& motion, const std::string& times, long digits);

/// The motions of a file with renamed columns, those of consecutive rows combined, at times of the file or these; options complete the rows.
/// Throws input_error.
std::vector<asked_solution> asked_motions(const motion_options& motion, const std::string& path,
                                          const std::optional<std::string>& renamed,
                                          const std::optional<std::string>& times);

}  // namespace libration
