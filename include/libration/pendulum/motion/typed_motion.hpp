// The numbers that define a motion, as given or as the doubles that another program received.
#pragma once

#include <optional>

#include "libration/pendulum/motion/motion.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/written_number.hpp"

namespace libration::pendulum {

/// theta0 and omega0; else the gap, else the energy, from the canonical start or from theta0.
struct typed_motion {
    std::optional<exact> theta0;
    std::optional<exact> omega0;
    std::optional<exact> gap;
    std::optional<exact> energy;
    int direction = 1;
    exact squared_frequency = exactly(1);

    bool by_state() const { return theta0 && omega0; }

    /// E, exactly. Throws error if neither gap nor energy is given.
    exact exact_energy() const;

    /// The motion; throws error as motion does, if an energy is negative or does not reach theta0.
    pendulum::motion motion() const;

    /// With each number replaced by the nearest double.
    typed_motion in_double() const;
};

}  // namespace libration::pendulum
