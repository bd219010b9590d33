// Coefficients of a motion of the pendulum by a chosen recurrence, and those of its resummation.
#pragma once

#include <string>

#include "libration/pendulum/coefficient_route.hpp"
#include "libration/pendulum/resummation_terms.hpp"
#include "libration/problem/series_request.hpp"
#include "libration/scalar/dispatch.hpp"
#include "motion_options.hpp"
#include "text/table.hpp"

namespace libration {

/// Columns n, coefficient, recurrence, difference: the coefficients as the recurrence gives them in this arithmetic,
/// without guard digits, and their distance from those with 30 digits more. Throws error for an arithmetic of balls.
table coefficients_by_recurrence(const chosen_motion& of, const series_request& powers,
                                 pendulum::coefficient_route route, const scalar_spec& scalar);

/// Columns n, a, s, c, b, a_hat, sigma, sigma_slope, alpha, beta, formulas, rigour for n = 0 .. N: row n has what
/// belongs to the truncation n, in dimensionless time. Corrected formulas agree with a second route to all digits
/// (two-method), printed ones are evaluated to these digits as they are. Throws error at E = 0 and 2.
table coefficients_of_resummation(const chosen_motion& of, const series_request& powers,
                                  pendulum::resummation_formulas by, long digits);

}  // namespace libration
