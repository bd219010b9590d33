// Interface through which a program with FLINT computes the functions that neither MPFR nor C++ provides. The library
// without FLINT calls it, and function/ball_values implements it if FLINT is linked.
#pragma once

#include <array>
#include <vector>

#include "libration/function/range.hpp"
#include "libration/scalar/relative_kind.hpp"

namespace libration::function {

/// Orders are null for functions without one.
struct ball_functions {
    /// An enclosure on an interval at the working precision; std::nullopt if it is not finite.
    range (*bounds)(function_kind f, const rational* order, const number_bounds& x);
    /// The parts of f(re + i im), within 2^-bits of the size of the value. Throws error if it has none.
    std::array<mpfr, 2> (*value)(function_kind f, const rational* order, const std::array<mpfr, 2>& z, long bits);
    /// Coefficients 0 .. count - 1 of the series about z, rounded to these bits.
    std::vector<std::array<mpfr, 2>> (*series)(relative_kind family, int order, const std::array<mpfr, 2>& z, int count,
                                               long bits);
};

/// Installs these functions; they must stay valid.
void use_functions(const ball_functions& of_balls);
/// Throws error in a program without FLINT.
const ball_functions& functions_of_balls(function_kind needed_for);

/// f(x), to slightly more than half a unit in the last of `bits` bits; NaN if it has no value. Throws error for a
/// function that needs FLINT in a program without it.
mpfr rounded_value(function_kind f, const rational* order, const mpfr& x, long bits);

}  // namespace libration::function
