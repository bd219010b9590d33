// Unknown parameters and starts, and periodic orbits: one test of Krawczyk proves that a solution exists, is alone near
// there, and its digits.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/equation_system.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/text/printed_number.hpp"

namespace libration::ode {

/// F and dF/dx over a box of x, enclosed.
struct enclosed_map {
    std::vector<ball> value;
    ball_matrix derivative;
};

/// F over a box in so many bits, its derivative in error_bits. Nothing where more bits are needed.
using map_of_unknowns =
    std::function<std::optional<enclosed_map>(const std::vector<ball>& x, long bits, long error_bits)>;

/// The zero of F near a first guess, `digits` proved digits each: Newton's method in floating arithmetic of growing
/// precision, then the test of Krawczyk: with C near the inverse of dF/dx and a box X about x,
///     x - C F(x) + (1 - C F'(X)) (X - x)
/// in the interior of X proves exactly one zero in X, and holds it. Throws error of the kind undecided where Newton's
/// method does not settle from there, where dF/dx is singular, and where the test fails at every precision.
std::vector<proved_decimal> proved_root(const map_of_unknowns& f, const std::vector<number>& guess, long digits);

/// An unknown or a lower derivative of it at a time.
struct point_condition {
    std::string unknown;
    int derivative = 0;
    number time;
    number value;
};

/// Values of parameters, or of starts, named as f''(0), for which conditions hold: as many of both. The values in the
/// system are the first guess; the rows are in the order of the names. Throws error as proved_root, and for a name that
/// is neither.
std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const std::vector<point_condition>& conditions, long digits,
                                            const proof_route& route = {});

/// The unknowns and their lower derivatives on a section, one of them fixed at its start, and the period.
struct periodic_orbit {
    std::vector<std::string> names;
    std::vector<proved_decimal> start;
    proved_decimal period;
};

/// The periodic orbit near the start of an autonomous system: the unknown that changes fastest there, relative to its
/// size, is held, the period is guessed from the nearest return among the first ones. Throws error as proved_root; for
/// orbits in families, as where a first integral exists, dF/dx is singular.
periodic_orbit proved_periodic_orbit(const explicit_system& system, long digits, const proof_route& route = {});

}  // namespace libration::ode
