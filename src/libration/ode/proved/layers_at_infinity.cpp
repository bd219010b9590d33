#include "libration/ode/proved/layers_at_infinity.hpp"

#include <cmath>
#include <functional>
#include <string>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/ode/step.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/proved.hpp"
#include "two_sides.hpp"

namespace libration::ode {

namespace {

constexpr int most_secants = 40;

// f'(time) - target by one march.
mpfr missed(const equation_system& system, const std::string& name, const mpfr& value, int time, int target) {
    taylor_march<mpfr> march(explicit_system(with_value(system, name, value)));
    return mpfr(march.advance_to(mpfr(time))[0][1] - target);
}

// The value with f'(T) = target for a T so late that it is the one of infinity, to the working precision.
mpfr shot(const equation_system& given, const std::string& name, int target, const std::function<int(long)>& time) {
    const definition* const guess = given.parameter_of(name);
    if (guess == nullptr) {
        throw error(error_kind::undecided, "problem", "", "has no parameter " + name);
    }
    const number start = with_values(guess->value, given).constant();
    mpfr value = constant_value<mpfr>::of(start);
    const long bits = static_cast<long>(digits<mpfr>());
    mpfr offset = ldexp(mpfr(1), -14);
    for (int at = 4; at <= time(bits); at += at < 8 ? 2 : 4) {
        const mpfr before = value;
        mpfr other = value + offset;
        mpfr of_value = missed(given, name, value, at, target);
        for (int k = 0; k < most_secants; ++k) {
            const mpfr of_other = missed(given, name, other, at, target);
            const mpfr difference = of_other - of_value;
            if (difference == 0) {
                break;
            }
            const mpfr next = other - of_other * (other - value) / difference;
            value = other;
            of_value = of_other;
            other = next;
            if (abs(mpfr(other - value)) <= ldexp(abs(value), static_cast<int>(4 - bits))) {
                break;
            }
        }
        value = other;
        offset = abs(mpfr(value - before)) + ldexp(abs(value), static_cast<int>(8 - bits));  // the next one moves less
        if (mpfr_number_p(handle(value)) == 0) {
            throw error(error_kind::undecided, "problem", "",
                        "is not led to its condition at infinity from this guess");
        }
    }
    return value;
}

template <class Time>
ball proved_shot(const equation_system& given, const std::string& name, int target, const state_test& decided,
                 const ball& least, const Time& time) {
    mpfr middle;
    {
        const precision_scope more(decimal_digits(static_cast<long>(ball::working_bits()) + side_guard_bits));
        middle = shot(given, name, target, time);
    }
    return between(given, name, middle, decided, least);
}

}  // namespace

ball falkner_skan_shear(const equation_system& given) {
    const state_test decided = [](const std::vector<ball>& y) -> std::optional<side> {
        if (certainly_less(ball(1), y[1])) {
            return side::above;
        }
        return certainly_less(y[2], ball(0)) ? std::optional(side::below) : std::nullopt;
    };
    // f'' falls like exp(-t^2/2).
    const auto time = [](long bits) { return 4 + static_cast<int>(std::sqrt(1.4 * static_cast<double>(bits))); };
    return proved_shot(given, "s", 1, decided, ball(-1), time);
}

ball sakiadis_shear(const equation_system& given) {
    const state_test decided = [](const std::vector<ball>& y) -> std::optional<side> {
        if (certainly_less(y[1], ball(0))) {
            return side::below;
        }
        const bool rises = certainly_less(ball(0), y[0]) && certainly_less(abs(y[2]) * 2, y[0] * y[1]);
        return rises ? std::optional(side::above) : std::nullopt;
    };
    // f'' falls like exp(-f(inf) t/2), f(inf) = 1.6.
    const auto time = [](long bits) { return 8 + static_cast<int>(bits * 9 / 10); };
    return proved_shot(given, "G", 0, decided, ball(-2), time);
}

ball epidemic_remainder(const ball& susceptible, const ball& infected, const ball& rho) {
    const ball x = -(susceptible / rho) * exp(-(susceptible + infected) / rho);
    ball w;
    arb_lambertw(w.handle(), x.handle(), 0, ball::working_bits());
    if (!is_finite(w)) {
        throw precision_exhausted("what an epidemic leaves");
    }
    return -rho * w;
}

}  // namespace libration::ode
