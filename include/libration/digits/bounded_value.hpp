// Correct digits by one run: where a bound of the error is known before, a precision that makes it small enough needs
// no second run to confirm it.
#pragma once

#include <functional>

#include "libration/digits/growing_precision.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// A value computed at the working precision with a bound of its error.
struct bounded_value {
    mpfr value;
    mpfr error;
};

/// Guard digits beyond which a bound that stays too large is not believed to shrink.
inline constexpr long most_bound_digits = 100'000;

/// The value to `digits` digits, right to one unit in the last when it is printed with them: compute() returns it with
/// its a-priori bound at the working precision, digits + lost + 10 to begin with, lost being the decimal digits that
/// the formula is known to lose. So one run does where `lost` is right; where it is too small the bound says so, and
/// the run is repeated. Throws error of the kind undecided where no precision makes the bound small, as for the value
/// 0.
mpfr value_within_bound(long digits, long lost, const std::function<bounded_value()>& compute);

}  // namespace libration
