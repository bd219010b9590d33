#include "libration/pendulum/given_motion.hpp"

#include "libration/pendulum/motion/typed_motion.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/given_number.hpp"

namespace libration::pendulum {

namespace {

void refuse_both(const char* one, const std::string& value, const char* other) {
    throw error(error_kind::argument, one, value, std::string("comes together with the ") + other);
}

// A number without a unit: a fraction or a formula.
exact pure_number(const std::string& quantity, const std::string& text) {
    exact number = given_number(quantity, text);
    if (!number.is_number()) {
        throw error(error_kind::argument, quantity, text, "has a unit");
    }
    return number;
}

exact positive_number(const std::string& quantity, const std::string& text) {
    exact number = pure_number(quantity, text);
    if (sign_of_exact(number) <= 0) {
        throw error(error_kind::argument, quantity, text, "is not positive");
    }
    return number;
}

exact squared_frequency_of(const given_motion& given) {
    if (given.length.empty() != given.gravity.empty()) {
        throw error(error_kind::argument, given.length.empty() ? "gravity" : "length",
                    given.length.empty() ? given.gravity : given.length,
                    given.length.empty() ? "comes without a length" : "comes without a gravity");
    }
    return given.length.empty() ? exactly(1)
                                : positive_number("gravity", given.gravity) / positive_number("length", given.length);
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

// The energy or the gap.
void read_energy(const given_motion& given, typed_motion& typed) {
    const bool by_gap = !given.gap.empty();
    (by_gap ? typed.gap : typed.energy) = by_gap ? pure_number("gap", given.gap) : pure_number("energy", given.energy);
    if (sign_of_exact(typed.exact_energy()) < 0) {
        throw error(error_kind::argument, by_gap ? "gap" : "energy", by_gap ? given.gap : given.energy,
                    by_gap ? "makes the energy negative" : "is negative");
    }
    typed.direction = direction_of(given);
}

}  // namespace

typed_motion exact_numbers(const given_motion& given) {
    const bool energetic = !given.energy.empty() || !given.gap.empty();
    if (!given.energy.empty() && !given.gap.empty()) {
        refuse_both("gap", given.gap, "energy");
    }
    if (energetic && !given.omega0.empty()) {
        refuse_both("omega0", given.omega0, given.gap.empty() ? "energy" : "gap");
    }
    if (!energetic && (given.theta0.empty() || given.omega0.empty())) {
        throw error(error_kind::argument, "motion", "", "needs an energy, a gap, or theta0 and omega0");
    }
    if (!energetic && !given.direction.empty()) {
        refuse_both("direction", given.direction, "omega0, which includes the sign");
    }
    typed_motion typed;
    typed.squared_frequency = squared_frequency_of(given);
    if (!given.theta0.empty()) {
        typed.theta0 = given_angle("theta0", given.theta0);
    }
    if (energetic) {
        read_energy(given, typed);
    } else {
        typed.omega0 = pure_number("omega0", given.omega0);
    }
    return typed;
}

motion exact_motion(const given_motion& given) { return exact_numbers(given).motion(); }

}  // namespace libration::pendulum
