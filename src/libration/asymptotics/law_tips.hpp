// The circle of a law with slits, and its tips.
#pragma once

#include <string>
#include <vector>

#include "law_circle.hpp"
#include "libration/asymptotics/circle_mean.hpp"
#include "libration/plane/algebraic_point.hpp"
#include "libration/plane/balance/movable_point.hpp"

namespace libration::ode {

[[noreturn]] void refuse_law(const std::string& why);
// The largest double that is certainly not above.
double double_below(const ball& x);

// rho between the nearest branch point and the ends of their slits.
double circle_of_slits(const std::vector<algebraic_point>& all, double wanted, bool given);
covering_tip tip_of(const algebraic_point& of);
tip_bound bounds_of_tips(const std::vector<algebraic_point>& all);

// The expansions at the singularities in the circle, whose rho is reduced to their reach unless it was given, and to less than a second
// singularity on one ray or one of another kind than those of theorem D, whose reason is thrown if it is the nearest.
std::vector<movable_point> movable_points_in(const explicit_system& system, const chart_atlas& atlas, std::size_t shown,
                                             law_circle& circle, bool given, const plane_watch& watch);
covering_tip tip_of(const movable_point& of);
tip_bound bounds_of_tips(const std::vector<movable_point>& all);

}  // namespace libration::ode
