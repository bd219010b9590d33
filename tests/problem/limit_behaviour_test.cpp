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

TEST_CASE("conditions without one rate have no exponential approximant", "[problem][proved]") {
    CHECK_THROWS_WITH(behaviour_of("y'' = y^3; y(0) = 1; y(inf) = 0", "y'(0)", "-0.7", 10), Catch::Contains("rate"));
    CHECK_THROWS_WITH(behaviour_of("u'' + u*(1-u)*(u-1/4) + c*u' = 0; u(-inf) = 1; u(inf) = 0", "c", "0.35", 10),
                      Catch::Contains("-inf"));
}

}  // namespace problem_limit_behaviour_test
