#include "libration/pendulum/proved/digits.hpp"

#include "../given_question.hpp"
#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/pendulum/error/proved/proved_norm.hpp"
#include "libration/pendulum/proved/proved_states.hpp"
#include "libration/pendulum/taylor/point_coefficients.hpp"
#include "libration/scalar/text/given_number.hpp"

namespace libration::proved {

namespace {

// T* times a number of them; 0 for as many as make a period.
proved_decimal quarters(const given_motion& given, int count, long digits) {
    const motion m = exact_motion(given);
    if (at_critical_energy(m.regime())) {
        return {"inf", "0"};
    }
    const int factor = count == 0 ? quarters_per_period(m.regime()) : count;
    return proved_value(given_digits(digits), [&] { return proved_motion(m).effective_period() * factor; });
}

proved_decimal part_of_energy(const motion& m, const std::optional<rational>& exactly, long digits,
                              ball energy_pair<ball>::*part) {
    if (const auto text = short_decimal(exactly, given_digits(digits))) {
        return {*text, "0"};
    }
    return proved_value(digits, [&] { return energies<ball>(m).*part; });
}

}  // namespace

proved_decimal theta(const given_motion& motion, const std::string& time, long digits) {
    const libration::motion m = exact_motion(motion);
    return proved_states(m, given_digits(digits)).theta_at(exact_time(m, time));
}

proved_decimal omega(const given_motion& motion, const std::string& time, long digits) {
    const libration::motion m = exact_motion(motion);
    return proved_states(m, given_digits(digits)).omega_at(exact_time(m, time));
}

proved_decimal period(const given_motion& motion, long digits) { return quarters(motion, 0, digits); }

proved_decimal effective_period(const given_motion& motion, long digits) { return quarters(motion, 1, digits); }

proved_decimal energy(const given_motion& motion, long digits) {
    const libration::motion m = exact_motion(motion);
    return part_of_energy(m, m.energy(), digits, &energy_pair<ball>::energy);
}

proved_decimal gap(const given_motion& motion, long digits) {
    const libration::motion m = exact_motion(motion);
    const auto exactly = m.energy() ? std::optional(rational(2 - *m.energy())) : std::nullopt;
    return part_of_energy(m, exactly, digits, &energy_pair<ball>::gap);
}

proved_decimal coefficient(const given_motion& motion, const std::string& point, long n, long digits) {
    const libration::motion m = exact_motion(motion);
    const expansion_point at = exact_point(m, point, n);
    return proved_decimals(
               given_digits(digits), [&] { return point_coefficients<ball>(m, at, n, n); },
               [&] { return vanishing_at(m, at, n, n); })
        .front();
}

proved_decimal error_norm(const given_motion& motion, arc_method method, int order, long digits) {
    const rational energy = energy_of_norm(exact_motion(motion), order);
    const long below = digits_below(libration::motion::of_energy(energy), order);
    return proved_value(given_digits(digits), [&] {
        const precision_scope wider(working_digits() + below);
        return proved_arc_errors(energy).norm(method, order).value;
    });
}

}  // namespace libration::proved
