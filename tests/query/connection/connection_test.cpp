// Solutions with limits at infinity compared with closed forms, and with published digits.
#include "libration/query/connection/connection.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"
#include "query/connection/connected.hpp"

namespace query_connection_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

// Of connection::more.
proved_decimal number_named(const connection& of, const std::string& name) {
    for (const connection_number& each : of.more) {
        if (each.name == name) {
            return each.value;
        }
    }
    return {"", ""};
}

}  // namespace

// 2 sqrt 2 exp(-t), -4 exp(-t), and -2 exp(2 t) of tanh(-t) as t -> -inf; H(inf) as above.
TEST_CASE("amplitudes, rates and free limits in closed form", "[ode][proved]") {
    const precision_scope scope(60);
    const auto soliton = connected("y'' = y - y^3; y'(0) = 0; y(inf) = 0", {"y(0)=1.4"}, 25);
    CHECK(within_a_unit(number_named(soliton, "amplitude of y"), sqrt(ball(2)) * 2, 24));
    CHECK(within_a_unit(number_named(soliton, "rate 1"), ball(1), 25));
    const auto pendulum = connected("x'' = -sin(x); x(0) = 0; x(inf) = pi", {"x'(0)"}, 25);
    CHECK(within_a_unit(number_named(pendulum, "amplitude of x"), ball(-4), 23));
    const auto wall = connected("y'' = 2*y*(y^2 - 1); y(3) = 0; y(-inf) = 1", {"y'(3)=-0.9"}, 25);
    CHECK(within_a_unit(number_named(wall, "amplitude of y"), exp(ball(-6)) * -2, 23));
    CHECK(within_a_unit(number_named(wall, "rate 1"), ball(2), 25));
    // f = 1 - exp(-t) from a wall that is stretched.
    const auto crane = connected("f''' + f*f'' - f'^2 = 0; f(0) = 0; f'(0) = 1; f'(inf) = 0", {"f''(0)=-0.9"}, 25);
    CHECK(within_a_unit(number_named(crane, "f(inf)"), ball(1), 25));
    CHECK(within_a_unit(number_named(crane, "amplitude of f'"), ball(1), 23));
}

TEST_CASE("solutions that decay to an equilibrium in closed form", "[ode][proved]") {
    const precision_scope scope(80);
    const auto soliton = connected("y'' = y - y^3; y'(0) = 0; y(inf) = 0", {"y(0)=1.4"}, 40);
    CHECK(within_a_unit(soliton.values[0], sqrt(ball(2)), 40));
    // y = 3/2 sech^2(t/2), with an integer coefficient as a parameter of the equation.
    const auto square = connected("y'' = y - k*y^2; k = 1; y'(0) = 0; y(inf) = 0", {"y(0)=1.4"}, 30);
    CHECK(within_a_unit(square.values[0], ball(3) / 2, 30));
    // The parameter: 3/(2 k) = 1.
    const auto factor = connected("y'' = y - k*y^2; k = 1; y(0) = 1; y'(0) = 0; y(inf) = 0", {"k=1.4"}, 30);
    CHECK(within_a_unit(factor.values[0], ball(3) / 2, 30));
    const auto pendulum = connected("x'' = -sin(x); x(0) = 0; x(inf) = pi", {"x'(0)"}, 40);
    CHECK(within_a_unit(pendulum.values[0], ball(2), 40));
    // As t -> -inf: y = tanh(-t).
    const auto wall = connected("y'' = 2*y*(y^2 - 1); y(0) = 0; y(-inf) = 1", {"y'(0)=-0.9"}, 30);
    CHECK(within_a_unit(wall.values[0], ball(-1), 30));
}

TEST_CASE("layers with lines of equilibria, and with an unknown that grows", "[ode][proved]") {
    const precision_scope scope(80);
    // f = 1 + (1 - exp(-l t))/l, l^2 - l - 3 = 0.
    const auto crane =
        connected("f''' + f*f'' - f'^2 - 2*f' = 0; f(0) = 1; f'(0) = 1; f'(inf) = 0", {"f''(0)=-1.9"}, 30);
    CHECK(within_a_unit(crane.values[0], -(ball(1) + sqrt(ball(13))) / 2, 30));
    const auto sink = connected("f''' + 1 - f'^2 = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1", {"f''(0)=1.2"}, 30);
    CHECK(within_a_unit(sink.values[0], ball(2) / sqrt(ball(3)), 30));
    // [INFINITY, Sakiadis: prototypes/infinity]
    const auto sakiadis = connected("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 1; f'(inf) = 0", {"f''(0)"}, 30);
    CHECK(sakiadis.values[0].text == "-0.443748313368861051119832843850");
}

// y = sqrt 2 sech t has the rate 1, as w = -3 y; w = t y' + y solves the last one, with a Jordan block: w'' - w has the term 2 y.
TEST_CASE("equal rates in closed form", "[ode][proved]") {
    const precision_scope scope(60);
    const std::string soliton = "y'' = y - y^3; y'(0) = 0; w'(0) = 0; y(inf) = 0; w(inf) = 0; w'' = w + ";
    const auto equal = connected(soliton + "3*y^3", {"y(0)=1.4", "w(0)=-4"}, 20);
    CHECK(within_a_unit(equal.values[0], sqrt(ball(2)), 20));
    CHECK(within_a_unit(equal.values[1], sqrt(ball(2)) * -3, 20));
    const auto driven = connected(soliton + "2*y - 3*y^2*w", {"y(0)=1.4", "w(0)=1.4"}, 20);
    CHECK(within_a_unit(driven.values[0], sqrt(ball(2)), 20));
    CHECK(within_a_unit(driven.values[1], sqrt(ball(2)), 20));
}

// T = 1 - f' for the factor 1; other factors from tests/reference/carried_heat.py.
TEST_CASE("heat carried by a boundary layer", "[ode][proved]") {
    const auto heat = [](const std::string& factor) {
        return connected(
            "f''' + f*f'' = 0; T'' + " + factor + "*f*T' = 0; f(0) = 0; f'(0) = 0; T(0) = 1; T(inf) = 0; f'(inf) = 1",
            {"f''(0)", "T'(0)=-1"}, 24);
    };
    CHECK(heat("1").values[1].text == "-0.469599988361013304509334");
    CHECK(heat("(1/10)").values[1].text == "-0.198031477583237237433707");
    CHECK(heat("(7/10)").values[1].text == "-0.413912340273245044140562");
    CHECK(heat("1").values[0].text == "0.469599988361013304509334");
    // With the flux given: T(0) = 3 + 2/0.4695.., in the other order of the unknowns.
    const precision_scope scope(60);
    const auto wall =
        connected("f''' + f*f'' = 0; T'' + f*T' = 0; f(0) = 0; f'(0) = 0; T'(0) = -2; T(inf) = 3; f'(inf) = 1",
                  {"T(0)=1", "f''(0)"}, 20);
    CHECK(
        within_a_unit(wall.values[0], ball(3) + ball(2) / ball(mpfr("0.46959998836101330450933365344758845872")), 20));
    // A quantity that does not decay by itself, and a slope that depends on the unknown.
    CHECK_THROWS_AS(
        connected("f''' + f*f'' = 0; T'' - f*T' = 0; f(0) = 0; f'(0) = 0; T(0) = 1; T(inf) = 0; f'(inf) = 1",
                  {"f''(0)", "T'(0)=-1"}, 20),
        error);
    CHECK_THROWS_AS(connected("f''' + f*f'' = 0; T'' + f*T' = 0; f(0) = 0; f'(0) = 0; T(0) = 1 + T'(0); T'(0) = 1; "
                              "T(inf) = 0; f'(inf) = 1",
                              {"f''(0)", "T'(0)=-1"}, 20),
                    error);
}

TEST_CASE("von Karman's swirling flow, with two equal rates", "[ode][proved]") {
    // [INFINITY: 45 digits of another program, prototypes/infinity/karman.py]
    const auto disk = connected(
        "F'' = F^2 - G^2 + F'*H; G'' = 2*F*G + H*G'; H' = -2*F; F(0) = 0; G(0) = 1; H(0) = 0; F(inf) = 0; G(inf) = 0",
        {"F'(0)=0.5", "G'(0)=-0.6"}, 20);
    CHECK(disk.values[0].text == "0.51023261886728488440");
    CHECK(disk.values[1].text == "-0.61592201439935396635");
    CHECK(number_named(disk, "H(inf)").text == "-0.88447411020960242345");
    CHECK(number_named(disk, "rate 2").text == "0.88447411020960242345");
    CHECK(number_named(disk, "amplitude of F").text.empty());  // of two equal rates
}

TEST_CASE("two unknowns, and a pair of complex eigenvalues", "[ode][proved]") {
    const precision_scope scope(60);
    const auto kawahara = connected("u'''' = u'' + u^2/2 - 36*u/169; u'(0) = 0; u'''(0) = 0; u(inf) = 0",
                                    {"u(0)=0.62", "u''(0)=-0.05"}, 25);
    CHECK(within_a_unit(kawahara.values[0], ball(105) / 169, 25));
    CHECK(within_a_unit(kawahara.values[1], ball(-105) / 2197, 25));
    // The first integral u' u''' - u''^2/2 + u'^2/4 + u^2/2 - u^3/3 is 0: u''(0)^2 = u(0)^2 - 2 u(0)^3/3.
    const auto pair =
        connected("u'''' = -u''/2 - u + u^2; u'(0) = 0; u'''(0) = 0; u(inf) = 0", {"u(0)=1.2", "u''(0)=-0.5"}, 24);
    mpfr value;
    mpfr_set_str(handle(value), pair.values[0].text.c_str(), 10, MPFR_RNDN);
    const ball u(value);
    CHECK(within_a_unit(pair.values[1], -sqrt(u * u - u * u * u * 2 / 3), 22));
    CHECK(pair.values[0].text.starts_with("1.24524778089918173188"));
}

TEST_CASE("orbits between two equilibria", "[ode][proved]") {
    const precision_scope scope(80);
    const auto front = connected("u'' + c*u' + u*(1-u)*(u-1/4) = 0; u(-inf) = 1; u(inf) = 0", {"c=0.3"}, 40);
    CHECK(within_a_unit(front.values[0], ball(1) / (sqrt(ball(2)) * 2), 40));
    const auto pushed = connected("u'' + c*u' + u*(1-u)*(1+8*u) = 0; u(-inf) = 1; u(inf) = 0 fast", {"c=2.4"}, 20);
    CHECK(within_a_unit(pushed.values[0], ball(10) / 4, 20));
}

// 13.926557, by others.
TEST_CASE("the homoclinic orbit of Lorenz's equations", "[.long]") {
    const std::string limits = "x(-inf) = 0; y(-inf) = 0; z(-inf) = 0; x(inf) = 0; y(inf) = 0; z(inf) = 0";
    const auto found =
        connected("x' = 10*(y - x); y' = r*x - y - x*z; z' = x*y - 8*z/3; " + limits, {"r=14"}, 15).values.at(0);
    CHECK_THAT(found.text, Catch::StartsWith("13.926557"));
}

TEST_CASE("boundary layers", "[ode][proved]") {
    CHECK(connected("f''' + f*f'' = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1", {"f''(0)"}, 50).values[0].text ==
          "0.46959998836101330450933365344758845872133407845029");
    // f = 2^(1/2) F(..): scaled by f'(inf) = 2 and f f''/2: 0.332057.. 2^(3/2).
    const precision_scope scope(80);
    const auto scaled = connected("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f'(inf) = 2", {"f''(0)"}, 40);
    const auto plain = connected("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1", {"f''(0)"}, 45);
    mpfr value;
    mpfr_set_str(handle(value), plain.values[0].text.c_str(), 10, MPFR_RNDN);
    CHECK(within_a_unit(scaled.values[0], ball(value) * sqrt(ball(8)), 39));
    // [Hartree1937]: 0.3193 and -0.1405 for b = -1/10.
    const std::string hartree = "f''' + f*f'' - (1 - f'^2)/10 = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1";
    CHECK(connected(hartree + " exponentially", {"f''(0)=0.3"}, 38).values[0].text ==
          "0.31926975984254337011894020350357322835");
    CHECK(connected(hartree + " exponentially", {"f''(0)=-0.14"}, 5).values[0].text == "-0.14055");
    // A magnetic field: 2.34666261 by solve_bvp of scipy.
    CHECK(connected("f''' + f*f'' + 1 - f'^2 + 4*(1-f') = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1", {"f''(0)"}, 8)
              .values[0]
              .text == "2.3466626");
    CHECK_THROWS_WITH(connected(hartree, {"f''(0)=0.3"}, 5), Catch::Contains("exponentially"));
    CHECK(
        connected("f''' + f*f'' + (1 - f'^2)/2 = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1", {"f''(0)"}, 38).values[0].text ==
        "0.92768003983665113921912613798407667167");
}

// Von Karman's flow as above; free convection along a wall, 0.6422 and -0.5671 [Ostrach, Pr = 1].
TEST_CASE("swirling flow and free convection without first guesses", "[.long][ode][proved]") {
    const precision_scope scope(60);
    const auto disk =
        connected("F'' = F^2 - G^2 + F'*H; G'' = 2*F*G + H*G'; H' = -2*F; F(0)=0; G(0)=1; H(0)=0; F(inf)=0; G(inf)=0",
                  {"F'(0)", "G'(0)"}, 8);
    CHECK(disk.values[0].text == "0.51023262");
    CHECK(disk.values[1].text == "-0.61592201");
    const auto wall =
        connected("F''' + 3*F*F'' - 2*F'^2 + T = 0; T'' + 3*F*T' = 0; F(0)=0; F'(0)=0; T(0)=1; F'(inf)=0; T(inf)=0",
                  {"F''(0)", "T'(0)"}, 4);
    CHECK(wall.values[0].text == "0.6422");
    CHECK(wall.values[1].text == "-0.5671");
}

// u = 1 - exp(-t) cos t, v = exp(-t) sin t.
TEST_CASE("several unknowns without first guesses", "[ode][proved]") {
    const precision_scope scope(60);
    const auto spiral =
        connected("u'' = -2*v; v'' = 2*(u-1); u(0)=0; v(0)=0; u(inf)=1; v(inf)=0", {"u'(0)", "v'(0)"}, 20);
    CHECK(within_a_unit(spiral.values[0], ball(1), 20));
    CHECK(within_a_unit(spiral.values[1], ball(1), 20));
}

TEST_CASE("limits that are refused, with the reason", "[ode][proved]") {
    const auto refusal = [](const std::string& text, const std::vector<std::string>& unknowns) {
        try {
            connected(text, unknowns, 10);
        } catch (const error& problem) {
            return std::string(problem.what());
        }
        return std::string("no refusal");
    };
    // No equilibrium at 3.14159, nor at 2.
    CHECK_THAT(refusal("x'' = -sin(x); x(0) = 0; x(inf) = 3.14159", {"x'(0)"}), Catch::Contains("limit of a constant"));
    // A stable node: every solution tends there.
    CHECK_THAT(refusal("y'' = -3*y' - 2*y; y(0) = 1; y(inf) = 0", {"y'(0)"}), Catch::Contains("too many"));
    CHECK_THAT(refusal("u'' + c*u' + u*(1-u) = 0; u(-inf) = 1; u(inf) = 0", {"c=3"}), Catch::Contains("too many"));
    CHECK_THAT(refusal("y'' = t*y + 2*y^3; y(0) = 1; y(inf) = 0", {"y'(0)"}),
               Catch::Contains("'t' occurs in the equation"));
    CHECK_THAT(refusal("y'' = sqrt(y); y(0) = 1; y(inf) = 0", {"y'(0)"}),
               Catch::Contains("without a value at these limits"));
    CHECK_THAT(refusal("x' = y; y' = x - x^3 + w; w' = -w*x; y(0) = 0; w(0) = 1; x(inf) = 1", {"x(0)"}),
               Catch::Contains("of w") || Catch::Contains("number that these limits determine"));
}

}  // namespace query_connection_test
