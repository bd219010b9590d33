// Correct digits of a pendulum's motion, to any requested number: start here. No working precision has to be chosen.
#pragma once

#include <string>

#include "libration/pendulum/arc_method.hpp"
#include "libration/pendulum/given_motion.hpp"
#include "libration/scalar/printed_number.hpp"

/// Each digit is correct to one unit in the last, by rounding arithmetic: by one run if its error is bounded in advance
/// (periods and energies), otherwise by runs that agree.
/// Times are exact as written, "1e12", "3/2", "T/4" for a fraction of the period, and like all results in the units of
/// the motion: sqrt(l/g), or seconds if it has a length and a gravity. FLINT is not needed.
/// Each throws error: of the kind argument, with the quantity and its value, for an invalid motion, time or order; of
/// the kind undecided if no precision within the limits yields the digits.
namespace libration::rounded {

/// The angle, not reduced to one turn, and the angular velocity.
rounded_decimal theta(const pendulum::given_motion& motion, const std::string& time, long digits);
rounded_decimal omega(const pendulum::given_motion& motion, const std::string& time, long digits);

/// The period T (for rotation the time of one turn) and the effective period T*, from the top to the bottom [paper
/// (T), (Tstar)]; inf at E = 2.
rounded_decimal period(const pendulum::given_motion& motion, long digits);
rounded_decimal effective_period(const pendulum::given_motion& motion, long digits);

/// E, and 2 - E, the distance from the separatrix.
rounded_decimal energy(const pendulum::given_motion& motion, long digits);
rounded_decimal gap(const pendulum::given_motion& motion, long digits);

/// The coefficient of the power n of the Taylor series of theta about a point: "top", "bottom", "start" or a time.
rounded_decimal coefficient(const pendulum::given_motion& motion, const std::string& point, long n, long digits);

/// The radius of convergence of the Taylor series of theta about a point: "top", "bottom", "start" or a time [paper
/// (librationROC), (rotationROCgood)]; inf at rest.
rounded_decimal radius(const pendulum::given_motion& motion, const std::string& point, long digits);

/// max |theta - approximation| on [0, T*] from the top, in radians, of the series or its resummation of order N [paper
/// fig:error]; for a motion whose energy is rational and neither 0 nor 2.
rounded_decimal error_norm(const pendulum::given_motion& motion, pendulum::arc_method method, int order, long digits);

}  // namespace libration::rounded
