// Unknowns that keep their initial values, and the system of the others.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// Unknowns that are constant along every solution with these initial values: the largest set of unknowns with constant
/// initial values, and derivatives 0, whose right-hand sides vanish identically where all of them have these values. The
/// solution of the other equations together with these values then solves the system, and there is no other solution
/// where the right-hand sides are analytic. They are analytic where those of without() are: a set is returned only if
/// each function, power and divisor is constant, or occurs in without() as well.
///
/// starts[k] is the initial value of unknown or lower derivative k, in order. Unknowns in `used` are not returned.
std::set<std::string> constant_unknowns(const explicit_system& of, const std::vector<expression>& starts,
                                        const expression& used);

/// The equations of the other unknowns, with these at their initial values.
explicit_system without(const explicit_system& of, const std::set<std::string>& constant);

}  // namespace libration::ode
