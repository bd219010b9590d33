// Building blocks of functions on intervals.
#pragma once

#include <algorithm>

#include "libration/function/range.hpp"

namespace libration::function {

/// Throws std::logic_error if MPFR has not rounded as requested.
void require_rounding(bool as_asked);

/// Throws error if exp and similar functions are out of range.
void require_exponent(const number_bounds& x);

/// |x|, for even functions.
number_bounds size_of(const number_bounds& x);

/// The minimum and the maximum of an operation over the four corners, between which it is monotone in each operand.
template <class Operation>
number_bounds at_corners(const number_bounds& a, const number_bounds& b, const Operation& operation) {
    number_bounds result;
    bool first = true;
    mpfr low;
    mpfr high;
    for (const mpfr* x : {&a.lower, &a.upper}) {
        for (const mpfr* y : {&b.lower, &b.upper}) {
            operation(handle(low), handle(*x), handle(*y), MPFR_RNDD);
            operation(handle(high), handle(*x), handle(*y), MPFR_RNDU);
            result.lower = first || low < result.lower ? low : result.lower;
            result.upper = first || high > result.upper ? high : result.upper;
            first = false;
        }
    }
    return result;
}

}  // namespace libration::function
