// A motion of the pendulum given as text, exact as written. No other header is needed to specify one.
#pragma once

#include <string>

namespace libration::pendulum {

/// theta0 and omega0; or the energy E, or the gap 2 - E, from the canonical initial state or from theta0. Every number
/// is exact as written: "2.5", "171/100", "1e-30", "3pi/4", "150deg", "2-1e-10", "acos(1/3)". Omitted fields are
/// empty.
struct given_motion {
    std::string theta0 = {};     ///< angle at time 0
    std::string omega0 = {};     ///< angular velocity at time 0
    std::string energy = {};     ///< in units of m g l, from the lowest point
    std::string gap = {};        ///< 2 - energy, for motions next to the separatrix
    std::string direction = {};  ///< "+" or "-": the sign of omega if an energy is given; empty is "+"
    std::string length = {};     ///< in metres, with gravity: times are then in seconds, omega in rad/s
    std::string gravity = {};    ///< in m/s^2
};

class motion;
struct typed_motion;

/// The numbers. Throws error of the kind argument, with the field and its value, for an invalid number, for
/// incompatible fields and for a negative energy.
typed_motion exact_numbers(const given_motion& given);

/// The exact motion. Throws error of the kind argument, with the field and its value, if the motion is invalid.
motion exact_motion(const given_motion& given);

}  // namespace libration::pendulum
