// The radius of convergence of several unknowns from their coefficients: all tests, and a verdict.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/problem/series_request.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// The results of all tests (convergence::answers_of) in the scalar of the request, heuristic, each number with the
/// digits that its uncertainty supports: method, radius, uncertainty, exact, relative_error, position_re, position_im,
/// kind, count, note, exponent, exponent_uncertainty, rigour. The first row is the verdict. For several unknowns that
/// is the verdict of the one with the nearest singularity, the rows of each follow, and the last column is `unknown`.
/// `exact` is the radius as known otherwise, with radius_guard_digits more digits than are printed, if it is known. The
/// notes are the verdict in words.
answer radius_answer(const std::vector<unknown_series>& unknowns, const std::optional<mpfr>& exact, const request& how);

}  // namespace libration
