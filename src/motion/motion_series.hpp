// The Taylor coefficients of theta about a point of a motion, for every subcommand that takes --order and --at.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/digits/proved/printed_values.hpp"
#include "libration/pendulum/taylor/expansion.hpp"
#include "motion/motion_options.hpp"

namespace libration {

/// Which coefficients, in which arithmetic.
struct series_request {
    chosen_motion chosen;
    scalar_spec scalar;
    pendulum::expansion_point at;
    long order;
    long first = 0;
};

/// The point that --at names; without it the top for an energy, the bottom at E = 2, the start for a state. Throws
/// input_error for what is no point of that motion.
pendulum::expansion_point point_of(const std::optional<std::string>& at, const chosen_motion& chosen);

/// a_first .. a_N in the motion's unit of time: right to the digits of an mpfr scalar; as a fixed scalar computes them
/// in time scaled by the radius, and without its bounds of range.
std::vector<mpfr> coefficient_values(const series_request& request);

/// a_first .. a_N with so many printed digits, proved where the scalar is a ball; what fractions show to be 0 is 0.
/// Throws error of the kind undecided where no precision gives the digits.
std::vector<printed_number> printed_coefficients(const series_request& request, long digits);

/// The radius of convergence about the point from the lattice of singularities, in the motion's unit of time, to
/// `digits` digits; nothing where it is infinite.
std::optional<mpfr> exact_radius(const series_request& request, long digits);

}  // namespace libration
