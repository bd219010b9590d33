// Functions on intervals, rounded outwards by MPFR.
#pragma once

#include <mpfr.h>

#include <optional>

#include "libration/function/function_kind.hpp"
#include "libration/scalar/plain_number.hpp"

namespace libration::function {

/// std::nullopt if an argument is not proved to be in the domain.
using range = std::optional<number_bounds>;
using rounded_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

number_bounds rising(rounded_function f, const number_bounds& x);
number_bounds falling(rounded_function f, const number_bounds& x);
/// An even function that increases with |x|.
number_bounds rising_with_size(rounded_function f, const number_bounds& x);
/// The same as rising() for a function that grows like exp. Throws error if its value is out of range.
number_bounds rising_steeply(rounded_function f, const number_bounds& x);
/// sin and cos: the value at the midpoint, plus or minus the radius of the argument.
number_bounds of_circle(rounded_function f, const number_bounds& x);

/// An end of a domain.
struct domain_end {
    int at;
    bool included;
};

/// x if it is entirely above (below) the end of a domain, std::nullopt if it may be on both sides. Throws error with
/// the text `refusal` if all of it is outside.
range above(domain_end end, const number_bounds& x, const char* refusal);
range below(domain_end end, const number_bounds& x, const char* refusal);

/// A quotient, std::nullopt if the divisor may be 0.
range quotient(const number_bounds& a, const number_bounds& b);

/// By balls: FLINT's function. Throws error in a program without FLINT. Returns std::nullopt if its value is not
/// finite.
range by_balls(function_kind f, const number_bounds& x);
range by_balls(function_kind f, const rational& order, const number_bounds& x);

}  // namespace libration::function
