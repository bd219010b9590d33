// Enclosures of all solutions of a problem whose initial values and parameters are in intervals.
//
//     auto growth = ode::parse("x' = b*x; x(0) = [0.9, 1.1]; b = [1, 3]");
//     ode::enclosed_solutions(growth, {.spans = {ode::at_time(1)}}).values[0][0].lower;  // 0.9 e or less
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// All numbers from lower to upper, both exact.
struct closed_interval {
    ball lower, upper;
};

/// All times from one to another, or one time, if they are equal.
struct time_span {
    number from, to;
};

inline time_span at_time(const number& time) { return {time, time}; }

/// What is to be enclosed, and at which cost.
struct set_request {
    std::vector<time_span> spans;
    std::size_t most_parts = 64;  ///< of the box of initial values and parameters; at least 1
    long digits = 50;             ///< of the precision, if no interval has a width
};

/// Intervals that contain all solutions.
struct set_enclosures {
    std::vector<std::string> names;  ///< the unknowns and their lower derivatives: x, x', ...
    /// For each span, an interval for each name; empty for a span that not all solutions are proved to reach.
    std::vector<std::vector<closed_interval>> values;
    std::size_t parts = 1;         ///< of the box that were enclosed separately
    long steps = 0;                ///< of all integrations
    std::size_t faces = 0;         ///< of the box from which bounds of monotone values were taken
    std::optional<error> missing;  ///< why a span is empty, of the kind undecided
};

/// For the equations with equation_system::sets: every solution whose initial values and parameters are in these
/// intervals, each of them in its own, exists from the initial point through all spans whose values are not empty, and
/// has its values at all times of a span in the intervals of that span. A system without sets has one solution.
///
/// By theorem V from the box of initial values and parameters, whose unknowns are the parameters too (opened): the set
/// is C [-q, q] + Q [-r, r], C the derivative with respect to the box. The box is divided where a part ends before the
/// last span, and where the parts that determine a bound are wider than their linear image by more than a sixteenth of
/// the range, along the side that contributes most to it. If the derivative of a value with respect to a number of the
/// box has one sign in the whole box (theorem V encloses it), its bounds are those of the solutions from the
/// corresponding face of the box. Bounds are rounded outwards. Neither choice affects a proof.
///
/// Throws error of the kind argument for a singular initial point, an interval with its ends in descending order, an
/// initial point or an exponent that is a set, and like explicit_system.
set_enclosures enclosed_solutions(const equation_system& given, const set_request& asked, const march_watch& watch = {},
                                  const proof_route& route = {});

}  // namespace libration::ode
