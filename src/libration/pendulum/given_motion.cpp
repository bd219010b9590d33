#include "libration/pendulum/given_motion.hpp"

#include <optional>

#include "libration/pendulum/typed_motion.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

namespace {

void refuse_both(error_subject one, const std::string& value, const char* other) {
    throw error(error_kind::argument, one, value, std::string("comes together with the ") + other);
}

// Why a number cannot be that of a field; empty if it can.
std::string without_unit(const exact& number) { return number.is_number() ? "" : "has a unit"; }
std::string positive(const exact& number) {
    return !number.is_number() ? "has a unit" : sign_of_exact(number) <= 0 ? "is not positive" : "";
}
std::string angle(const exact& number) { return number.has_periods() ? "is a time" : ""; }

// The number of a field, std::nullopt if it is omitted.
std::optional<exact> number_in(error_subject field, const std::string& text, const number_notation& by,
                               std::string (*reason_against)(const exact&)) {
    if (text.empty()) {
        return std::nullopt;
    }
    try {
        const exact number = by.of_programs ? read_typed(text) : read_exact(text);
        const std::string reason = reason_against(number);
        if (!reason.empty()) {
            throw error(error_kind::argument, field, text, reason);
        }
        return by.as_doubles ? nearest_double(number) : number;
    } catch (const error& problem) {
        throw error(problem.kind(), field, text, problem.reason());
    }
}

exact squared_frequency_of(const given_motion& given, const number_notation& by) {
    if (given.length.empty() != given.gravity.empty()) {
        throw error(error_kind::argument, given.length.empty() ? error_subject::gravity : error_subject::length,
                    given.length.empty() ? given.gravity : given.length,
                    given.length.empty() ? "comes without length" : "comes without gravity");
    }
    return given.length.empty() ? exactly(1)
                                : *number_in(error_subject::gravity, given.gravity, by, positive) /
                                      *number_in(error_subject::length, given.length, by, positive);
}

int direction_of(const given_motion& given, const number_notation& by) {
    const std::string& text = given.direction;
    if (text.empty() || text == "+" || (by.of_programs && (text == "1" || text == "+1"))) {
        return 1;
    }
    if (text != "-" && !(by.of_programs && text == "-1")) {
        throw error(error_kind::argument, error_subject::direction, text, "is neither + nor -");
    }
    return -1;
}

void require_energy(const given_motion& given, const typed_motion& typed) {
    const bool by_gap = !given.gap.empty();
    if (sign_of_exact(typed.exact_energy()) < 0) {
        throw error(error_kind::argument, by_gap ? error_subject::gap : error_subject::energy,
                    by_gap ? given.gap : given.energy, by_gap ? "makes the energy negative" : "is negative");
    }
}

}  // namespace

typed_motion typed_numbers(const given_motion& given, const number_notation& by) {
    typed_motion typed;
    typed.squared_frequency = squared_frequency_of(given, by);
    typed.theta0 = number_in(error_subject::theta0, given.theta0, by, angle);
    typed.omega0 = number_in(error_subject::omega0, given.omega0, by, without_unit);
    typed.gap = number_in(error_subject::gap, given.gap, by, without_unit);
    typed.energy = number_in(error_subject::energy, given.energy, by, without_unit);
    typed.direction = direction_of(given, by);
    return typed;
}

typed_motion exact_numbers(const given_motion& given) {
    const bool energetic = !given.energy.empty() || !given.gap.empty();
    if (!given.energy.empty() && !given.gap.empty()) {
        refuse_both(error_subject::gap, given.gap, "energy");
    }
    if (energetic && !given.omega0.empty()) {
        refuse_both(error_subject::omega0, given.omega0, given.gap.empty() ? "energy" : "gap");
    }
    if (!energetic && (given.theta0.empty() || given.omega0.empty())) {
        throw error(error_kind::argument, "motion", "", "needs an energy, a gap, or theta0 and omega0");
    }
    if (!energetic && !given.direction.empty()) {
        refuse_both(error_subject::direction, given.direction, "omega0, which includes the sign");
    }
    typed_motion typed = typed_numbers(given);
    if (energetic) {
        require_energy(given, typed);
    }
    return typed;
}

motion exact_motion(const given_motion& given) { return exact_numbers(given).motion(); }

}  // namespace libration::pendulum
