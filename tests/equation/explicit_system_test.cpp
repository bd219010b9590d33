// Systems solved for their highest derivatives, and initial values for which these are undefined.
#include "libration/equation/explicit_system.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/precision.hpp"

namespace equation_explicit_system_test {

using namespace libration;
using namespace libration::ode;
using libration::ode::expression;

namespace {

explicit_system solved(const std::string& text) { return explicit_system(parse(text)); }

// The value of an expression if every leaf has one.
rational value_at(const expression& e, const std::vector<std::pair<expression, rational>>& at) {
    const expression value = replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        for (const auto& [of, number] : at) {
            if (same_form(of, leaf)) {
                return expression(number);
            }
        }
        return std::nullopt;
    });
    return value.fraction().value();
}

}  // namespace

TEST_CASE("a system is solved for its highest derivatives", "[ode][explicit_system]") {
    const auto f = unknown("f");
    CHECK(same_form(solved("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 1").right()[0],
                    expression(rational(-1, 2)) * (f * unknown("f", 2))));
    CHECK(same_form(solved("10*(f - t) = f'; f(0) = 0").right()[0], 10 * (f - variable())));
    // Two equations that contain both: x' + y' = t, x' - 2y' = x: x' = (2t + x)/3, y' = (t - x)/3.
    const auto both = solved("x' + y' = t; x' - 2*y' = x; x(0) = 0; y(0) = 0");
    const std::vector<std::pair<expression, rational>> at{{variable(), 5}, {unknown("x"), 7}};
    CHECK(value_at(both.right()[0], at) == rational(17, 3));
    CHECK(value_at(both.right()[1], at) == rational(-2, 3));
    // A coefficient that depends on the unknown; the order of unknowns is that of the text.
    const auto rayleigh = solved("R*R'' + 3/2*R'^2 + 1 = 0; R(0) = 1; R'(0) = 0");
    CHECK(value_at(rayleigh.right()[0], {{unknown("R"), 2}, {unknown("R", 1), 3}}) == rational(-29, 4));
    const auto mixed = solved("y' = x''; x'' = -x; x(0) = 1; x'(0) = 0; y(0) = 0");
    CHECK(mixed.unknowns()[0].name == "y");
    CHECK(value_at(mixed.right()[0], {{unknown("x"), 3}}) == -3);
    // A lower derivative with a factor that vanishes at the initial point is not a pivot if another is available.
    const auto chosen = solved("x*x' + y' = 1; y'*2 + x' = 3; x(0) = 0; y(0) = 0");
    CHECK(value_at(chosen.right()[0], {{unknown("x"), 0}}) == 1);
    CHECK(value_at(chosen.right()[1], {{unknown("x"), 0}}) == 1);
}

TEST_CASE("the C++ way makes the same system as text", "[ode][explicit_system]") {
    const auto f = unknown("f");
    equation_system blasius;
    blasius.add(derivative(f, 3) + f * derivative(f, 2) / 2);
    blasius.begin(f, 0).begin(derivative(f), 0).begin(derivative(f, 2), parameter("k")).set("k", rational(1, 3));
    const explicit_system built(blasius);
    const auto read = solved("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = k; k = 1/3");
    CHECK(same_form(built.right()[0], read.right()[0]));
    CHECK(built.starts()[0][2].fraction() == rational(1, 3));
    CHECK_THROWS_AS(derivative(f + 1), error);
}

TEST_CASE("factors of the variable are singular starts", "[ode][explicit_system]") {
    const auto lane_emden = solved("t*y'' + 2*y' + t*y^n = 0; n = 3; y(0) = 1; y'(0) = 0").singular();
    REQUIRE(lane_emden);
    CHECK(lane_emden->root == 1);
    CHECK(lane_emden->right[0].weights[0][0].fraction() == 0);
    CHECK(lane_emden->right[0].weights[0][1].fraction() == -2);
    const auto elsewhere = solved("(2*t - 2)*y'' + 4*y' + t*y^3 = 0; y(1) = 1; y'(1) = 0").singular();
    REQUIRE(elsewhere);
    CHECK(elsewhere->right[0].weights[0][1].fraction() == -2);
    const auto petviashvili = solved("variable r; w'' + w'/r - w + w^2 = 0; w(0) = 2; w'(0) = 0").singular();
    REQUIRE(petviashvili);
    CHECK(petviashvili->right[0].weights[0][1].fraction() == -1);
    const auto bessel = solved("t^2*y'' + t*y' + (t^2 - 4)*y = 0; y(0) = 0; y'(0) = 0").singular();
    REQUIRE(bessel);
    CHECK(bessel->right[0].weights[0][0].fraction() == 4);
    CHECK(bessel->right[0].weights[0][1].fraction() == -1);
    const auto thomas_fermi = solved("y'' = y^(3/2)/sqrt(t); y(0) = 1; y'(0) = -1").singular();
    REQUIRE(thomas_fermi);
    CHECK(thomas_fermi->root == 2);
    // The same equation as 2*y' + t*y'' + t*y = 0, multiplied by y.
    const auto multiplied = solved("t*y*y'' + 2*y*y' + t*y^2 = 0; y(0) = 1; y'(0) = 0").singular();
    REQUIRE(multiplied);
    CHECK(multiplied->right[0].weights[0][1].fraction() == -2);
    CHECK(solved("t*y' = 0; y(0) = 1").right()[0].is(0));
    CHECK(solved("sin(t)*y' = 0; y(0) = 1").right()[0].is(0));
    for (const char* const roots : {"sqrt(t)*y' = y; y(0) = 1", "(sqrt(t) + t)*y*y' = y^2; y(0) = 1"}) {
        const auto found = solved(roots).singular();
        REQUIRE(found);
        CHECK(found->root == 2);
    }
    CHECK_FALSE(solved("t*y'' + y = 0; y(1) = 1; y'(1) = 0").singular());
    CHECK_FALSE(solved("y'' = t*y; y(0) = 1; y'(0) = 0").singular());
}

TEST_CASE("wrong systems are told what is wrong", "[ode][explicit_system]") {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"y'' = y; y(0) = 1", "problem 'y'' has no initial value: add y'(0) = number"},
        {"y' = y; y(0) = 1; y(1) = 2",
         "problem 'y' at line 1, column 19 has another initial point than y: give all initial values at one point, or "
         "leave out the condition elsewhere and solve for an initial value with `libration find --such-that`"},
        {"y' = y; y(0) = 1; y(0) = 1",
         "problem 'y' at line 1, column 19 has two initial values, the first one at line 1, column 9: give it only "
         "one"},
        {"y' = y; y(0) = 1; y'(0) = 1",
         "problem 'y'' at line 1, column 19 is the highest derivative, and no initial value of the state: leave it "
         "out"},
        {"y' = y; z(0) = 1",
         "problem 'z(0) = 1' at line 1, column 9 is not an initial value of an unknown: add an equation with z'"},
        {"y' = y; y(0) = a; a = b; b = 2*a",
         "problem 'a' at line 1, column 19 needs itself: a -> b -> a: give one of them a number"},
        {"sin(y'') = y; y(0) = 0; y'(0) = 0",
         "problem 'y''' at line 1, column 1 is the highest derivative and occurs in a function: make the equation "
         "explicit, by solving for it or by differentiating"},
        {"y'^2 = y; y(0) = 1",
         "problem 'y'' at line 1, column 1 is the highest derivative and occurs in a power: make the equation "
         "explicit, by solving for it or by differentiating"},
        {"y'*y' = y; y(0) = 1",
         "problem 'y'' at line 1, column 1 is the highest derivative and occurs in a product with another highest "
         "derivative: make the equation explicit, by solving for it or by differentiating"},
        {"x' = y'; x(0) = 0; y(0) = 0", "problem has 1 equations for 2 unknowns (x, y): give the same number of both"},
        {"y' = log(y); y(0) = 0",
         "problem 'y'' cannot be expanded about the initial point, because its right-hand side takes the logarithm of "
         "a number that is not positive: choose another initial point"},
        {"y' = sqrt(y); y(0) = 0",
         "problem 'y'' cannot be expanded about the initial point, because its right-hand side takes the root of 0: "
         "choose another initial point"},
        {"y' = y^(1/3); y(0) = 0",
         "problem 'y'' cannot be expanded about the initial point, because its right-hand side takes a non-integer "
         "power of 0: choose another initial point"},
        {"y' = a^t; y(0) = 1; a = 0",
         "problem 'equation' at line 1, column 1 takes the logarithm of a number that is not positive (x^y with an "
         "exponent that is not constant is exp(y*log(x))): choose other numbers"},
        {"y' = asin(y); y(0) = 1",
         "problem 'y'' cannot be expanded about the initial point, because its right-hand side takes acos or asin of 1 "
         "or -1, where they have no series: choose another initial point"},
        {"R*R'' + 1 = 0; R(0) = 0; R'(0) = 1",
         "problem 'R''' cannot be expanded about the initial point, because its right-hand side divides by zero: "
         "choose another initial point"},
        {"t^2*y' = y - t; y(0) = 0",
         "problem 'y'' is irregular singular at the initial point, where a factor of the highest derivative vanishes "
         "too fast for a power series: choose another initial point"},
        {"t^3*y'' = y; y(0) = 0; y'(0) = 0",
         "problem 'y''' is irregular singular at the initial point, where a factor of the highest derivative vanishes "
         "too fast for a power series: choose another initial point"},
    };
    for (const auto& [text, told] : wrong) {
        INFO(text);
        CHECK_THROWS_WITH(solved(text), told);
    }
}

TEST_CASE("partial derivatives follow the rules of each function", "[ode][expression]") {
    // Compared with the difference quotient with h = 1/10^6 at u = 1/3, whose error is below h.
    const auto u = unknown("u");
    const auto value = [](const expression& e, const rational& at) {
        const expression found =
            replaced(e, [&](const expression&) -> std::optional<expression> { return expression(at); });
        const precision_scope scope(40);
        return rounded_value(found.constant());
    };
    const std::vector<expression> all{exp(u),
                                      log(u),
                                      sqrt(u),
                                      sin(u),
                                      cos(u),
                                      tan(u),
                                      asin(u),
                                      acos(u),
                                      atan(u),
                                      sinh(u),
                                      cosh(u),
                                      tanh(u),
                                      u * u,
                                      1 / u,
                                      u / (1 + u),
                                      pow(u, 5),
                                      pow(u, rational(-3, 2)),
                                      sin(u * u)};
    const rational at(1, 3);
    const rational h(1, 1'000'000);
    for (const expression& f : all) {
        const precision_scope scope(40);
        const mpfr quotient = (value(f, at + h) - value(f, at - h)) * 500'000;
        CHECK(abs(mpfr(quotient - value(partial(f, u), at))) < mpfr(1) / 1'000'000'000);
    }
    CHECK(partial(sin(variable()), u).is(0));
    CHECK(partial(unknown("u", 1), u).is(0));
}

TEST_CASE("parameters are set to the exact numbers of texts", "[ode]") {
    ode::equation_system system = ode::parse("x' = -k*x; x(0) = 1; k = 1");
    system.set("k", "0.1");
    CHECK(system.parameter_of("k")->value.fraction() == rational(1, 10));
    system.set("k", std::string("2/3")).set("k", 0);
    CHECK(system.parameter_of("k")->value.fraction() == rational(0));
    CHECK_THROWS_AS(system.set("k", "much"), error);
}

}  // namespace equation_explicit_system_test
