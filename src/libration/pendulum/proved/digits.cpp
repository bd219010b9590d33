#include "libration/pendulum/proved/digits.hpp"

#include "../given_question.hpp"
#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/pendulum/error/proved/proved_norm.hpp"
#include "libration/pendulum/proved/proved_states.hpp"
#include "libration/pendulum/taylor/point_coefficients.hpp"
#include "libration/scalar/text/given_number.hpp"

namespace libration::proved {

using namespace pendulum;

namespace {

// A multiple of T*; 0 for the number of them in a period.
proved_decimal quarters(const pendulum::given_motion& given, int count, long digits) {
    const pendulum::motion m = exact_motion(given);
    if (at_critical_energy(m.regime())) {
        return {"inf", "0"};
    }
    const int factor = count == 0 ? quarters_per_period(m.regime()) : count;
    return proved_value(given_digits(digits), [&] { return pendulum::proved_motion(m).effective_period() * factor; });
}

proved_decimal part_of_energy(const pendulum::motion& m, const std::optional<rational>& exactly, long digits,
                              ball pendulum::energy_pair<ball>::*part) {
    if (const auto text = short_decimal(exactly, given_digits(digits))) {
        return {*text, "0"};
    }
    return proved_value(digits, [&] { return energies<ball>(m).*part; });
}

}  // namespace

proved_decimal theta(const pendulum::given_motion& motion, const std::string& time, long digits) {
    const pendulum::motion m = exact_motion(motion);
    return pendulum::proved_states(m, given_digits(digits)).theta_at(exact_time(m, time));
}

proved_decimal omega(const pendulum::given_motion& motion, const std::string& time, long digits) {
    const pendulum::motion m = exact_motion(motion);
    return pendulum::proved_states(m, given_digits(digits)).omega_at(exact_time(m, time));
}

proved_decimal period(const pendulum::given_motion& motion, long digits) { return quarters(motion, 0, digits); }

proved_decimal effective_period(const pendulum::given_motion& motion, long digits) {
    return quarters(motion, 1, digits);
}

proved_decimal energy(const pendulum::given_motion& motion, long digits) {
    const pendulum::motion m = exact_motion(motion);
    return part_of_energy(m, m.energy(), digits, &pendulum::energy_pair<ball>::energy);
}

proved_decimal gap(const pendulum::given_motion& motion, long digits) {
    const pendulum::motion m = exact_motion(motion);
    const auto exactly = m.energy() ? std::optional(rational(2 - *m.energy())) : std::nullopt;
    return part_of_energy(m, exactly, digits, &pendulum::energy_pair<ball>::gap);
}

proved_decimal coefficient(const pendulum::given_motion& motion, const std::string& point, long n, long digits) {
    const pendulum::motion m = exact_motion(motion);
    const pendulum::expansion_point at = exact_point(m, point, n);
    return proved_decimals(
               given_digits(digits), [&] { return point_coefficients<ball>(m, at, n, n); },
               [&] { return vanishing_at(m, at, n, n); })
        .front();
}

proved_decimal radius(const pendulum::given_motion& motion, const std::string& point, long digits) {
    const pendulum::motion m = exact_motion(motion);
    const pendulum::expansion_point at = exact_point(m, point, 0);
    if (at_rest(m.regime())) {
        return {"inf", "0"};
    }
    return proved_value(given_digits(digits), [&] {
        return ball(*radius_about(pendulum::exact_solution<ball>(m), at) * time_unit<ball>(m));
    });
}

proved_decimal error_norm(const pendulum::given_motion& motion, pendulum::arc_method method, int order, long digits) {
    const rational energy = energy_of_norm(exact_motion(motion), order);
    const long below = digits_below(pendulum::motion::of_energy(energy), order);
    return proved_value(given_digits(digits), [&] {
        const precision_scope wider(working_digits() + below);
        return pendulum::proved_arc_errors(libration::exactly(energy)).norm(method, order).value;
    });
}

}  // namespace libration::proved
