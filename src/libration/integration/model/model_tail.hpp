// Theorem T for all solutions of a box.
#pragma once

#include <optional>

#include "model_expansion.hpp"

namespace libration::ode {

/// For a radius near the least radius of convergence that the coefficients suggest, or the largest smaller one that is
/// found.
std::optional<tail_bound> tail_of(const tape& of, const model_expansion& expansion);

}  // namespace libration::ode
