// The radius of convergence of functions from lists of their coefficients, in a scalar chosen at run time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/convergence/radius_estimate.hpp"
#include "libration/convergence/verdict.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/dispatch.hpp"
#include "libration/series/power_series.hpp"

namespace libration::convergence {

/// Coefficients a_0 .. a_N to analyse. The accuracy of coefficients read from text follows from their notation, and
/// they may end in a noise floor; all others are correct to the digits of the scalar.
struct listed_series {
    series::power_series<mpfr> coefficients;
    std::vector<exact> written = {};
    /// Significant digits to which decimals are rounded, 0 if they are exact; rounding_of() unless given.
    std::optional<long> rounded = std::nullopt;
};

/// The list of a function, or those of its real and its imaginary part, in powers of the root-th root of its variable.
struct listed_function {
    std::vector<listed_series> parts;
    int root = 1;
};

/// The verdict and the results of all tests, in units of the variable. The first row is the verdict.
struct radius_answers {
    list_verdict verdict;
    std::string floor;  ///< description of the noise floor; empty if there is none
    std::vector<radius_estimate<mpfr>> rows;
};

/// The radius is computed with this many digits more than are printed.
inline constexpr long radius_guard_digits = 20;

/// The results for a function whose coefficients are rounded to a scalar: for its list, or for the one of its two parts
/// that has the nearer singularity. The position in the verdict is then the one in the half-plane where the terms of the
/// whole list have the same argument. A list that ends in a noise floor is cut where the coefficients are 16, 256 or 4096
/// times the floor, whichever gives the most certain radius. Heuristic. Throws error of the kind range if the scalar
/// cannot represent a coefficient in the unit of the list.
radius_answers answers_of(const listed_function& function, const scalar_spec& scalar,
                          const task_runner& run = run_in_order);

/// A list from a file as input of a verdict: the numbers as written, with at least bits_for(N) bits.
series_list as_written(const listed_series& list);

/// The verdict as a row above those of the tests; without a radius if that is zero, infinite or not found.
radius_estimate<mpfr> estimate_of(const list_verdict& verdict);

/// The verdict on coefficients a_n, n = 0 .. N, correct to the precision of T.
template <rounding_scalar T>
list_verdict verdict_in(const series::power_series<T>& a, const task_runner& run = run_in_order) {
    series_list list;
    for (const T& value : a.coefficients()) {
        list.values.push_back(widen(value));
    }
    list.noise = widen(epsilon<T>()).template convert_to<double>();
    list.zero = list.noise;
    return verdict_on(list, run);
}

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
