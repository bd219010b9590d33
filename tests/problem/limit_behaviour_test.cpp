// Asymptotic approximants by behaviours that conditions at infinity prove.
#include "libration/problem/limit_behaviour.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/scalar/error.hpp"

namespace problem_limit_behaviour_test {

using namespace libration;

namespace {

far_behaviour behaviour_of(const std::string& text, const std::string& unknown, const std::string& guess, long digits) {
    const auto separated = ode::with_limits_separated(text);
    return behaviour_at_infinity({problem(ode::changed(ode::parse(separated.problem), unknown + " = " + guess)),
                                  {unknown},
                                  separated.limits,
                                  {}},
                                 digits);
}

mpfr value_at(const far_behaviour& far, int order, const mpfr& t) {
    const ode::tape tape = ode::tape::about_start(far.system);
    ode::taylor_expansion<mpfr> expansion(tape, order);
    expansion.about_start();
    return asymptotic_approximant(far, expansion.series_of(far.index())).value()(t);
}

bool near(const mpfr& a, const mpfr& b, const char* within) { return abs(mpfr(a - b)) <= mpfr(within); }

}  // namespace

// Crane's f = 1 - exp(-t): an exponential approximant is exact. f' = 1 - tanh: y = tanh t has the terms exp(-2 j t).
TEST_CASE("behaviours by theorem W in closed form", "[problem][proved]") {
    const precision_scope scope(60);
    const auto sheet = behaviour_of("f''' + f*f'' - f'^2 = 0; f(0) = 0; f'(0) = 1; f'(inf) = 0", "f''(0)", "-0.9", 20);
    CHECK(sheet.form == far_form::exponential);
    CHECK(near(sheet.rate, mpfr(1), "1e-40"));
    CHECK(near(sheet.line[0], mpfr(1), "1e-40"));
    CHECK(near(value_at(sheet, 4, mpfr(3)), mpfr(1 - exp(mpfr(-3))), "1e-40"));
    const auto kink = behaviour_of("u'' = 2*u*(u^2-1); u(0) = 0; u(inf) = 1", "u'(0)", "0.9", 20);
    CHECK(near(kink.rate, mpfr(2), "1e-40"));
    // With z = 1 - exp(-2 t), tanh t = z/(2 - z): the last coefficient takes the rest of a geometric series of ratio 1/2.
    CHECK(near(value_at(kink, 30, mpfr(1)), mpfr(tanh(mpfr(1))), "1e-10"));
}

// The catalogue has them by equations of their own.
TEST_CASE("behaviours of catalogue problems come out of their conditions", "[problem][proved]") {
    const precision_scope scope(60);
    const auto wall = behaviour_of("2*f''' + f*f'' = 0; f(0) = 0; f'(0) = 1; f'(inf) = 0", "f''(0)", "-0.44", 15);
    const auto known = far_behaviour_of("sakiadis",
                                        ode::parse("2*f''' + f*f'' = 0; f(0) = 0; f'(0) = 1; f''(0) = G; G = "
                                                   "-0.443748313368861"),
                                        15);
    CHECK(near(wall.line[0], known.line[0], "1e-14"));
    CHECK(near(wall.rate, known.rate, "1e-14"));
    // f - t -> -1.720787657520502.. [Schlichting: displacement thickness of Blasius's layer, 1.7208].
    const auto plate = behaviour_of("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1", "f''(0)", "0.33", 15);
    CHECK(plate.form == far_form::power);
    CHECK(near(plate.line[0], mpfr("-1.720787657520502"), "1e-14"));
    CHECK(near(plate.line[1], mpfr(1), "1e-40"));
}

// 6/(t + sqrt 6)^2 solves y'' = y^2: the approximant with the exponent -2/N is exact.
TEST_CASE("a decay like a power has the exponent of its leading term", "[problem][proved]") {
    const precision_scope scope(60);
    const auto square = behaviour_of("y'' = y^2; y(0) = 1; y(inf) = 0", "y'(0)", "-0.8", 20);
    CHECK(square.form == far_form::algebraic);
    CHECK(square.rate == 2);
    CHECK(near(value_at(square, 5, mpfr(3)), mpfr(6 / pow(mpfr(3 + sqrt(mpfr(6))), 2)), "1e-40"));
    // Thomas and Fermi's atom in powers of sqrt t: 1 + B t + 4/3 t^(3/2) + 2/5 B t^(5/2) + t^3/3 + 3/70 B^2 t^(7/2) + ..,
    // the next term being 2/15 B t^4 = 2e-17 [Baker's series; B = -1.588071022611375312718684509].
    const auto atom = behaviour_of("y'' = y^(3/2)/sqrt(t); y(0) = 1; y(inf) = 0", "y'(0)", "-1.6", 20);
    CHECK(atom.root == 2);
    CHECK(atom.rate == 3);
    const mpfr b("-1.588071022611375312718684509");
    const mpfr series =
        1 + b * mpfr("1e-4") + mpfr("4e-6") / 3 + b * mpfr("4e-11") + mpfr("1e-12") / 3 + b * b * mpfr("3e-14") / 70;
    CHECK(near(value_at(atom, 12, mpfr("1e-4")), series, "1e-15"));
}

// Ai(1)/Ai(0): 1/Ai has its first pole at t = -2.338, so that N = 60 leaves 2.338^-60 = 7e-23.
TEST_CASE("a linear decay has the form c/(1 + sum A_n t^n)", "[problem][proved]") {
    const precision_scope scope(60);
    const auto airy = behaviour_of("y'' = t*y; y(0) = 1; y(inf) = 0", "y'(0)", "-0.7", 20);
    CHECK(airy.form == far_form::power);
    CHECK(airy.line[0] == 0);
    CHECK(
        near(value_at(airy, 60, mpfr(1)),
             mpfr(mpfr("0.13529241631288141552414742351546630617") / mpfr("0.35502805388781723926006318600418317640")),
             "1e-20"));
}

TEST_CASE("a behaviour has its digits in a scope of fewer", "[problem][proved]") {
    const precision_scope scope(15);
    const auto plate = behaviour_of("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1", "f''(0)", "0.33", 15);
    CHECK(near(plate.line[0], mpfr("-1.720787657520502"), "1e-14"));
}

TEST_CASE("conditions without one rate have no exponential approximant", "[problem][proved]") {
    CHECK_THROWS_WITH(behaviour_of("u'' + 2*u'/t - u + u^3 = 0; u'(0) = 0; u(inf) = 0", "u(0)", "4", 10),
                      Catch::Contains("rate"));
    CHECK_THROWS_WITH(behaviour_of("u'' + u*(1-u)*(u-1/4) + c*u' = 0; u(-inf) = 1; u(inf) = 0", "c", "0.35", 10),
                      Catch::Contains("-inf"));
}

}  // namespace problem_limit_behaviour_test
