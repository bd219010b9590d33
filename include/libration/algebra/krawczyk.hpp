// Zeros of functions of several variables: Krawczyk's test proves existence and local uniqueness of a zero, and its
// digits.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/algebra/ball_matrix.hpp"
#include "libration/digits/known_value.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

/// Enclosures of F and dF/dx over a box of x.
struct enclosed_map {
    std::vector<ball> value;
    ball_matrix derivative;
};

/// F over a box with so many bits, its derivative with error_bits. Returns std::nullopt if more bits are needed.
using map_of_unknowns =
    std::function<std::optional<enclosed_map>(const std::vector<ball>& x, long bits, long error_bits)>;

/// The working precision in which first guesses are rounded.
inline constexpr long bits_of_first_iterate = 160;

/// The zero of F near a first guess, the midpoints of balls, `digits` proved digits each: Newton's method in floating-point arithmetic of
/// increasing precision, then Krawczyk's test: with C near the inverse of dF/dx and a box X about x,
///     x - C F(x) + (1 - C F'(X)) (X - x)
/// in the interior of X proves that X contains exactly one zero, which lies in this set. Throws error of the kind
/// undecided if Newton's method does not converge from the guess, if dF/dx is singular, and if the test fails at every
/// precision: the message has the last iterate with the names of the unknowns, and F there.
std::vector<proved_decimal> proved_root(const map_of_unknowns& f, const std::vector<ball>& guess, long digits,
                                        const std::vector<std::string>& names = {});

/// The same, with a bound below 10^-digits for an unknown that is not distinguished from 0. From a guess that is
/// accurate to about settled_bits, Newton's method begins only beyond so many.
std::vector<known_value> proved_part_of_root(const map_of_unknowns& f, const std::vector<ball>& guess, long digits,
                                             const std::vector<std::string>& names = {}, long settled_bits = 0);

}  // namespace libration::ode
