// The radius of convergence of several unknowns from their coefficients: all tests, and a verdict.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/problem/answer.hpp"
#include "libration/problem/series_request.hpp"
#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// Whether a function is single-valued around its singularity at this place, relative to the point of the series, if that
/// is known from its equations.
using branch_analysis = std::function<std::optional<bool>(const complex_number<mpfr>& place)>;

/// The results of all tests (convergence::answers_of) in the scalar of the request, heuristic, each number with the
/// digits that its uncertainty supports: method, radius, uncertainty, exact, relative_error, position_re, position_im,
/// kind, count, note, exponent, exponent_uncertainty, rigour. The first row is the verdict. For several unknowns that
/// is the verdict of the one with the nearest singularity, the rows of each follow, and the last column is `unknown`.
/// `exact` is the radius as known otherwise, with radius_guard_digits more digits than are printed, if it is known. The
/// notes are the verdict in words. A verdict calls a singularity a pole if the analysis does or, where that does not know,
/// if shorter lists do too; other kinds have to be those of shorter lists (convergence::keeps_kind).
answer radius_answer(const std::vector<unknown_series>& unknowns, const std::optional<mpfr>& exact, const request& how,
                     const branch_analysis& analysis = {});

}  // namespace libration
