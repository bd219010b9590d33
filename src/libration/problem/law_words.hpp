// The singularities of a law as rows, and the law in words.
#pragma once

#include <string>

#include "libration/asymptotics/coefficient_law.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// law_report::singularities, at the working precision of the constants; the printed law has J up to `terms`, less if its first n would be
/// above 60.
answer singularities_of_law(const ode::coefficient_law& law, const std::string& name, int terms, long digits);

}  // namespace libration
