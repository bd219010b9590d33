#include "libration/problem/known/sakiadis.hpp"

#include <array>
#include <cstddef>
#include <string>

#include "far_start.hpp"
#include "known_problems.hpp"
#include "libration/approximant/exponential_approximant.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/problem/known/sakiadis_shear.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "shooting.hpp"

namespace libration::ode {

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

}  // namespace libration::ode

namespace libration {

namespace {

using ode::equation_system;
using ode::explicit_system;

using pair_of_numbers = std::array<mpfr, 2>;

// The series of f in z = 1 - e^(-C t/2), to z^(known-1).
series::power_series<mpfr> in_decay_of(const ode::equation_system& given, const pair_of_numbers& at, int known) {
    const ode::explicit_system system(
        ode::changed(given, "G = " + to_decimal(at[0], static_cast<long>(working_digits()))));
    const ode::tape tape = ode::tape::about_start(system);
    ode::taylor_expansion<mpfr> expansion(tape, known - 1);
    expansion.about_start();
    return series_in_decay(expansion.series_of(0), mpfr(at[1] / 2));
}

// With n = known - 2 exponentials a polynomial of degree n in z matches the coefficients of f: that of z^(n+1) is 0,
// and it is C at z = 1.
pair_of_numbers off(const ode::equation_system& given, const pair_of_numbers& at, int known) {
    const auto c = in_decay_of(given, at, known);
    mpfr sum = -at[1];
    for (int k = 0; k < known - 1; ++k) {
        sum += c[k];
    }
    return {c[known - 1], sum};
}

pair_of_numbers newton_step(const ode::equation_system& given, const pair_of_numbers& at, int known) {
    const mpfr step = sqrt(epsilon<mpfr>());
    const auto here = off(given, at, known);
    std::array<pair_of_numbers, 2> slope;
    for (std::size_t j = 0; j < 2; ++j) {
        pair_of_numbers beside = at;
        beside[j] += step;
        const auto there = off(given, beside, known);
        slope[j] = {mpfr((there[0] - here[0]) / step), mpfr((there[1] - here[1]) / step)};
    }
    const mpfr determinant = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
    return {mpfr((here[0] * slope[1][1] - here[1] * slope[1][0]) / determinant),
            mpfr((slope[0][0] * here[1] - slope[0][1] * here[0]) / determinant)};
}

far_behaviour far_from_sakiadis(const equation_system& given, long digits) {
    const auto found = far::reach(
        given, "G", [](const std::vector<mpfr>& f, const mpfr& /*t*/) { return f[1]; },
        [](const std::vector<mpfr>& f, const mpfr& /*t*/) { return mpfr(abs(f[2])); }, mpfr(10), digits + 4);
    const mpfr limit = found.state[0];
    return {"sakiadis",
            "f",
            far_form::exponential,
            explicit_system(found.system),
            far::polynomial({limit}),
            mpfr(limit / 2),
            found.distance,
            {{"f''(0)", found.value}, {"f(inf)", limit}}};
}

}  // namespace

sakiadis_prediction predicted_sakiadis(const ode::equation_system& given, int known) {
    constexpr int most_steps = 60;
    if (known < 4) {
        throw error(error_kind::argument, "number of coefficients", std::to_string(known),
                    "leaves fewer conditions than unknowns: give at least 4");
    }
    pair_of_numbers at{mpfr(-mpfr(9) / 20), mpfr(mpfr(8) / 5)};
    for (int step = 0; step < most_steps; ++step) {
        const auto down = newton_step(given, at, known);
        at = {mpfr(at[0] - down[0]), mpfr(at[1] - down[1])};
        if (abs(down[0]) + abs(down[1]) <= sqrt(epsilon<mpfr>()) / 1'000'000) {
            break;
        }
    }
    const auto c = in_decay_of(given, at, known);
    mpfr amplitude(0);
    for (int k = 1; k < known - 1; ++k) {
        amplitude -= c[k] * k;
    }
    return {at[0], at[1], amplitude};
}

known_facts facts_of_sakiadis() {
    return {.problem = "sakiadis",
            .condition = condition_at_infinity{
                .unknowns = {"G"},
                .of = "f'(inf)",
                .limits = "0",
                .holds = [](const std::string& limit) { return ode::parse_constant(limit).constant().sign() == 0; },
                .values =
                    [](const equation_system& system, const std::string&, long digits) {
                        return proved_decimals(digits, [&] { return std::vector{ode::sakiadis_shear(system)}; });
                    }},
            .far = [](const equation_system& given, long digits, const std::string&) {
                return far_from_sakiadis(given, digits);
            }};
}

}  // namespace libration
