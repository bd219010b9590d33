// The conversion of a number to a verdict, and the motions on which claims are measured.
#pragma once

#include <string_view>

#include "claim.hpp"
#include "libration/pendulum/coefficients.hpp"
#include "libration/pendulum/flow.hpp"
#include "libration/series/jet.hpp"

namespace libration::judging {

/// An error below this counts as 0: 50 digits less ten that a measurement may lose.
inline mpfr negligible() { return pow(mpfr(10), -40); }

/// Holds if the error is negligible.
inline finding by_error(const mpfr& error) { return {error < negligible() ? verdict::holds : verdict::fails, error}; }

/// The statement as printed and as corrected: the number is the error of what is printed.
inline finding by_errors(const mpfr& printed, const mpfr& corrected) {
    if (printed < negligible()) {
        return {verdict::holds, printed};
    }
    return {corrected < negligible() ? verdict::corrected : verdict::fails, printed};
}

/// A number that supports or contradicts the statement.
inline finding by_test(bool statement, const mpfr& number) {
    return {statement ? verdict::holds : verdict::fails, number};
}

/// The same with a correction that is also tested.
inline finding by_tests(bool statement, bool correction, const mpfr& number) {
    if (statement) {
        return {verdict::holds, number};
    }
    return {correction ? verdict::corrected : verdict::fails, number};
}

/// A decimal or fraction.
inline rational fraction(std::string_view text) { return read_exact(text).coefficient; }
inline mpfr number(std::string_view text) { return from_rational<mpfr>(fraction(text)); }

/// The canonical motion of an energy, of a gap 2 - E, and any motion by its state.
inline pendulum::motion of_energy(std::string_view energy, int direction = 1) {
    return pendulum::motion::of_energy(fraction(energy), direction);
}
inline pendulum::motion of_gap(std::string_view gap, int direction = 1) {
    return pendulum::motion::of_energy(rational(2 - fraction(gap)), direction);
}
inline pendulum::motion of_state(std::string_view theta0, std::string_view omega0) {
    return pendulum::motion::of_state(read_exact(theta0), read_exact(omega0));
}

/// theta and omega at a real time from those at time 0, by the equation alone.
inline series::jet<mpfr> by_flow(const mpfr& theta0, const mpfr& omega0, const mpfr& time) {
    flow<mpfr> along(theta0, omega0);
    const auto& state = along.advance_to(time);
    return {state.theta.re, state.omega.re};
}

/// The state at the top, from the energy alone: (arccos(1-E), 0), or (pi, direction sqrt(2E-4)).
inline series::jet<mpfr> top_of(const mpfr& energy, int direction = 1) {
    return energy < 2 ? series::jet<mpfr>{acos(1 - energy), mpfr(0)}
                      : series::jet<mpfr>{pi<mpfr>(), sqrt(energy * 2 - 4) * direction};
}

/// a_n scale^n, n = 0 .. N, about any state, by (pendseries) as printed: no symmetry is used.
inline series::power_series<mpfr> printed_series(const series::jet<mpfr>& start, int order, const mpfr& scale) {
    const mpfr half = start.value / 2;
    const mpfr sine = sin(half);
    const mpfr kinetic = start.slope * start.slope / 2;
    const mpfr energy = kinetic + sine * sine * 2;
    const pendulum::taylor_start<mpfr> at{
        {start.value, start.slope, sine, cos(half)}, {energy, 2 - energy}, series::parity::any};
    return taylor_by_sine_cosine(at, order, scale);
}

/// T*.
inline mpfr effective_period_of(std::string_view energy) {
    return effective_period(energy_level_of<mpfr>(of_energy(energy)));
}

}  // namespace libration::judging
