#include "libration/verification/motion_truths.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "../pendulum/given_question.hpp"
#include "libration/pendulum/dimensionless_time.hpp"
#include "libration/pendulum/energy.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::pendulum {

namespace {

// The e of |t| < 2^e.
long exponent_of(const exact& time) {
    const precision_scope scope(20);
    if (time.is_zero()) {
        return 0;
    }
    if (time.measure == unit::expression) {
        return std::max(binary_exponent(from_exact<mpfr>(time.without_periods())),
                        binary_exponent(from_rational<mpfr>(time.periods())) + 3);
    }
    return binary_exponent(from_rational<mpfr>(time.coefficient)) + (time.measure == unit::one ? 0 : 3);
}

// The root of a fraction if it is a fraction.
std::optional<rational> rational_root(const rational& square) {
    if (square < 0) {
        return std::nullopt;
    }
    const rational root(sqrt(numerator(square)), sqrt(denominator(square)));
    return root * root == square ? std::optional(root) : std::nullopt;
}

// omega0 in the units of the motion, if it is a fraction.
std::optional<rational> exact_speed(const typed_motion& typed, const motion& m) {
    if (typed.omega0) {
        return typed.omega0->is_fraction() ? std::optional(typed.omega0->coefficient) : std::nullopt;
    }
    const auto squared = m.omega0_squared();
    if (!squared || !typed.squared_frequency.is_fraction()) {
        return std::nullopt;
    }
    const auto root = rational_root(*squared * typed.squared_frequency.coefficient);
    return root ? std::optional(rational(*root * m.omega0_sign())) : std::nullopt;
}

// theta and omega if those of the start, or of its image half a period later in libration, are fractions.
std::pair<std::optional<rational>, std::optional<rational>> exact_state(const typed_motion& typed, const motion& m,
                                                                        const exact& time) {
    if (!time.only_periods() || (!time.is_zero() && at_critical_energy(m.regime()))) {
        return {};
    }
    std::optional<rational> theta;
    if (m.theta0() && m.theta0()->is_fraction()) {
        theta = m.theta0()->coefficient;
    }
    auto omega = exact_speed(typed, m);
    if (time.is_zero()) {
        return {theta, omega};
    }
    const bool swings = m.regime() == regime::libration;
    const rational halves = time.coefficient * 2;
    if (denominator(halves) != 1 || (!swings && numerator(halves) % 2 != 0)) {
        return {};
    }
    if (numerator(halves) % 2 != 0) {
        theta = theta && m.turns() == 0 ? std::optional(rational(-*theta)) : std::nullopt;
        omega = omega ? std::optional(rational(-*omega)) : std::nullopt;
    }
    return {swings ? theta : std::nullopt, omega};
}

// The largest |theta| of libration, pi beyond; the largest |omega|. At rest 1 and 1 in their units.
std::pair<mpfr, mpfr> scales_of(const motion& m) {
    const precision_scope scope(20);
    const mpfr unit = 1 / time_unit<mpfr>(m);
    if (m.regime() == regime::stable_equilibrium || m.regime() == regime::unstable_equilibrium) {
        return {mpfr(1), unit};
    }
    const mpfr energy = energies<mpfr>(m).energy;
    return {m.regime() == regime::libration ? mpfr(asin(sqrt(mpfr(energy / 2))) * 2) : pi<mpfr>(),
            mpfr(sqrt(mpfr(energy * 2)) * unit)};
}

}  // namespace

motion_truths::motion_truths(typed_motion typed, motion exactly)
    : typed_(std::move(typed)), exactly_(std::move(exactly)) {
    std::tie(theta_scale_, omega_scale_) = scales_of(exactly_);
}

const conditioned_motion& motion_truths::in_precision(long digits) {
    for (const auto& [made_with, made] : by_digits_) {
        if (made_with == digits) {
            return *made;
        }
    }
    by_digits_.emplace_back(digits, std::make_unique<conditioned_motion>(typed_, exactly_));
    return *by_digits_.back().second;
}

row_question motion_truths::at(const exact& time, std::size_t count) {
    require_time(exactly_, time);
    row_question question;
    question.first_digits = [this, time](long places) {
        const long time_exponent = exponent_of(time);
        const long for_truth = places + 20 + decimal_digits(std::max(0L, time_exponent));
        const long for_condition = decimal_digits(conditioned_motion::bits_for(exactly_, time_exponent));
        return (std::max(for_truth, for_condition) + 9) / 10 * 10;
    };
    question.truths = [this, time, count](long digits) {
        const enclosed_state state = in_precision(digits).of().at(time);
        const auto [theta, omega] = exact_state(typed_, exactly_, time);
        std::vector<true_value> truths{{state.theta, theta, ball(theta_scale_)},
                                       {state.omega, omega, ball(omega_scale_)}};
        truths.resize(count);
        return truths;
    };
    question.slopes = [this, time, count](long digits) {
        const enclosed_state state = in_precision(digits).of().at(time);
        const precision_scope scope(digits_of_row_numbers);
        const auto squared_frequency = from_exact<mpfr>(typed_.squared_frequency);
        std::vector<mpfr> slopes{midpoint_of(state.omega), mpfr(-squared_frequency * sin(midpoint_of(state.theta)))};
        slopes.resize(count);
        return slopes;
    };
    question.condition = [this, time](long digits) {
        const conditioned_motion& motion = in_precision(digits);
        const auto condition = motion.at(time, motion.of().at(time));
        return condition ? to_decimal(*condition, 3) : std::string("inf");
    };
    return question;
}

}  // namespace libration::pendulum
