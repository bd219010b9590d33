#include "libration/pendulum/motion.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace libration::pendulum {

namespace {

// A number, not a bare fraction of pi or of T.
void require_number(const exact& omega0) {
    if (!omega0.is_number()) {
        throw error(error_kind::argument, error_subject::omega0, omega0.text, "is not a decimal or a fraction");
    }
}

}  // namespace

motion motion::of_energy(const exact& energy, int direction) {
    motion result;
    result.set_energy(energy);
    result.direction_ = direction;
    if (energy.is_zero() || result.gap_.sign == 0) {
        result.theta0_ = exact{};
        result.quarter_ = 0;
        result.omega0_sign_ = energy.is_zero() ? 0 : direction;
        if (!energy.is_zero()) {
            result.set_omega0_squared(exactly(4));
        }
    } else if (result.gap_.sign < 0) {
        result.theta0_ = read_exact("pi");
        result.set_omega0_squared(*result.exact_gap_ * exactly(-2));
        result.omega0_sign_ = direction;
        result.quarter_ = direction;
    } else {
        result.set_omega0_squared(exactly(0));
        result.quarter_ = 1;
    }
    result.finish();
    return result;
}

motion motion::of_energy_from(const exact& energy, const exact& theta0, int direction) {
    motion result;
    result.set_energy(energy);
    result.set_angle(theta0);
    // E - 1 + cos theta0 = omega0^2/2.
    const std::string what = "E - 1 + cos(" + theta0.text + ")";
    const auto cosine = rational_cosine(theta0);
    const bool is_formula = theta0.measure == unit::expression || !energy.is_fraction();
    const exact_real above = as_exact_real(energy) - exact_real(rational(1));
    std::optional<exact_real> half_square;
    if (cosine || is_formula) {
        half_square = above + (cosine ? exact_real(*cosine) : apply(function_kind::cos, as_exact_real(theta0)));
    }
    const proved_sign kinetic = half_square ? sign_of(exactly(*half_square, what), what)
                                            : sign_of_sum_with_cosine(rational(energy.coefficient - 1), theta0, what);
    if (kinetic.sign < 0) {
        throw error(error_kind::argument, error_subject::theta0, theta0.text, "is not reached with this energy");
    }
    result.omega0_sign_ = kinetic.sign * direction;
    result.direction_ = direction;
    if (half_square) {
        result.set_omega0_squared(exactly(*half_square * exact_real(rational(2)), "omega0^2"));
    }
    result.note_condition(kinetic.exponent);
    result.finish();
    return result;
}

motion motion::of_state(const exact& theta0, const exact& omega0, const exact& squared_frequency) {
    require_number(omega0);
    motion result;
    result.squared_frequency_ = squared_frequency;
    result.set_angle(theta0);
    result.omega0_sign_ = sign_of(omega0, "omega0").sign;
    result.direction_ = result.omega0_sign_ < 0 ? -1 : 1;
    const exact_real speed = as_exact_real(omega0);
    result.set_omega0_squared(exactly(speed * speed / as_exact_real(squared_frequency), "omega0^2"));
    const exact kinetic = *result.exact_omega0_squared_ / exactly(2);
    const auto cosine = rational_cosine(theta0);
    if (cosine) {
        result.set_energy(exactly(as_exact_real(kinetic) + exact_real(rational(1 - *cosine)), "E"));
    } else if (kinetic.is_fraction() && theta0.measure != unit::expression) {
        const rational& k = kinetic.coefficient;
        result.gap_ = sign_of_sum_with_cosine(rational(1 - k), theta0, "2 - E");
        const auto minus_energy = sign_of_sum_with_cosine(rational(-1 - k), theta0, "E");
        result.note_condition(minus_energy.exponent);
        result.note_condition(result.gap_.exponent);
    } else {
        result.set_energy_of_start(kinetic);
    }
    result.finish();
    return result;
}

void motion::set_energy(const exact& energy) {
    require_number(energy);
    set_energy_and_gap(energy, exactly(2) - energy);
}

void motion::set_energy_of_start(const exact& kinetic) {
    const exact_real cosine = apply(function_kind::cos, as_exact_real(*theta0_));
    const exact_real k = as_exact_real(kinetic);
    const exact_real one(rational(1));
    set_energy_and_gap(exactly(one - cosine + k, "E"), exactly(one + cosine - k, "2-E"));
}

void motion::set_energy_and_gap(exact energy, exact gap) {
    const proved_sign of_energy = sign_of(energy, "E");
    if (of_energy.sign < 0) {
        throw error(error_kind::argument, error_subject::energy, energy.text, "is a negative energy");
    }
    gap_ = sign_of(gap, "2 - E");
    note_condition(of_energy.exponent);
    note_condition(gap_.exponent);
    if (energy.is_fraction()) {
        energy_ = energy.coefficient;
    }
    exact_energy_ = std::move(energy);
    exact_gap_ = std::move(gap);
}

void motion::set_omega0_squared(exact squared) { exact_omega0_squared_ = std::move(squared); }

void motion::set_angle(const exact& theta0) {
    theta0_ = theta0;
    const winding wound = wind(theta0);
    turns_ = wound.turns;
    rest_ = wound.rest;
    note_condition(rest_.exponent);
    if (turns_ != 0) {
        turn_bits_ = static_cast<long>(msb(integer(abs(turns_)))) + 4;
    }
}

void motion::finish() {
    const bool at_rest = omega0_sign_ == 0;
    if (energy_ && *energy_ == 0) {
        regime_ = pendulum::regime::stable_equilibrium;
    } else if (gap_.sign > 0) {
        regime_ = pendulum::regime::libration;
    } else if (gap_.sign < 0) {
        regime_ = pendulum::regime::rotation;
    } else {
        regime_ = at_rest ? pendulum::regime::unstable_equilibrium : pendulum::regime::separatrix;
    }
    if (!quarter_) {
        place_symmetric_start();
    }
}

void motion::place_symmetric_start() {
    const bool on_top =
        theta0_ && theta0_->is_angle() && denominator(theta0_->in_pi()) == 1 && numerator(theta0_->in_pi()) % 2 != 0;
    if (rest_.sign == 0) {
        quarter_ = regime_ == pendulum::regime::libration && omega0_sign_ < 0 ? 2 : 0;
    } else if (omega0_sign_ == 0 || (on_top && regime_ == pendulum::regime::rotation)) {
        // At a turning point, or rotating through the top: theta - 2 pi turns = direction * 2 am there.
        quarter_ = regime_ == pendulum::regime::rotation ? rest_.sign * direction_ : rest_.sign;
    }
}

}  // namespace libration::pendulum
