#include "libration/pendulum/digits_enclosure.hpp"

#include "given_question.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/number/given_number.hpp"
#include "libration/pendulum/point_coefficients.hpp"
#include "libration/pendulum/proved_norm.hpp"
#include "libration/pendulum/proved_states.hpp"

namespace libration::proved {

using namespace pendulum;

namespace {

proved_decimal constant(const pendulum::given_motion& given, motion_constant which, long digits,
                        const std::optional<std::string>& point = {}) {
    const pendulum::motion m = exact_motion(given);
    const auto about = point ? std::optional(exact_point(m, *point, 0)) : std::nullopt;
    return proved_states(m, given_digits(digits)).constants({which}, about).front();
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

proved_decimal period(const pendulum::given_motion& motion, long digits) {
    return constant(motion, motion_constant::period, digits);
}

proved_decimal effective_period(const pendulum::given_motion& motion, long digits) {
    return constant(motion, motion_constant::effective_period, digits);
}

proved_decimal energy(const pendulum::given_motion& motion, long digits) {
    return constant(motion, motion_constant::energy, digits);
}

proved_decimal gap(const pendulum::given_motion& motion, long digits) {
    return constant(motion, motion_constant::gap, digits);
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
    return constant(motion, motion_constant::radius, digits, point);
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
