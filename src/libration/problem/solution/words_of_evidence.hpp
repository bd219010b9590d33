// What proves a singularity, in words.
#pragma once

#include <string>

#include "libration/ode/proved/proved_singularity.hpp"

namespace libration {

/// The loop around it, and the zero in regular coordinates if it is proved to be a pole: "y does not return to its
/// value around it".
std::string words_of_evidence(const ode::explicit_system& system, const ode::proved_singularity& proved);

}  // namespace libration
