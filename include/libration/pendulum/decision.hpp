// Exact decisions about the given numbers: signs by outward-rounded comparison at doubling precision, after exact ties
// have been excluded (Niven: cos(q pi) is rational only for q in Z/2 or Z/3; Lindemann: cos of a nonzero rational
// is transcendental). No decision uses a tolerance.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "libration/digits/bounded_value.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::pendulum {

/// A proved sign, with the e of 2^(e-1) <= |value| < 2^(e+1).
struct proved_sign {
    int sign = 0;
    long exponent = exponent_of_zero;
};

/// The sign of a real number known to be nonzero: evaluate() is called with 39, 78, ... digits until its value exceeds
/// twice its error bound. Throws error of the kind undecided when 319488 digits do not decide.
proved_sign decide_sign(const std::function<bounded_value()>& evaluate, const std::string& what);

/// The sign of an exact fraction.
proved_sign sign_of(const rational& q);

/// The sign of an exact number. Throws libration::error of kind undecided, which names `what`, if no precision shows
/// that a formula is nonzero.
proved_sign sign_of(const exact& number, const std::string& what);

/// cos of the angle if it is rational: angles 0 and multiples of pi/2 and pi/3.
std::optional<rational> rational_cosine(const exact& angle);

/// The sign of a + cos(angle): exact if the cosine is rational, proved otherwise.
/// Error: half an ulp of the angle, of the cosine, of a and of the sum, at most 2^-p (|angle| + 2 + 2|a|).
proved_sign sign_of_sum_with_cosine(const rational& a, const exact& angle, const std::string& what);

/// An angle as 2 pi turns + rest with rest in [-pi, pi]: the turns, and the sign and size of the rest.
struct winding {
    integer turns;
    proved_sign rest;
};

/// Turns and rest of an angle; a multiple of pi that is odd has its rest at +pi or -pi. Throws libration::error of kind
/// undecided if no precision distinguishes a formula from a multiple of pi.
winding wind(const exact& angle);

}  // namespace libration::pendulum
