// Unknown parameters and initial values, and periodic orbits: Krawczyk's test proves existence and local uniqueness of
// a solution, and its digits.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/query/states.hpp"
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

/// An approximate inverse of the midpoint: exact numbers, not an enclosure; std::nullopt if it is singular.
std::optional<ball_matrix> inverse_near(const ball_matrix& a);

/// The zero of F near a first guess, `digits` proved digits each: Newton's method in floating-point arithmetic of
/// increasing precision, then Krawczyk's test: with C near the inverse of dF/dx and a box X about x,
///     x - C F(x) + (1 - C F'(X)) (X - x)
/// in the interior of X proves that X contains exactly one zero, which lies in this set. Throws error of the kind
/// undecided if Newton's method does not converge from the guess, if dF/dx is singular, and if the test fails at every
/// precision: the message has the last iterate with the names of the unknowns, and F there.
std::vector<proved_decimal> proved_root(const map_of_unknowns& f, const std::vector<number>& guess, long digits,
                                        const std::vector<std::string>& names = {});

/// The same, with a bound below 10^-digits for an unknown that is not distinguished from 0.
std::vector<known_value> proved_part_of_root(const map_of_unknowns& f, const std::vector<number>& guess, long digits,
                                             const std::vector<std::string>& names = {});

/// The value of an unknown or a lower derivative at a time.
struct point_condition {
    std::string unknown;
    int derivative = 0;
    number time;
    number value;
};

/// Values of parameters, or initial values named as f''(0), that satisfy the same number of conditions, which may
/// contain them, also as times. The values in the system are the initial guess; the rows are in the order of the names.
/// Throws error like proved_root, for a name that is neither, and for conditions at no time. `watch` is the progress
/// callback of each integration.
std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const conditions_at_times& conditions, long digits,
                                            const proof_route& route = {}, const march_watch& watch = {});
/// The same for values at times.
std::vector<proved_decimal> proved_unknowns(const equation_system& system, const std::vector<std::string>& names,
                                            const std::vector<point_condition>& conditions, long digits,
                                            const proof_route& route = {}, const march_watch& watch = {});

/// The unknowns and their lower derivatives on a section, one of them fixed at its initial value, and the period.
struct periodic_orbit {
    std::vector<std::string> names;
    std::vector<proved_decimal> start;
    proved_decimal period;
};

/// The index in names_of_state() of the unknown that is fixed: it changes fastest at the initial point, relative to its
/// size. Throws error for a point of rest.
std::size_t unknown_on_section(const explicit_system& system);

/// The periodic orbit near the initial values of an autonomous system: an unknown is fixed (unknown_on_section), and the period is estimated from the nearest return among the first ones. Throws error like
/// proved_root; for orbits in families, as if there is a first integral, dF/dx is singular.
periodic_orbit proved_periodic_orbit(const explicit_system& system, long digits, const proof_route& route = {},
                                     const march_watch& watch = {});

}  // namespace libration::ode
