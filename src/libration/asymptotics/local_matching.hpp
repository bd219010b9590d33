// The local expansion of a solution at a singular point from its derivatives at a point nearby.
#pragma once

#include <memory>
#include <vector>

#include "libration/asymptotics/fixed_point_terms.hpp"

namespace libration::ode {

/// A working precision in which the balls of a series keep the bits of the demand, by local_operator::bits_lost().
std::unique_ptr<precision_scope> scope_for_series(const local_operator& about, const series_demand& demand);

/// The solution with these y^(d)/d!, d < r, at an ordinary point.
frobenius_series series_about(const linear_equation& of, const complex_ball& centre,
                              const std::vector<complex_ball>& derivatives, const std::vector<complex_ball>& roots,
                              const series_demand& demand);

/// The parts of the solution with the y^(d)/d! by x at x = demand.at: the constants of the local solutions solve a linear system. At a real
/// point those of rational exponents are real.
std::vector<local_part> matched_parts(const fuchsian_point& structure, const local_operator& about,
                                      const std::vector<complex_ball>& derivatives, const series_demand& demand,
                                      bool real);

}  // namespace libration::ode
