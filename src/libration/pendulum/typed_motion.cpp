#include "libration/pendulum/typed_motion.hpp"

#include <stdexcept>

namespace libration::pendulum {

exact typed_motion::exact_energy() const {
    if (!gap && !energy) {
        throw error(error_kind::argument, "motion", "", "has no energy");
    }
    return gap ? exactly(2) - *gap : *energy;
}

motion typed_motion::motion() const {
    if (by_state()) {
        return pendulum::motion::of_state(*theta0, *omega0, squared_frequency);
    }
    const pendulum::motion of = theta0 ? pendulum::motion::of_energy_from(exact_energy(), *theta0, direction)
                                       : pendulum::motion::of_energy(exact_energy(), direction);
    return of.with_squared_frequency(squared_frequency);
}

typed_motion typed_motion::in_double() const {
    typed_motion rounded = *this;
    for (std::optional<exact>* number : {&rounded.theta0, &rounded.omega0, &rounded.gap, &rounded.energy}) {
        if (*number) {
            *number = nearest_double(**number);
        }
    }
    return rounded;
}

}  // namespace libration::pendulum
