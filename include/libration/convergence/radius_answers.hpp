// The radius of convergence of functions from lists of their coefficients, in a scalar chosen at run time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/convergence/coefficient_pattern.hpp"
#include "libration/convergence/radius_estimate.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/dispatch.hpp"
#include "libration/series/power_series.hpp"

namespace libration::convergence {

/// Coefficients a_0 .. a_N to analyse. The accuracy of coefficients read from text follows from their notation, and
/// they may end in a noise floor; all others are correct to the digits of the scalar.
struct listed_series {
    series::power_series<mpfr> coefficients;
    std::vector<exact> written = {};
};

/// The list of a function, or those of its real and its imaginary part, in powers of the root-th root of its variable.
struct listed_function {
    std::vector<listed_series> parts;
    int root = 1;
};

/// The results of all tests, the verdict first, in the unit of the list.
struct radius_answers {
    coefficient_pattern pattern;
    std::string floor;  ///< description of the noise floor; empty if there is none
    std::vector<radius_estimate<mpfr>> rows;
};

/// The radius is computed with this many digits more than are printed.
inline constexpr long radius_guard_digits = 20;

/// The results for a function, computed in a rounding scalar: for its list, or for the one of its two parts that has
/// the nearer singularity. The position in the verdict is then the one in the half-plane where the terms of the whole
/// list have the same argument. Heuristic. Throws error of the kind range if the scalar cannot represent a coefficient
/// in the unit of the list.
radius_answers answers_of(const listed_function& function, const scalar_spec& scalar);

/// Whether the verdict has this kind without the last coefficient, without the last two, and from the first four fifths
/// of them, too. No kind there is another one than a pole: the coefficients of a pole with weak logarithms (a psi series)
/// fit those of a pole up to some order.
bool keeps_kind(const listed_function& function, const scalar_spec& scalar, singularity_kind kind);

/// An estimate in decimals, each number with the digits that its uncertainty supports and no more than requested;
/// missing values are empty. The uncertainty is that of the radius as printed: if the requested digits truncate it,
/// with a unit of its last place.
struct printed_estimate {
    std::string radius, uncertainty, position_re, position_im, exponent, exponent_uncertainty;
};

printed_estimate printed(const radius_estimate<mpfr>& estimate, long digits);

/// The index of the overall verdict among several, at least one: the nearest, or the most certain of those that agree
/// with it.
std::size_t nearest_of(const std::vector<radius_answers>& all);

}  // namespace libration::convergence
