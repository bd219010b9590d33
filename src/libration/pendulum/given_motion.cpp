#include "libration/pendulum/given_motion.hpp"

#include "libration/pendulum/motion/motion.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/given_number.hpp"

namespace libration::pendulum {

namespace {

void refuse_both(const char* one, const std::string& value, const char* other) {
    throw error(error_kind::argument, one, value, std::string("comes together with the ") + other);
}

rational squared_frequency_of(const given_motion& given) {
    if (given.length.empty() != given.gravity.empty()) {
        throw error(error_kind::argument, given.length.empty() ? "gravity" : "length",
                    given.length.empty() ? given.gravity : given.length,
                    given.length.empty() ? "comes without a length" : "comes without a gravity");
    }
    return given.length.empty()
               ? rational(1)
               : rational(given_positive("gravity", given.gravity) / given_positive("length", given.length));
}

int direction_of(const given_motion& given) {
    if (given.direction.empty() || given.direction == "+") {
        return 1;
    }
    if (given.direction != "-") {
        throw error(error_kind::argument, "direction", given.direction, "is neither + nor -");
    }
    return -1;
}

motion of_energy(const given_motion& given) {
    const bool by_gap = !given.gap.empty();
    const rational energy =
        by_gap ? rational(2 - given_fraction("gap", given.gap)) : given_fraction("energy", given.energy);
    if (energy < 0) {
        throw error(error_kind::argument, by_gap ? "gap" : "energy", by_gap ? given.gap : given.energy,
                    by_gap ? "makes the energy negative" : "is negative");
    }
    const int direction = direction_of(given);
    return given.theta0.empty() ? motion::of_energy(energy, direction)
                                : motion::of_energy_from(energy, given_angle("theta0", given.theta0), direction);
}

}  // namespace

motion exact_motion(const given_motion& given) {
    const bool energetic = !given.energy.empty() || !given.gap.empty();
    if (!given.energy.empty() && !given.gap.empty()) {
        refuse_both("gap", given.gap, "energy");
    }
    if (energetic && !given.omega0.empty()) {
        refuse_both("omega0", given.omega0, given.gap.empty() ? "energy" : "gap");
    }
    const rational squared_frequency = squared_frequency_of(given);
    if (energetic) {
        return of_energy(given).with_squared_frequency(squared_frequency);
    }
    if (given.theta0.empty() || given.omega0.empty()) {
        throw error(error_kind::argument, "motion", "", "needs an energy, a gap, or theta0 and omega0");
    }
    if (!given.direction.empty()) {
        refuse_both("direction", given.direction, "omega0, which has a sign of its own");
    }
    const rational omega0 = given_fraction("omega0", given.omega0);
    return motion::of_state(given_angle("theta0", given.theta0), {omega0, unit::one, given.omega0}, squared_frequency);
}

}  // namespace libration::pendulum
