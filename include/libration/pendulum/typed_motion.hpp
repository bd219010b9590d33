// The numbers that define a motion, as given or as the doubles that another program received.
#pragma once

#include <optional>

#include "libration/number/written_number.hpp"
#include "libration/pendulum/motion.hpp"
#include "libration/scalar/error.hpp"

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

struct given_motion;

/// How numbers are written, and in what they are computed.
struct number_notation {
    bool of_programs = false;  ///< also hexadecimal floats, and the directions 1 and -1
    bool as_doubles = false;   ///< the doubles nearest to the numbers, not these themselves
};

/// Each number by itself; together they may contradict each other. Throws error with the field of given_motion and its
/// text for one that cannot be read, and for a length without gravity.
typed_motion typed_numbers(const given_motion& given, const number_notation& by = {});

}  // namespace libration::pendulum
