// Fractions of a unit, and bounds of a number.
#pragma once

#include "libration/scalar/mpfr.hpp"

namespace libration {

/// The unit of an exact number; `expression` if it is not a multiple of a single one of the others.
enum class unit { one, pi, degree, period, expression };

/// lower <= x <= upper.
struct number_bounds {
    mpfr lower;
    mpfr upper;
};

/// A fraction of a unit.
struct plain_number {
    rational coefficient;
    unit measure;
};

}  // namespace libration
