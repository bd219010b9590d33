// The Taylor coefficients of theta about a point of a motion of the pendulum, and their radius of convergence.
#pragma once

#include <vector>

#include "libration/digits/printed_values.hpp"
#include "libration/pendulum/point_coefficients.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/problem/answer.hpp"
#include "libration/problem/series_request.hpp"

namespace libration {

/// a_first .. a_order in the motion's unit of time with the printed digits, proved if the scalar is a ball; those that
/// exact fractions show to be 0 are 0. Throws error of the kind undecided if no precision gives the digits.
std::vector<printed_number> printed_coefficients(const pendulum::motion& m, const pendulum::expansion_point& point,
                                                 const series_request& of, const request& how);

/// The same as numbers: with an mpfr scalar correct to its digits; with a fixed scalar as computed in time scaled by
/// the radius, and without its bounds of range.
std::vector<mpfr> coefficient_values(const pendulum::motion& m, const pendulum::expansion_point& point,
                                     const series_request& of, const scalar_spec& scalar);

/// The radius of convergence about the point from the lattice of singularities, in the motion's unit of time, correct
/// to this number of digits, also infinite.
mpfr radius_to_digits(const pendulum::motion& m, const pendulum::expansion_point& point, long digits);

/// Proved bounds of it that agree to this number of digits.
ode::proved_radius radius_bounds(const pendulum::motion& m, const pendulum::expansion_point& point, long digits);

}  // namespace libration
