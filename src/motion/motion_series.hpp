// The Taylor coefficients of theta about a point of a motion, for every subcommand that takes --order and --at.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/digits/proved/printed_values.hpp"
#include "libration/pendulum/taylor/expansion.hpp"
#include "motion/motion_options.hpp"

namespace libration {

/// The range of coefficients and the arithmetic.
struct series_request {
    chosen_motion chosen;
    scalar_spec scalar;
    pendulum::expansion_point at;
    long order;
    long first = 0;
};

/// The point named by --at; by default the top for an energy, the bottom at E = 2, the initial point for a state.
/// Throws input_error for anything that is not a point of that motion.
pendulum::expansion_point point_of(const std::optional<std::string>& at, const chosen_motion& chosen);

/// a_first .. a_N in the motion's unit of time: with an mpfr scalar correct to its digits; with a fixed scalar as
/// computed in time scaled by the radius, and without its bounds of range.
std::vector<mpfr> coefficient_values(const series_request& request);

/// a_first .. a_N with this number of printed digits, proved if the scalar is a ball; those that exact fractions show
/// to be 0 are 0. Throws error of the kind undecided if no precision gives the digits.
std::vector<printed_number> printed_coefficients(const series_request& request, long digits);

/// The radius of convergence about the point from the lattice of singularities, in the motion's unit of time, to
/// `digits` digits; std::nullopt if it is infinite.
std::optional<mpfr> exact_radius(const series_request& request, long digits);

}  // namespace libration
