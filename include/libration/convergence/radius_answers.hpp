// The radius of convergence of functions from lists of their coefficients, in a scalar that is chosen at run time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/convergence/estimate/radius_estimate.hpp"
#include "libration/convergence/list/coefficient_pattern.hpp"
#include "libration/scalar/dispatch.hpp"
#include "libration/scalar/exact.hpp"
#include "libration/series/power_series.hpp"

namespace libration::convergence {

/// Coefficients a_0 .. a_N to judge. Of those that somebody wrote down, what was written says how well they are known,
/// and they may end in a floor of noise; all others are right to the digits of the scalar.
struct listed_series {
    series::power_series<mpfr> coefficients;
    std::vector<exact> written = {};
};

/// The list of a function, or those of its real and of its imaginary parts, in powers of the root-th root of its
/// variable.
struct listed_function {
    std::vector<listed_series> parts;
    int root = 1;
};

/// What all tests said, the verdict first, in the unit of the list.
struct radius_answers {
    coefficient_pattern pattern;
    std::string floor;  ///< of noise, in words; empty where there is none
    std::vector<radius_estimate<mpfr>> rows;
};

/// The radius is computed with so many digits more than it is printed.
inline constexpr long radius_guard_digits = 20;

/// The answers to a function, computed in a scalar that rounds: of its list, or of that part of it which has the nearer
/// singularity. The place of the verdict is then the one on the side of the plane where the terms of the whole list
/// have one argument. Heuristic. Throws error of the kind range where the scalar does not hold a coefficient in the
/// unit of the list.
radius_answers answers_of(const listed_function& function, const scalar_spec& scalar);

/// An answer in decimals, each number with the digits that its uncertainty supports and no more than asked; what there
/// is none of is empty. The uncertainty is that of the radius as printed: where the digits asked cut it off, with a
/// unit of its last place.
struct printed_estimate {
    std::string radius, uncertainty, position_re, position_im, exponent, exponent_uncertainty;
};

printed_estimate printed(const radius_estimate<mpfr>& estimate, long digits);

/// Which of several verdicts, one at least, is that of all: the nearest, or the most certain of those that agree with
/// it.
std::size_t nearest_of(const std::vector<radius_answers>& all);

}  // namespace libration::convergence
