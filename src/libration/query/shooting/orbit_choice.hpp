// Which conditions and unknowns determine a periodic orbit of a system with integrals, and a first guess of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "orbit_map.hpp"
#include "rounded_flow.hpp"

namespace libration::ode {

/// The conditions, and the unknowns near the orbit, in their order.
struct orbit_guess {
    orbit_conditions conditions;
    std::vector<ball> unknowns;
    double period = 0;
    long settled_bits = 0;  ///< to which they are accurate, not proved; 0: in double precision
};

/// For a system with the integrals of first_integrals_of(): as many conditions are left out as integrals have
/// independent gradients at the initial point, and so many unknowns keep their initial values that the others are
/// determined: the period, if `period` gives it and it varies in the family; components that are 0; then the others, unknowns before their
/// derivatives. Newton's method in
/// double precision, then with so many bits, leads from the closest return to the guess. With a reversal the conditions are those at half the
/// period, if that leads to an orbit. Throws error of the kind undecided, with the closest return, if there is none
/// near, or none within 1.5 times of a given period, and if Newton's method does not converge.
orbit_guess guessed_orbit(const explicit_system& system, const first_order_form& form,
                          const std::vector<first_integral>& integrals, const std::optional<number>& period, long bits);

}  // namespace libration::ode
