// What a program with FLINT computes those functions by that neither MPFR nor C++ has. The library without FLINT asks
// here, and function/ball/ answers where it is linked and included.
#pragma once

#include <array>

#include "libration/function/range.hpp"

namespace libration::function {

/// Orders are null for functions without one.
struct ball_functions {
    /// An enclosure on an interval at the working precision; nothing where it is not finite.
    range (*bounds)(function_kind f, const rational* order, const number_bounds& x);
    /// The parts of f(re + i im), within 2^-bits of the size of the value. Throws error where it has none.
    std::array<mpfr, 2> (*value)(function_kind f, const rational* order, const std::array<mpfr, 2>& z, long bits);
};

/// From now on these; they have to stay.
void use_functions(const ball_functions& of_balls);
/// Throws error for a program without FLINT.
const ball_functions& functions_of_balls(function_kind needed_for);

/// f(x), within half a unit in the last of so many bits and a little; not a number where it has none. Throws error for a function
/// that needs FLINT in a program without it.
mpfr rounded_value(function_kind f, const rational* order, const mpfr& x, long bits);

}  // namespace libration::function
