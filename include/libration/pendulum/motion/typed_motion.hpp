// The numbers that give a motion, as typed or as the doubles that another program received.
#pragma once

#include <optional>

#include "libration/pendulum/motion/motion.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/written_number.hpp"

namespace libration {

/// theta0 and omega0; else the gap, else the energy, from the canonical start or from theta0.
struct typed_motion {
    std::optional<exact> theta0;
    std::optional<exact> omega0;
    std::optional<exact> gap;
    std::optional<exact> energy;
    int direction = 1;
    rational stiffness = 1;

    bool by_state() const { return theta0 && omega0; }

    /// E, exactly. Throws error where neither gap nor energy is given.
    rational exact_energy() const {
        if (!gap && !energy) {
            throw error(error_kind::argument, "motion", "", "has no energy");
        }
        return gap ? rational(2 - gap->coefficient) : energy->coefficient;
    }

    /// The motion; throws error as motion does, where an energy is negative or does not reach theta0.
    libration::motion motion() const {
        if (by_state()) {
            return libration::motion::of_state(*theta0, *omega0, stiffness);
        }
        const libration::motion of = theta0 ? libration::motion::of_energy_from(exact_energy(), *theta0, direction)
                                            : libration::motion::of_energy(exact_energy(), direction);
        return of.with_stiffness(stiffness);
    }

    /// With the nearest double in the place of each number.
    typed_motion in_double() const {
        typed_motion rounded = *this;
        for (std::optional<exact>* number : {&rounded.theta0, &rounded.omega0, &rounded.gap, &rounded.energy}) {
            if (*number) {
                *number = nearest_double(**number);
            }
        }
        return rounded;
    }
};

}  // namespace libration
