// Derivatives of solutions by initial values and parameters, against closed forms and identities.
#include "libration/query/flow_derivatives.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/pendulum/motion.hpp"
#include "libration/pendulum/variation.hpp"
#include "libration/scalar/error.hpp"

namespace flow_derivatives_test {

using namespace libration;

namespace {

using numbers = std::vector<std::string>;

std::vector<ode::number> times_of(const numbers& texts) {
    std::vector<ode::number> all;
    for (const std::string& each : texts) {
        all.push_back(ode::parse_constant(each).constant());
    }
    return all;
}

// The derivatives at a single time.
std::vector<std::vector<ode::known_value>> at(const std::string& problem, const std::string& time, const numbers& by,
                                              long digits) {
    const auto found = ode::proved_derivatives(ode::parse(problem), times_of({time}), by, digits);
    REQUIRE_FALSE(found.trajectory.missing);
    return found.by.front();
}

mpfr number_of(const ode::known_value& value) { return mpfr(value.decimal->text); }

// Within one unit of the last of these digits.
void check_near(const ode::known_value& found, const mpfr& exact, long digits) {
    REQUIRE(found.decimal);
    INFO(found.decimal->text << " for " << exact);
    CHECK(abs(mpfr(number_of(found) - exact)) <= abs(exact) * pow(mpfr(10), 1 - digits));
}

// Within one unit of the last digit, and within its own bound, of a value with more digits than the test prints.
void check_digits(const ode::known_value& found, const mpfr& exact, long digits) {
    check_near(found, exact, digits);
    const mpfr distance = abs(mpfr(number_of(found) - exact));
    // The bound has three digits and was rounded up; the exact value here has an error of its own.
    CHECK(distance <= mpfr(found.decimal->uncertainty) + abs(exact) * pow(mpfr(10), -digits - 15));
}

void check_text(const ode::known_value& found, const std::string& text) {
    REQUIRE(found.decimal);
    CHECK(found.decimal->text == text);
}

}  // namespace

// x = exp(A t) x(0): the derivative by the initial values is exp(A t), here a rotation that decays,
// e^(-t/2) (cos t, -sin t; sin t, cos t).
TEST_CASE("derivatives of a linear system are its exponential", "[ode][proved][derivatives]") {
    const precision_scope scope(70);
    for (const std::string time : {"3", "-2"}) {
        const auto by = at("x' = -x/2 - y; y' = x - y/2; x(0) = 1/3; y(0) = 2", time, {"x(0)", "y(0)"}, 40);
        const mpfr t(time);
        const mpfr size = exp(mpfr(-t / 2));
        check_digits(by[0][0], mpfr(size * cos(t)), 40);
        check_digits(by[0][1], mpfr(-size * sin(t)), 40);
        check_digits(by[1][0], mpfr(size * sin(t)), 40);
        check_digits(by[1][1], mpfr(size * cos(t)), 40);
    }
}

// y = c e^(rt)/(1 + c (e^(rt) - 1)): dy/dc = e^(rt)/D^2, dy/dr = c (1 - c) t e^(rt)/D^2, D the denominator.
TEST_CASE("derivatives of the logistic equation", "[ode][proved][derivatives]") {
    const precision_scope scope(80);
    const auto by = at("y' = r*y*(1 - y); y(0) = 1/10; r = 3/2", "4", {"y(0)", "r"}, 50);
    const mpfr grown = exp(mpfr(6));
    const mpfr c = mpfr(1) / 10;
    const mpfr below = 1 + c * (grown - 1);
    check_digits(by[0][0], mpfr(grown / (below * below)), 50);
    check_digits(by[0][1], mpfr(4 * c * (1 - c) * grown / (below * below)), 50);
}

// x'' = -w^2 x from x = p, x' = w p: x = p (cos wt + sin wt). That by p moves both initial values.
TEST_CASE("a derivative by a parameter moves the initial values that contain it", "[ode][proved][derivatives]") {
    const precision_scope scope(60);
    const auto by = at("x'' = -w^2*x; x(0) = p; x'(0) = w*p; p = 3; w = 2", "1", {"p", "w", "x'(0)"}, 30);
    const mpfr c = cos(mpfr(2));
    const mpfr s = sin(mpfr(2));
    check_digits(by[0][0], mpfr(c + s), 30);
    check_digits(by[1][0], mpfr(2 * (c - s)), 30);
    check_digits(by[0][1], mpfr(3 * (c - s)), 30);
    check_digits(by[1][1], mpfr(3 * (c - s) - 6 * (s + c)), 30);
    check_digits(by[0][2], mpfr(s / 2), 30);
    check_digits(by[1][2], c, 30);
}

// By three identities and a closed form. The flow keeps areas: the determinant of its derivative is 1. It carries the
// velocity along: x'(t) = x'(0) dx/dx(0) + x''(0) dx/dx'(0), here x'(0) = 0, x''(0) = -sin 2, and so for x''. And
// dx/dx(0) is the variation of the motion (pendulum/variation.hpp).
TEST_CASE("derivatives of the pendulum", "[ode][proved][derivatives]") {
    const precision_scope scope(60);
    const auto found = ode::proved_derivatives(ode::parse("x'' = -sin(x); x(0) = 2; x'(0) = 0"), times_of({"10"}),
                                               {"x(0)", "x'(0)"}, 30);
    REQUIRE_FALSE(found.trajectory.missing);
    const auto& by = found.by.front();
    // A product of two numbers of 30 digits differs by less than 2 10^-29 of itself, the difference of two by twice it.
    const mpfr first = number_of(by[0][0]) * number_of(by[1][1]);
    const mpfr second = number_of(by[0][1]) * number_of(by[1][0]);
    CHECK(abs(mpfr(first - second - 1)) <= 4 * (abs(first) + abs(second)) * pow(mpfr(10), -29));
    const auto& state = found.trajectory.states.front();
    check_near(by[0][1], mpfr(number_of(state[1]) / -sin(mpfr(2))), 29);
    check_near(by[1][1], mpfr(sin(number_of(state[0])) / sin(mpfr(2))), 29);
    const pendulum::motion m = pendulum::motion::of_state(exactly(2), exactly(0));
    const pendulum::variation<mpfr> v(m);
    check_near(by[0][0], v.by_angle(v.at(mpfr(10), number_of(state[0]), number_of(state[1]))), 28);
}

TEST_CASE("derivatives at the initial point, and by what does not act, are exact", "[ode][proved][derivatives]") {
    const auto start = at("x'' = -k*x; x(1) = 1/3; x'(1) = 0; k = 2", "1", {"x(1)", "x'(1)", "k"}, 20);
    check_text(start[0][0], "1.0000000000000000000");
    check_text(start[0][1], "0");
    check_text(start[0][2], "0");
    const auto apart = at("x' = -x; y' = x*y; x(0) = 1; y(0) = 1", "1", {"y(0)"}, 20);
    check_text(apart[0][0], "0");
    CHECK(apart[1][0].decimal->text != "0");
}

// y' = y^2 p from 0: y is 0 for every p, and dy/dp as well, which is not seen from the dependencies.
TEST_CASE("a derivative that is 0 for another reason has a bound", "[ode][proved][derivatives]") {
    const auto found = ode::proved_derivatives(ode::parse("y' = sin(p)*y^2 + sin(y); y(0) = q; p = 1; q = 0"),
                                               times_of({"1"}), {"p", "q"}, 20);
    const auto& by = found.by.front().front();
    if (!by[0].decimal) {
        REQUIRE(found.trajectory.missing);
        CHECK(mpfr(by[0].bound) < mpfr("1e-20"));
    } else {
        CHECK(by[0].decimal->text == "0");
    }
    const precision_scope scope(50);
    check_digits(by[1], exp(mpfr(1)), 20);
}

// y = 1 + (y(0) - 1) cos t: dy/dy(0) is 0 at pi/2, about 1e-24 next to it, and dy'/dy(0) is -1 there.
TEST_CASE("a derivative that is not told from 0 is missing, and a small one has its digits",
          "[ode][proved][derivatives]") {
    const precision_scope scope(60);
    const std::string problem = "y'' = 1 - y; y(0) = 2; y'(0) = 0";
    const auto found = ode::proved_derivatives(ode::parse(problem), times_of({"pi/2"}), {"y(0)"}, 20);
    REQUIRE(found.trajectory.missing);
    CHECK_THAT(found.trajectory.missing->what(), Catch::Contains("is not distinguished from 0"));
    const auto& by = found.by.front();
    CHECK_FALSE(by[0][0].decimal);
    CHECK(mpfr(by[0][0].bound) < mpfr("1e-20"));
    check_near(by[1][0], mpfr(-1), 20);
    const std::string near = "1.57079632679489661923132";
    check_digits(at(problem, near, {"y(0)"}, 20)[0][0], cos(mpfr(near)), 20);
}

// t y'' + 2 y' + q^2 t y = 0 from y = p: y = p sin(qt)/(qt).
TEST_CASE("derivatives from a singular initial point", "[ode][proved][derivatives]") {
    const precision_scope scope(50);
    const auto by = at("t*y'' + 2*y' + q^2*t*y = 0; y(0) = p; y'(0) = 0; p = 3; q = 2", "1", {"p", "q", "y(0)"}, 20);
    const mpfr s = sin(mpfr(2));
    check_digits(by[0][0], mpfr(s / 2), 20);
    check_digits(by[0][1], mpfr(3 * (2 * cos(mpfr(2)) - s) / 4), 20);
    check_digits(by[0][2], mpfr(s / 2), 20);
}

TEST_CASE("derivatives by what a problem does not have are errors", "[ode][proved][derivatives]") {
    const auto refused = [](const numbers& by, const std::string& reason) {
        const auto system = ode::parse("y' = k*y^n; y(0) = 1; k = 2; n = 2");
        CHECK_THROWS_WITH(ode::proved_derivatives(system, times_of({"1/10"}), by, 10), Catch::Contains(reason));
    };
    refused({"z"}, "derivatives 'z' is neither a parameter nor an initial value");
    refused({"y'(0)"}, "derivatives 'y'(0)' is neither");
    refused({"y(1)"}, "derivatives 'y(1)' is neither");
    refused({"y(0"}, "derivatives 'y(0' is neither");
    refused({"k", "k"}, "derivatives 'k' is given twice");
}

// y = (1 - (n - 1) k t)^(-1/(n - 1)); with u = 1 - k t at n = 2, d log y/dn = log u + k t/u.
TEST_CASE("derivatives by an exponent that is a parameter", "[ode][proved][derivatives]") {
    const precision_scope scope(50);
    const auto by = at("y' = k*y^n; y(0) = 1; k = 2; n = 2", "1/10", {"n", "k"}, 20);
    const mpfr u = mpfr(4) / 5;
    check_digits(by[0][0], mpfr((log(u) + (1 - u) / u) / u), 20);
    check_digits(by[0][1], mpfr(1 / (10 * u * u)), 20);
}

// x = e^(t - t0): a derivative at a fixed initial point would be 0 instead of -2 x.
TEST_CASE("a number that moves the initial point has no derivative", "[ode][proved][derivatives]") {
    const auto system = ode::parse("x' = x; x(t0) = 1; t0 = 2*p; p = 1/2");
    for (const std::string number : {"p", "t0"}) {
        CHECK_THROWS_WITH(ode::proved_derivatives(system, times_of({"2"}), {number}, 10),
                          Catch::Contains("derivatives '" + number + "' determines the initial point"));
    }
}

TEST_CASE("times that are not reached leave the others", "[ode][proved][derivatives]") {
    const precision_scope scope(50);
    const auto found = ode::proved_derivatives(ode::parse("y' = y^2; y(0) = 1"), times_of({"1/2", "2"}), {"y(0)"}, 20);
    // y = c/(1 - c t): dy/dc = 1/(1 - c t)^2 = 4.
    check_digits(found.by[0][0][0], mpfr(4), 20);
    CHECK(found.by[1].empty());
    REQUIRE(found.trajectory.missing);
    CHECK(found.trajectory.missing->reason().find("is not reached") != std::string::npos);
}

// x = exp(b t) with b = 1 + k: dx/dk = dx/db = t x, whichever is asked for.
TEST_CASE("a derivative does not depend on which others are requested", "[ode][proved][derivatives]") {
    const auto by = [](const numbers& of) {
        return ode::proved_derivatives(ode::parse("x' = b*x; x(0) = c; b = 1 + k; k = 1/5; c = 1; d = 2*b"),
                                       times_of({"1"}), of, 10);
    };
    const precision_scope scope(50);
    const mpfr slope = exp(mpfr("1.2"));
    check_digits(by({"k"}).by[0][0][0], slope, 10);
    check_digits(by({"b"}).by[0][0][0], slope, 10);
    check_digits(by({"x(0)", "k", "c"}).by[0][0][1], slope, 10);
    CHECK_THROWS_WITH(by({"k", "b"}), Catch::Contains("derivatives 'b' depends on k"));
    CHECK_THROWS_WITH(by({"b", "k"}), Catch::Contains("derivatives 'b' depends on k"));
    CHECK_THROWS_WITH(by({"k", "d"}), Catch::Contains("derivatives 'd' depends on k"));
}

}  // namespace flow_derivatives_test
