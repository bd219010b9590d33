// The motions and times of a table, from its options: lists of energies, gaps, angles and velocities.
#pragma once

#include <optional>
#include <vector>

#include "libration/pendulum/typed_motion.hpp"
#include "libration/problem/known/pendulum.hpp"
#include "option/option_words.hpp"

namespace libration {

/// A motion of the grid; the texts of energy and gap where they were typed.
struct grid_motion {
    pendulum::typed_motion typed;
    pendulum::motion of;
    std::optional<sweep_energy> texts;
};

/// --energies, --gaps, --theta0, --omega0, --direction, --length, --gravity, --times.
void offer_motions(option_words& said, CLI::App& command);

/// The motions in the order in which they were typed, --energies before --gaps, each from every angle where
/// there are some. Throws input_error.
std::vector<grid_motion> motions_of(const option_words& said);

/// The times. Throws input_error, also where one of the motions has no period that they are multiples of, and where
/// they are too many.
std::vector<exact> times_for(const std::vector<grid_motion>& motions, const option_words& said);

}  // namespace libration
