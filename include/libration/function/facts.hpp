// The members that describe each function of formulas and equations, used by the files of elementary/ and special/: one
// function per file.
//
// A file NAME.hpp has one struct NAME_function with
//     kind, name              as in function_kind, and the name as typed
//     domain                  the real arguments, as text for the manual
//     form                    whether it is entire, single-valued, or multivalued in the complex plane
//     singular                real points of the domain where it has a value and no power series
//     exact(x)                its value at a number of a single unit, if that is such a number too
//     bounds(x)               an enclosure on an interval, std::nullopt if that is not proved to be in the domain;
//                             throws error if it is outside
//     derivative(x, w)        in any ring with the functions: its differential equation w' = derivative(x, w)
// from which its series, its polynomial form and its proofs follow, and, where a better method exists,
//     value(x)                for scalars that provide the function
//     rounded                 MPFR's function
//     real_ball, complex_ball FLINT's, looked up if FLINT is included
//     kept, next_coefficient  a separate recurrence, with this number of arrays besides the result (series/kernel.hpp)
//     odd                     whether that has an even function in addition to an odd one
//     values_kept, first_kept the coefficients 0 of the first of these arrays
//     companion_of            the function whose first array is this function
//     has_table               whether the series is that of the first of all derivatives f^(j)(x)/j!, j = 0 .. N, each of which
//                             follows from the next one: exact where x passes points at which a formula divides by 0
//     by_division(n, x)       such a formula
//     in_others(x)            a formula in other functions, which is used for series instead
//     without_polynomial_form points with a series where the derivative divides by 0, so that nothing is proved there
// A function of constant order (Bessel's) takes the order as first argument in all of them. list.hpp collects the
// files; one that lacks a member does not compile.
#pragma once

#include <mpfr.h>

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "libration/function/exact_values.hpp"
#include "libration/function/range.hpp"
#include "libration/scalar/traits.hpp"
#include "libration/series/kernel.hpp"

namespace libration::function {

using std::acos, std::asin, std::atan, std::sinh, std::cosh, std::tanh;
using std::exp, std::log, std::sqrt, std::sin, std::cos, std::tan;

/// The continuation of a function to the complex plane.
enum class analytic_form {
    entire,         ///< no singular points
    one_value,      ///< poles
    several_values  ///< branch points
};

/// Points of the domain without a power series, and the reason why an initial point there is rejected.
struct singular_points {
    int count = 0;
    std::array<int, 2> points{};
    const char* reason = "";
};

inline constexpr singular_points no_points{};

/// Series up to n: x and its slope x' are given; result and kept are to be extended.
template <class R>
struct series_arrays {
    const R* x;
    const R* slope;
    R* result;
    std::array<R*, 2> kept;
    series::progression of_x;      ///< the degrees of x
    series::progression of_slope;  ///< and of x'
    series::progression even;      ///< and of even functions of x
};

/// Whether a coefficient is exactly 0.
template <class R>
bool is_zero(const R& x) {
    if constexpr (requires { x.re; }) {
        return is_zero(x.re) && is_zero(x.im);
    } else if constexpr (requires { bool(x == R(0)); }) {
        return x == R(0);
    } else {
        return scalar_traits<R>::binary_exponent(x) == exponent_of_zero;
    }
}

}  // namespace libration::function
