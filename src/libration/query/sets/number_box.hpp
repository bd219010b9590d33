// Boxes of initial values and parameters: one interval for each number of a problem that is a set.
#pragma once

#include <vector>

#include "libration/expansion/step_pieces.hpp"
#include "libration/query/sets/solution_sets.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

using number_box = std::vector<closed_interval>;

/// Exact.
inline ball middle_of(const closed_interval& of) { return exact_multiple(exact_sum(of.lower, of.upper), 1, -1); }

inline bool has_width(const closed_interval& of) { return exactly_less(of.lower, of.upper); }

/// Half of the width, rounded up.
inline magnitude radius_of(const closed_interval& of) { return magnitude(of.upper - middle_of(of)); }

/// A ball that contains all of its numbers.
inline ball ball_of(const closed_interval& of) { return hull(of.lower, of.upper); }

/// Removes the numbers of an interval that are not in another, which has numbers in common with it.
inline void narrow(closed_interval& to, const closed_interval& by) {
    if (exactly_less(to.lower, by.lower)) to.lower = by.lower;
    if (exactly_less(by.upper, to.upper)) to.upper = by.upper;
}

/// Extends an interval to the numbers of a ball.
inline void extend(closed_interval& to, const ball& by) {
    if (const ball lower = lower_bound(by); exactly_less(lower, to.lower)) to.lower = lower;
    if (const ball upper = upper_bound(by); exactly_less(to.upper, upper)) to.upper = upper;
}
inline void extend(closed_interval& to, const closed_interval& by) {
    if (exactly_less(by.lower, to.lower)) to.lower = by.lower;
    if (exactly_less(to.upper, by.upper)) to.upper = by.upper;
}

}  // namespace libration::ode
