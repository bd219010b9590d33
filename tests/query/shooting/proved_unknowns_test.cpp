// Unknown parameters, initial values and periodic orbits compared with closed forms and published digits.
#include "libration/query/shooting/proved_unknowns.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/known/blasius.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace query_shooting_proved_unknowns_test {

using namespace libration;
using namespace libration::ode;

namespace {

bool within_a_unit(const proved_decimal& printed, const ball& number, long digits) {
    const precision_scope scope(digits + 30);
    mpfr value;
    mpfr_set_str(handle(value), printed.text.c_str(), 10, MPFR_RNDN);
    return certainly_less(abs(ball(value) - number), abs(number) * pow(ball(10), 1 - digits));
}

}  // namespace

// y = k sin t: k = 2/sin 1. And y' = y (1 - y/c), y(0) = s: two unknowns from y(1) = 1/2, y(2) = 1 in closed form:
// u = 1/y solves u' = 1/c - u, u = 1/c + (1/s - 1/c) e^-t.
TEST_CASE("unknown parameters and starts with conditions in closed form", "[ode][proved]") {
    const precision_scope scope(90);
    const auto one = proved_unknowns(parse("y'' = -y; y(0) = 0; y'(0) = k; k = 1"), {"k"},
                                     {{"y", 0, number(rational(1)), number(rational(2))}}, 60);
    CHECK(within_a_unit(one[0], ball(2) / sin(ball(1)), 60));
    const auto start = proved_unknowns(parse("y'' = -y; y(0) = 0; y'(0) = 1"), {"y'(0)"},
                                       {{"y", 1, number(rational(1)), number(rational(2))}}, 60);
    CHECK(within_a_unit(start[0], ball(2) / cos(ball(1)), 60));
    const auto two = proved_unknowns(
        parse("y' = y*(1 - y/c); y(0) = s; c = 2; s = 1/4"), {"c", "s"},
        {{"y", 0, number(rational(1)), number(rational(1, 2))}, {"y", 0, number(rational(2)), number(rational(1))}},
        40);
    // 2 = a + b/e, 1 = a + b/e^2 with a = 1/c, b = 1/s - a.
    const ball e = exp(ball(1));
    const ball b = e * e / (e - 1);
    const ball a = ball(2) - b / e;
    CHECK(within_a_unit(two[0], ball(1) / a, 40));
    CHECK(within_a_unit(two[1], ball(1) / (a + b), 40));
}

// f''' + f f'' - (1 - f'^2)/10 = 0: at 14 the condition f' = 1 gives the digits of f'(inf) = 1, exponentially [INFINITY, section 7]. The
// derivative of the solution changes by a factor 10^30 on the way.
TEST_CASE("a condition beyond a time at which derivatives in few bits have no digits", "[ode][proved]") {
    const auto slope =
        proved_unknowns(parse("f''' + f*f'' - (1 - f'^2)/10 = 0; f(0) = 0; f'(0) = 0; f''(0) = s; s = 0.32"), {"s"},
                        {{"f", 1, number(rational(14)), number(rational(1))}}, 20);
    CHECK(slope[0].text == "0.31926975984254337012");
}

// x = p + (1 - p) e^(p - t) is 1/2 at 2 for p = 0.377..., and for p = 0.356... if the initial point stays at 0.5.
TEST_CASE("an initial point is not an unknown", "[ode][proved]") {
    CHECK_THROWS_WITH(proved_unknowns(parse("x' = -x + p; x(p) = 1; p = 1/2"), {"p"},
                                      {{"x", 0, number(rational(2)), number(rational(1, 2))}}, 10),
                      Catch::Contains("'p' determines the initial point"));
}

TEST_CASE("conditions on both sides of the start", "[ode][proved]") {
    const precision_scope scope(70);
    const auto found = proved_unknowns(
        parse("y'' = y; y(0) = a; y'(0) = b; a = 1; b = 0"), {"a", "b"},
        {{"y", 0, number(rational(-1)), number(rational(0))}, {"y", 0, number(rational(1)), number(rational(3))}}, 40);
    CHECK(within_a_unit(found[0], ball(3) / (cosh(ball(1)) * 2), 40));
    CHECK(within_a_unit(found[1], ball(3) / (sinh(ball(1)) * 2), 40));
}

// OEIS A256522.
TEST_CASE("the shear of the Blasius layer has the published digits", "[ode][proved]") {
    const precision_scope scope(60);
    CHECK(to_proved_decimal(blasius_shear(ball(1)), 32)->text == "0.33205733621519629893718006201058");
}

// D. Viswanath, Physica D 190 (2004) 115-128: the orbit AB of Lorenz's system, z = 27. Van der Pol's cycle: its period
// 6.66328685932313018969968 and amplitude 2.00861986087484313651 of many tables.
TEST_CASE("periodic orbits have the published digits", "[ode][proved]") {
    const auto lorenz =
        proved_periodic_orbit(explicit_system(parse("x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z; "
                                                    "x(0) = -13.7636; y(0) = -19.5788; z(0) = 27")),
                              40);
    CHECK(lorenz.start[0].text.starts_with("-13.76361068213420052501"));
    CHECK(lorenz.start[1].text.starts_with("-19.57875194245179553883"));
    CHECK(lorenz.period.text.starts_with("1.55865221071617472756"));
    const auto van_der_pol =
        proved_periodic_orbit(explicit_system(parse("x'' = (1 - x^2)*x' - x; x(0) = 2; x'(0) = 0")), 30);
    CHECK(van_der_pol.start[0].text.starts_with("2.00861986087484313"));
    CHECK(van_der_pol.period.text.starts_with("6.66328685932313018"));
}

TEST_CASE("Newton's method for a periodic orbit ends when it leaves for another period", "[ode][proved]") {
    CHECK_THROWS_WITH(proved_periodic_orbit(explicit_system(parse("x' = 10*(y - x); y' = x*(28 - z) - y; "
                                                                  "z' = x*y - 8/3*z; x(0) = 1; y(0) = 1; z(0) = 1")),
                                            15),
                      Catch::Contains("left the neighbourhood of the closest return, from the period "));
}

TEST_CASE("a declared invariant that is not conserved does not prevent a periodic orbit", "[ode][proved]") {
    const auto cycle = proved_periodic_orbit(
        explicit_system(parse("x'' = (1 - x^2)*x' - x; x(0) = 2; x'(0) = 0; invariant x + x'")), 15);
    CHECK(cycle.period.text.starts_with("6.6632868593231"));
}

TEST_CASE("orbits in families are refused, and what is not found to return", "[ode][proved]") {
    CHECK_THROWS_WITH(proved_periodic_orbit(explicit_system(parse("x'' = -x*sqrt(1 + x^4); x(0) = 1; x'(0) = 0")), 20),
                      Catch::Contains("periodic orbits come in families") &&
                          Catch::Contains("--unknown \"x(0)\" --such-that \"x'(T) = 0\""));
    CHECK_THROWS_WITH(
        proved_periodic_orbit(
            explicit_system(parse("x' = y; y' = -x*sqrt(1 + x^4); x(0) = 1; y(0) = 0; invariant y^2/2")), 20),
        Catch::Contains("the problem declares that its invariant is conserved"));
    CHECK_THROWS_WITH(proved_periodic_orbit(explicit_system(parse("y' = y^2; y(0) = 1")), 20),
                      Catch::Contains("is proved to exist up to 0.9") &&
                          Catch::Contains("no return to the section through its initial point was found before"));
    CHECK_THROWS_WITH(proved_periodic_orbit(explicit_system(parse("y' = cos(t); y(0) = 1")), 20),
                      Catch::Contains("autonomous"));
}

}  // namespace query_shooting_proved_unknowns_test
