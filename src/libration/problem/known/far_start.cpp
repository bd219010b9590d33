#include "far_start.hpp"

#include <cstddef>
#include <utility>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"

namespace libration::far {

using ode::equation_system;
using ode::explicit_system;
using series::power_series;

mpfr ten_to(long exponent) { return pow(mpfr(10), static_cast<int>(exponent)); }

power_series<mpfr> polynomial(std::vector<mpfr> coefficients) { return power_series<mpfr>(std::move(coefficients)); }

mpfr parameter_of(const equation_system& given, const std::string& name) {
    return ode::constant_value<mpfr>::of(number_with_values(ode::parameter(name), given));
}

mpfr start_of(const explicit_system& system, std::size_t unknown, std::size_t derivative) {
    return ode::constant_value<mpfr>::of(system.starts()[unknown][derivative]);
}

std::vector<mpfr> state_at(const equation_system& given, const mpfr& time) {
    ode::taylor_march<mpfr> march{explicit_system(given)};
    return march.advance_to(time).front();
}

namespace {

equation_system with_parameter(const equation_system& given, const std::string& name, const mpfr& value) {
    return ode::changed(given, name + " = " + to_decimal(value, static_cast<long>(working_digits())));
}

// The value of a parameter for which the condition holds at a distance, from a nearby one, to a relative tolerance.
mpfr meet(const equation_system& given, const std::string& free, const far_condition& condition, const mpfr& distance,
          mpfr value, const mpfr& tolerance) {
    constexpr int most_steps = 40;
    const auto off = [&](const mpfr& x) {
        return condition(state_at(with_parameter(given, free, x), distance), distance);
    };
    mpfr before = value + (abs(value) + 1) * ten_to(-static_cast<long>(working_digits()) / 2);
    mpfr off_before = off(before);
    for (int step = 0; step < most_steps; ++step) {
        const mpfr off_now = off(value);
        if (off_now == off_before) {
            return value;
        }
        const mpfr next = value - off_now * (value - before) / (off_now - off_before);
        before = std::exchange(value, next);
        off_before = off_now;
        if (abs(mpfr(value - before)) <= tolerance * (abs(value) + tolerance)) {
            return value;
        }
    }
    throw error(error_kind::argument, error_subject::start, to_decimal(value, 10),
                "does not reach the asymptotic regime: give a better initial guess of " + free);
}

}  // namespace

found_start reach(const equation_system& given, const std::string& free, const far_condition& condition,
                  const far_condition& little, const mpfr& first, long digits) {
    constexpr int most_stages = 20;
    mpfr value = parameter_of(given, free);
    mpfr distance = first;
    for (int stage = 0; stage < most_stages; ++stage, distance = distance * 3 / 2) {
        value = meet(given, free, condition, distance, value, ten_to(-digits));
        auto state = state_at(with_parameter(given, free, value), distance);
        if (little(state, distance) < ten_to(-digits)) {
            value = meet(given, free, condition, distance, value, ten_to(-2 * digits));
            auto system = with_parameter(given, free, value);
            state = state_at(system, distance);
            return {std::move(system), value, distance, std::move(state)};
        }
    }
    throw error(error_kind::argument, error_subject::start, to_decimal(value, 10),
                "does not reach its asymptotic behaviour");
}

// a/r ln(S/S0) + S0 + rest - S = 0 below a/r: concave and increasing, and negative at S0 e^(-r (S0 + rest)/a), so that
// Newton's method increases to it.
mpfr left_of_epidemic(const mpfr& ratio, const mpfr& s0, const mpfr& rest) {
    mpfr s = s0 * exp(mpfr(-(s0 + rest) / ratio));
    for (;;) {
        mpfr next = s - (ratio * log(mpfr(s / s0)) + s0 + rest - s) / (ratio / s - 1);
        if (!(next > s) || next - s <= s * epsilon<mpfr>()) {
            return next;
        }
        s = next;
    }
}

}  // namespace libration::far
