// Correct digits from one run: if an error bound is known in advance, a precision that makes it small enough needs no
// second run for confirmation.
#pragma once

#include <functional>

#include "libration/digits/precision_loop.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// A value computed at the working precision with a bound on its error.
struct bounded_value {
    mpfr value;
    mpfr error;
};

/// Number of guard digits at which the search ends if the bound is still too large.
inline constexpr long most_bound_digits = 100'000;

/// The value to `digits` digits, correct to one unit in the last when it is printed with them: compute() returns it
/// with its a-priori bound at the working precision, initially digits + lost + 10, where lost is the number of decimal
/// digits that the formula is known to lose. One run suffices if `lost` is correct; if it is too small, the bound shows
/// this and the run is repeated. Throws error of the kind undecided if no precision makes the bound small, as for the
/// value 0.
mpfr value_within_bound(long digits, long lost, const std::function<bounded_value()>& compute);

}  // namespace libration
