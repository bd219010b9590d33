// What proves a singularity, in words.
#pragma once

#include <string>

#include "libration/plane/proved_singularity.hpp"

namespace libration {

/// Why no solution has a singularity (ode::has_entire_solutions).
inline constexpr const char* words_of_entire_solutions =
    "each unknown satisfies a linear equation whose coefficients are entire functions of the variable and of the "
    "unknowns before it";

/// The loop around it, and the zero in regular coordinates if it is proved to be a pole: "y does not return to its
/// value around it".
std::string words_of_evidence(const ode::explicit_system& system, const ode::proved_singularity& proved);

}  // namespace libration
