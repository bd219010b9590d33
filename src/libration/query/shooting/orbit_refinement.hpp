// First guesses of periodic orbits in more than double precision.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "orbit_choice.hpp"

namespace libration::ode {

/// Newton's method in floating-point arithmetic of so many bits for the unknowns of a guess, with their derivative in double
/// precision, which gains some digits a step. The guess is unchanged if it does not converge.
void refine(orbit_guess& guess, const rounded_flow& flow, const first_order_form& form,
            const std::optional<number>& held_period, const Eigen::MatrixXd& derivative, long bits);

}  // namespace libration::ode
