// The claims of section II about closed solutions, which claims_of_background() ends with.
#pragma once

#include <vector>

#include "claims/claim.hpp"

namespace libration {

/// (critical), (subcritical), (supercritical), the Jacobi functions' equations, and which motions these reach.
std::vector<claim> claims_of_closed_solutions();

}  // namespace libration
