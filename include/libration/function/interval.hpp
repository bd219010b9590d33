// Parts of functions on intervals.
#pragma once

#include <algorithm>

#include "libration/function/range.hpp"

namespace libration::function {

/// Throws std::logic_error where MPFR has not rounded as it was asked to.
void require_rounding(bool as_asked);

/// Throws error where exp and its like are beyond the range.
void require_exponent(const number_bounds& x);

/// |x|, for functions that are even.
number_bounds size_of(const number_bounds& x);

/// The least and the largest of an operation at the four corners, between which it is monotone in each operand.
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
