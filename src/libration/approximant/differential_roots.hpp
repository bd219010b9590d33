// The roots of the leading polynomial of a fitted equation, with the exponents there.
#pragma once

#include <vector>

#include "libration/approximant/differential.hpp"

namespace libration {

/// All roots of Q_M with im >= 0 in the annulus, simple ones and, of two or three that are close to each other, those of
/// Q_M' and Q_M'' between them as double and triple ones; by Aberth's iteration in long double and Newton's in 320 bits.
/// What Newton's iteration does not confirm is left out: so a true multiple root is only found as one.
std::vector<differential_root> roots_of_equation(const differential_relation& relation, root_annulus within);

}  // namespace libration
