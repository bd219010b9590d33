// Solutions that decay like a power of the time, compared with closed forms and published digits.
#include "libration/query/connection/connection.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"
#include "query/connection/connected.hpp"

namespace query_connection_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

connection decaying(const std::string& text, const std::string& unknown, long digits) {
    return connected(text, {unknown}, digits);
}

bool has_slope(const connection& of, const ball& number, long digits) {
    return within_a_unit(of.values.at(0), number, digits);
}

}  // namespace

// t*y'/y -> -1 requires t^2 y^2 -> -2.
TEST_CASE("powers of the wrong sign are no decay", "[ode][proved]") {
    CHECK_THROWS_WITH(decaying("y'' = -y^3; y(0) = 1; y(inf) = 0", "y'(0)", 20),
                      Catch::Contains("without a direction of exponential decay"));
    const precision_scope scope(60);
    // t*y'/y -> -2 and t^2 y -> -6 with y < 0.
    CHECK(has_slope(decaying("y'' = -y^2; y(0) = -1; y(inf) = 0", "y'(0)=0.8", 25), sqrt(ball(2) / 3), 25));
}

// y'^2/2 is the integral of the right-hand side from 0 to y.
TEST_CASE("autonomous equations whose solutions decay like a power", "[ode][proved]") {
    const precision_scope scope(60);
    CHECK(has_slope(decaying("y'' = y^3; y(0) = 1; y(inf) = 0", "y'(0)", 40), -sqrt(ball(1) / 2), 40));
    CHECK(has_slope(decaying("y'' = y^2; y(0) = 1; y(inf) = 0", "y'(0)=-0.8", 30), -sqrt(ball(2) / 3), 30));
    CHECK(
        has_slope(decaying("y'' = y^2 + y^3; y(0) = 1; y(inf) = 0; y'(inf) = 0", "y'(0)", 25), -sqrt(ball(7) / 6), 25));
    CHECK(has_slope(decaying("y'' = 2*y^3 - y^4; y(2) = 1; y(inf) = 0", "y'(2)=-0.8", 25), -sqrt(ball(3) / 5), 25));
    CHECK(has_slope(decaying("y'' = 5*y^(5/2); y(0) = 4; y(inf) = 0", "y'(0)=-20", 25), -sqrt(ball(2560) / 7), 25));
    CHECK(has_slope(decaying("y'' = y^3; y(0) = -1/2; y(inf) = 0", "y'(0)=0.2", 25), sqrt(ball(1) / 32), 25));
    CHECK(has_slope(decaying("y'' = c*y^2; y(0) = 1; y'(0) = -1; y(inf) = 0", "c=1.4", 25), ball(3) / 2, 25));
    CHECK(has_slope(decaying("y'' = z*y^2; y(0) = 1; y'(0) = -2; y(inf) = 0", "z=5", 25), ball(6), 25));
}

// A t^-m is itself a solution: its state in log t is the equilibrium.
TEST_CASE("solutions that are powers of the time", "[ode][proved]") {
    const precision_scope scope(60);
    CHECK(has_slope(decaying("y'' = y^(3/2)/sqrt(t); y(1) = 144; y(inf) = 0", "y'(1)=-430", 25), ball(-432), 25));
    CHECK(has_slope(decaying("y'' = 2*y^3; y(1) = 1; y(inf) = 0", "y'(1)", 25), ball(-1), 25));
    CHECK(has_slope(decaying("y'' + y'/t = 4*y^2/t; y(2) = 1/8; y(inf) = 0", "y'(2)=-0.06", 25), ball(-1) / 16, 25));
}

// Thomas-Fermi: -1.5880710226113753127186845094239501 [Boyd2013; Amore2014]. With t = L s and y = a u, L^(3/2) c a^(1/2) = 1, other factors.
TEST_CASE("the neutral atom in any scaling", "[ode][proved]") {
    const precision_scope scope(60);
    mpfr published;
    mpfr_set_str(handle(published), "-1.588071022611375312718684509423950109453", 10, MPFR_RNDN);
    const ball slope(published);
    const connection atom = decaying("y'' = y^(3/2)/sqrt(t); y(0) = 1; y(inf) = 0", "y'(0)", 35);
    CHECK(has_slope(atom, slope, 35));
    CHECK(atom.proved.find("no other positive solution") != std::string::npos);
    const connection scaled = decaying("x'' = 8*x^(3/2)/sqrt(t); x(0) = 4; x(inf) = 0", "x'(0)=-40", 25);
    CHECK(has_slope(scaled, slope * 4 * pow(ball(256), ball(1) / 3), 25));
}

// For y'' = 2 y^3 - y^4 the difference of two solutions need not increase.
TEST_CASE("uniqueness among positive solutions is claimed for increasing right-hand sides alone", "[ode][proved]") {
    const auto claims = [](const std::string& text, const std::string& unknown) {
        return decaying(text, unknown, 10).proved.find("no other positive solution") != std::string::npos;
    };
    CHECK(claims("y'' = 2*y^3 + y^4; y(0) = 1; y(inf) = 0", "y'(0)=-1.2"));
    CHECK_FALSE(claims("y'' = 2*y^3 - y^4; y(0) = 1; y(inf) = 0", "y'(0)=-0.8"));
    CHECK_FALSE(claims("y'' = 2*y^3; y'(0) = -1; y(inf) = 0", "y(0)=1.1"));
    CHECK_FALSE(claims("y'' = 2*y^3; y(0) = -1; y(inf) = 0", "y'(0)=0.9"));
}

TEST_CASE("equations without a leading power are refused", "[ode][proved]") {
    CHECK_THROWS_AS(decaying("y'' = y^3*exp(-t); y(0) = 1; y(inf) = 0", "y'(0)=-1", 20), error);
    CHECK_THROWS_AS(decaying("y'' + 2*y'/t = y^3; y(1) = 1; y(inf) = 0", "y'(1)=-1", 20), error);  // logarithms
    CHECK_THROWS_AS(decaying("y'' = y^2/t^(3/2); y(0) = 1; y(inf) = 0", "y'(0)=-1", 20), error);   // t^(-3/2) at 0
    // Also for y(1) of both signs: sqrt(y) has no value for y < 0.
    CHECK_THROWS_AS(decaying("y'' = y^(3/2)/sqrt(t); y(1) = -1; y(inf) = 0", "y'(1)=1", 20), error);
}

}  // namespace query_connection_test
