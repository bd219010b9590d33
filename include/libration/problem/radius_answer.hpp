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

/// The verdict and the results of all tests (convergence::answers_of) in the scalar of the request, heuristic, each number
/// with the digits that its uncertainty supports: method, radius, uncertainty, exact, relative_error, position_re,
/// position_im, kind, count, note, exponent, exponent_uncertainty, rigour. The first row is the verdict. For several
/// unknowns that is the verdict of the one with the nearest singularity, the rows of each follow, and the next column is
/// `unknown`. In the rows of verdicts the radius is 0 for a divergent series and inf for an entire function, and these
/// columns follow: bound (at least, at most), gevrey, action, action_uncertainty, suspect, suspect_predicted,
/// suspect_uncertainty, prediction (log10 of the relative error of the last coefficient predicted from the others),
/// history and ring, which are JSON arrays of objects. `exact` is the radius as known otherwise, with
/// radius_guard_digits more digits than are printed, if it is known. The notes are the verdict in words. A pole where the
/// analysis finds branches gets no kind.
answer radius_answer(const std::vector<unknown_series>& unknowns, const std::optional<mpfr>& exact, const request& how,
                     const branch_analysis& analysis = {});

}  // namespace libration
