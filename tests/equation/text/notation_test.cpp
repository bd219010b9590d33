// Notations of textbooks: the same system as the standard notation, and messages that show both readings.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/equation/unused_parameters.hpp"
#include "libration/scalar/error.hpp"

namespace equation_text_notation_test {

using namespace libration;
using namespace libration::ode;
using libration::ode::expression;

namespace {

template <class Of>
void check_same(const std::vector<Of>& a, const std::vector<Of>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        if constexpr (requires { a[i].point; }) {
            CHECK(same_form(a[i].of, b[i].of));
            CHECK(same_form(a[i].point, b[i].point));
            CHECK(same_form(a[i].value, b[i].value));
        } else if constexpr (requires { a[i].left; }) {
            CHECK(same_form(a[i].left, b[i].left));
            CHECK(same_form(a[i].right, b[i].right));
        } else {
            CHECK(a[i].name == b[i].name);
            CHECK(same_form(a[i].value, b[i].value));
        }
    }
}

void check_same(const equation_system& a, const equation_system& b) {
    CHECK(a.variable == b.variable);
    check_same(a.equations, b.equations);
    check_same(a.starts, b.starts);
    check_same(a.parameters, b.parameters);
    check_same(a.exact, b.exact);
    check_same(a.invariants, b.invariants);
    CHECK(std::ranges::equal(a.open, b.open, {}, &open_parameter::name, &open_parameter::name));
}

void check_canonical(const std::string& text) {
    const std::string canonical = canonical_text(text);
    INFO(canonical);
    CHECK(canonical_text(canonical) == canonical);
    check_same(parse(canonical), parse(text));
}

void check_same(const std::string& text, const std::string& standard) {
    INFO(text);
    check_same(parse(text), parse(standard));
    check_canonical(text);
}

std::string refusal_of(const std::string& text) {
    try {
        const explicit_system solved(parse(text));
        return "nothing is wrong";
    } catch (const error& problem) {
        return problem.what();
    }
}

}  // namespace

TEST_CASE("derivatives are primes or quotients", "[ode][parse][notation]") {
    const std::string circle = "x'' = -x; x(0) = 1; x'(0) = 0";
    check_same("dx/dt = 1 + x^2; x(0) = 0", "x' = 1 + x^2; x(0) = 0");
    check_same("d2x/dt2 = -x; x(0) = 1; x'(0) = 0", circle);
    check_same("d^2x/dt^2 = -x; x(0) = 1; dx/dt(0) = 0", circle);
    check_same("d²x/dt² = -x; x(0) = 1; x'(0) = 0", circle);
    check_same("d^2 x / dt^2 = -x; x(0) = 1; x'(0) = 0", circle);
    check_same("x''(t) = -x(t); x(0) = 1; x'(0) = 0", circle);
    check_same("x″ = −x; x(0) = 1; x′(0) = 0", circle);
    check_same("x’’ = -x, x(0)=1, x’(0)=0", circle);
    check_same("5 d2x2/dt2 + dx2/dt = 0", "5*x2'' + x2' = 0");
    check_same("dy/dx = y; exact y(x) = exp(x)", "variable x; y' = y; exact y = exp(x)");
    check_same("dphi/dtau = 2phi", "variable tau; phi' = 2*phi");
    check_same("variable s1; dx/ds1 = x", "variable s1; x' = x");
    check_same("dx/ds1 = x", "variable s1; x' = x");
    check_same("d^2x/ds1^2 = -x", "variable s1; x'' = -x");
    check_same("dy/dx1 = x1*y", "variable x1; y' = x1*y");
    CHECK_THROWS_WITH(parse("d2x/ds1 = x"),
                      "problem 'd2x/ds1' at line 1, column 1 is ambiguous: write d^2x/ds1^2 = x for a derivative, "
                      "(dx/ds1)^2 = x for a power");
    CHECK_THROWS_WITH(parse("dx/dt2 = x"), Catch::Contains("is ambiguous: write d2x/dt2 = x for a derivative"));
    CHECK_THROWS_WITH(parse("variable t; dx/dt1 = x"), Catch::Contains("but the independent variable is t"));
    // Names of the problem are names.
    CHECK(same_form(parse("x' = dx/dt; dx = 1; dt = 2").equations[0].right, parameter("dx") / parameter("dt")));
    check_same("x' = -damping/density*x; damping = 1; density = 2",
               "x' = (-damping/density)*x; damping = 1; density = 2");
}

TEST_CASE("names of the system are names in a condition and in a change", "[ode][parse][notation]") {
    const equation_system system = parse("x'' = -x; dx = 1; dt = 2; x(0) = 1; x'(0) = 0");
    CHECK(same_form(parse_condition(system, "x = dx/dt"), unknown("x") - rational(1, 2)));
    CHECK(same_form(parse_condition(parse("x'' = -x"), "x = dx/dt"), unknown("x") - unknown("x", 1)));
    conditions_at_times at_times;
    add_condition(at_times, system, "x(1) = dx/dt");
    CHECK(same_form(at_times.differences().front(), at_times.at(unknown("x"), 1) - parameter("dx") / parameter("dt")));
    const equation_system open = parse("x' = a*dx + dt*x");
    CHECK(same_form(changed(open, "a = dx/dt").parameter_of("a")->value, parameter("dx") / parameter("dt")));
}

TEST_CASE("the independent variable is inferred", "[ode][parse][notation]") {
    for (const std::string text : {"y' = x*y; y(0) = 1", "y'(x) = x*y(x); y(0) = 1", "dy/dx = x*y; y(0) = 1",
                                   "y' = 1; y(0) = x0; x0 = 1; invariant y - x"}) {
        INFO(text);
        CHECK(parse(text).variable == "x");
    }
    CHECK(parse("y'(s) = s; y(0) = 1").variable == "s");
    CHECK(parse("y'' = -y; y(a) = 1; y'(a) = 0").variable == "t");
    CHECK(parse("y'' = -y; y(a) = 1; y'(a) = 0").is_open("a"));
    CHECK(parse("y' = x*y; x = 2").variable == "t");
    CHECK(parse("y' = x*t").variable == "t");
    CHECK(parse("x' = y; y' = x").variable == "t");
    CHECK_THROWS_WITH(
        parse("dx/dt = y; dy/ds = x"),
        "problem 'dy/ds' at line 1, column 12 differentiates by s, but the independent variable is t: write "
        "y' = x, or `variable s`");
    CHECK_THROWS_WITH(parse("variable t; dy/dx = y"),
                      Catch::Contains("but the independent variable is t: write y' = y"));
    CHECK_THROWS_WITH(
        parse("y'(x) = z; z'(s) = y"),
        "problem 'z'(s)' at line 1, column 12 has another independent variable than x: write z'(x) = y, or "
        "`variable s`");
}

TEST_CASE("e is Euler's number unless the problem defines it", "[ode][parse][notation]") {
    check_same("y' = e^t", "y' = exp(t)");
    check_same("y' = 2e^-t", "y' = 2*exp(-t)");
    check_same("y' = e^(-t^2)*y", "y' = exp(-t^2)*y");
    check_same("y' = e*y", "y' = exp(1)*y");
    check_same("y' = e**t^2", "y' = exp(t^2)");
    check_same("y' = 2e3*y + 2e-3", "y' = 2000*y + 1/500");
    CHECK(same_form(parse("y' = e^2*y; e = 3").equations[0].right, pow(parameter("e"), 2) * unknown("y")));
    CHECK(parse("e' = e; e(0) = 1").unknowns() == std::vector<std::string>{"e"});
    CHECK(parse("variable e; y' = e").equations[0].right.kind() == node_kind::variable);
}

TEST_CASE("a number multiplies the name or the parenthesis after it", "[ode][parse][notation]") {
    check_same("y' = 2y", "y' = 2*y");
    check_same("y' = 2 y^2", "y' = 2*y^2");
    check_same("y' = 2(y + 1)/3", "y' = 2*(y + 1)/3");
    check_same("y' = 3 sin(t) - 2y'", "y' = 3*sin(t) - 2*y'");
    check_same("y' = -2pi*y(t)", "y' = -2*pi*y");
    check_same("y' = y + 1/2", "y' = y + (1/2)");
    check_same("y' = k*y; k = 3pi/4 + 2(1 + 150deg)", "y' = k*y; k = 3*pi/4 + 2*(1 + 150*1deg)");
}

TEST_CASE("operators and letters beyond ASCII have an ASCII form", "[ode][parse][notation]") {
    check_same("y' = 2·y² − 3×y⁻¹ + y₁⋅y³, y₁′ = π÷2", "y' = 2*y^2 - 3*y^-1 + y1*y^3; y1' = pi/2");
    check_same("θ″ = −sin(θ); θ(0) = 30°; θ′(0) = ω₀; ω₀ = 1",
               "theta'' = -sin(theta); theta(0) = 30deg; theta'(0) = omega0; omega0 = 1");
    check_same("y' =\u00a0√(y² + 1)", "y' = sqrt(y^2 + 1)");
    check_same("y' = e²*y", "y' = exp(2)*y");
}

TEST_CASE("commas, semicolons and lines end statements", "[ode][parse][notation]") {
    const std::string standard = "y'' = -y; y(0) = 1; y'(0) = 0";
    check_same("y'' = -y, y(0)=1, y'(0)=0", standard);
    check_same("y'' = -y\ny(0)=1, y'(0)=0\n", standard);
    check_same("y' = bessel_j(0, y), y(0) = 1", "y' = bessel_j(0, y); y(0) = 1");
    check_same("y' = 1, y(0) = 2, k = 3", "y' = 1; y(0) = 2; k = 3");
}

TEST_CASE("what a text leaves open is set later", "[ode][parse][notation]") {
    const equation_system open = parse("x' = a + b*x^2; x(0) = 0; b = 1");
    CHECK(open.is_open("a"));
    CHECK_FALSE(open.is_open("b"));
    CHECK(unused_parameters("x' = a + b*x^2; x(0) = 0; b = 1").empty());
    const explicit_system solved(changed(open, "a = 2*b"));
    CHECK(same_form(solved.right()[0], 2 + pow(unknown("x"), 2)));
    CHECK_THROWS_WITH(explicit_system(open),
                      "problem 'a' at line 1, column 6 has no value: write a = number for a parameter, a' = ... for an "
                      "unknown");
    CHECK_THROWS_WITH(changed(open, "c = 1"),
                      Catch::Contains("is not a parameter of this problem: choose one of its own, b, a"));
    const equation_system none = parse("x'' = -x");
    const explicit_system begun(changed(none, "x(0) = 1, x'(0) = 1/2"));
    CHECK(begun.starts()[0][1].fraction() == rational(1, 2));
    CHECK_THROWS_WITH(changed(none, "x''(0) = 1"), Catch::Contains("has no initial value in this problem"));
    CHECK_THROWS_WITH(changed(none, "x = 3"),
                      "problem 'x' at line 1, column 1 is an unknown: write x(0) = 3 for its initial value");
    CHECK_THROWS_WITH(changed(none, "t = 3"),
                      "problem 't' at line 1, column 1 is the independent variable, which has no value: leave it out");
    CHECK_THROWS_WITH(
        changed(parse("y' = e^t"), "e = 3"),
        "problem 'e' at line 1, column 1 is Euler's number: write `e = 3` in the problem for a parameter");
    CHECK(changed(parse("y' = e*y; e = 2"), "e = 3").parameters.size() == 1);
    CHECK(parse_condition(parse("y' = -y; y(0) = 1"), "dy/dt = 2y").has_unknowns());
}

TEST_CASE("the canonical text is in ASCII with a statement in each line", "[ode][parse][notation]") {
    CHECK(canonical_text("d²θ/dt² = −2 sin(θ) + e^-t, θ(0) = 30°, dθ/dt(0)=0 # released") ==
          "theta'' = -2*sin(theta) + e^-t\ntheta(0) = 30deg\ntheta'(0) = 0\n");
    CHECK(canonical_text("y'(x) = x*y(x)^2 - bessel_j(0,x); invariant y-x; exact y(x) = 2(x+1)") ==
          "variable x\ny' = x*y^2 - bessel_j(0, x)\ninvariant y - x\nexact y = 2*(x + 1)\n");
    // Without the declaration, x would be the variable.
    CHECK(canonical_text("dy/dt = x*y") == "variable t\ny' = x*y\n");
    check_same("dy/dt = x*y", "variable t; y' = x*y");
    check_same("y'(t) = x*y", "variable t; y' = x*y");
    CHECK(parse(canonical_text("dy/dt = x*y")).is_open("x"));
    CHECK(canonical_text("dy/dt = x*y; x = 2") == "y' = x*y\nx = 2\n");
}

TEST_CASE("an ambiguous text is rejected with both readings", "[ode][parse][notation]") {
    const std::vector<std::pair<std::string, std::string>> ambiguous{
        {"y' = 1/2y; y(0) = 1", "problem '1/2y' at line 1, column 7 is ambiguous: write y' = 1/(2*y), or y' = (1/2)*y"},
        {"y' = 1 + y/2 y; y(0) = 1",
         "problem 'y/2 y' at line 1, column 11 is ambiguous: write y' = 1 + y/(2*y), or y' = 1 + (y/2)*y"},
        {"y' = y^2y + 1; y(0) = 1",
         "problem 'y^2y' at line 1, column 7 is ambiguous: write y' = y^(2*y) + 1, or y' = y^2*y + 1"},
        {"y' = e^-2t; y(0) = 1",
         "problem 'e^-2t' at line 1, column 7 is ambiguous: write y' = e^(-2*t), or y' = e^-2*t"},
        {"y' = a(t+1); y(0) = 1; a = 2",
         "problem 'a(' at line 1, column 6 is ambiguous: write y' = a*(t+1) for a product, or for a function one of " +
             function_names()},
        {"y' = y(0) + 1; y(0) = 1",
         "problem 'y(' at line 1, column 6 is ambiguous: write y' = y*(0) + 1 for a product, or y(0) = 1 as a "
         "statement "
         "for an initial value"},
        {"dx/dt^2 = x; x(0) = 1",
         "problem 'dx/dt^2' at line 1, column 1 is ambiguous: write d2x/dt2 = x for a derivative, (dx/dt)^2 = x for a "
         "power"},
        {"y' = y; y(0) = 0,5",
         "problem '0,5' at line 1, column 16 is ambiguous: write 0.5 for a decimal, or a blank after a comma between "
         "statements"},
    };
    for (const auto& [text, told] : ambiguous) {
        INFO(text);
        CHECK(refusal_of(text) == told);
    }
}

TEST_CASE("the corrected statement is shown where it is known", "[ode][parse][notation]") {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"d/dt x = x; x(0) = 1", "problem 'd/dt' at line 1, column 1 is an operator: write dx/dt = x"},
        {"d^2/dt^2(x) = x; x(0) = 1", "problem 'd^2/dt^2' at line 1, column 1 is an operator: write d2x/dt2 = x"},
        {"y' = y²⁻¹; y(0) = 1",
         "problem '²⁻¹' at line 1, column 7 has a second exponent behind a superscript: write one in parentheses, as "
         "in x^(2-1)"},
        {"y' = y² ³; y(0) = 1",
         "problem '² ³' at line 1, column 7 has a second exponent behind a superscript: write one in parentheses, as "
         "in x^(2-1)"},
        {"y' = 1 + sin 2y; y(0) = 1",
         "problem 'sin' at line 1, column 10 is a function without ( after it: write y' = 1 + sin(2*y)"},
        {"y' = sin^2(y + 1); y(0) = 1",
         "problem 'sin' at line 1, column 6 is a function without ( after it: write y' = sin(y + 1)^2 for a power"},
        {"y' = sin²(y)*y; y(0) = 1",
         "problem 'sin' at line 1, column 6 is a function without ( after it: write y' = sin(y)^2*y for a power"},
        {"y' = sin⁻¹ y; y(0) = 1",
         "problem 'sin' at line 1, column 6 is a function without ( after it: write y' = sin(y)^-1 for a power, y' = "
         "asin(y) for the inverse function"},
        {"y' = sin^y(2); y(0) = 1",
         "problem 'sin' at line 1, column 6 is a function without ( after it: write the exponent behind the argument, "
         "as in sin(x)^2"},
        {"y' = sin; y(0) = 1",
         "problem 'sin' at line 1, column 6 is a function without ( after it: write y' = sin(...)"},
        {"dy/dx = x; x' = y",
         "problem 'dy/dx' at line 1, column 1 differentiates by x, which is an unknown: give one of them another name"},
        {"dx/dx = x",
         "problem 'dx/dx' at line 1, column 1 differentiates x by itself: rename the unknown or the variable"},
        {"variable x; x' = 1",
         "problem 'x' at line 1, column 13 is the independent variable: choose another name, or `variable t`"},
        {"y' = y z; z' = 1", "problem 'y z' at line 1, column 6 multiplies without *: write y' = y*z"},
        {"y' = y²z; z' = 1", "problem '²z' at line 1, column 7 multiplies without *: write y' = y²*z"},
        {"θ' = λ θ; θ(0) = 1; λ = 2", "problem 'λ θ' at line 1, column 6 multiplies without *: write θ' = λ*θ"},
        {"θ' = θ\nθ(0) = λ λ", "problem 'λ λ' at line 2, column 8 multiplies without *: write θ(0) = λ*λ"},
        {"y' = Ln(y); y(0) = 1",
         "problem 'Ln' at line 1, column 6 is not a function: write y' = log(y), or one of " + function_names()},
        {"y' = y ∂ 2; y(0) = 1",
         "problem '∂' at line 1, column 8 is not allowed in a problem: write names, numbers, + - * / ^ ( ) = and ;"},
        {"y' = \xff; y(0) = 1",
         "problem '\\?' at line 1, column 6 is not allowed in a problem: write names, numbers, + - * / ^ ( ) = and ;"},
        {"y' = 1 +\u2212y; y(0) = 1",
         "problem '+\u2212' at line 1, column 8 denotes an interval, which is not supported here: write one number, "
         "and a negative summand in parentheses"},
    };
    for (const auto& [text, told] : wrong) {
        INFO(text);
        CHECK(refusal_of(text) == told);
    }
}

TEST_CASE("a long statement is cut between characters", "[ode][parse][notation]") {
    std::string sum = "θ";
    for (int i = 0; i < 100; ++i) {
        sum += "+θ";
    }
    const std::string told = refusal_of("θ' = " + sum + " θ +" + sum);
    CHECK_THAT(told, Catch::Contains("multiplies without *: write ...") && Catch::EndsWith("..."));
    CHECK_THAT(told, Catch::Contains("θ*θ +θ+θ"));
    CHECK(told.size() < 500);
}

TEST_CASE("any bytes are read or rejected", "[ode][parse][notation]") {
    const std::vector<std::string> parts{"d", "x", "'",  "/", "d2x", "dt", "^",         "2",      "(",
                                         ")", "=", ",",  ";", "e",   "²",  "⁻",         "θ",      "\xc2",
                                         "′", " ", "\n", "·", "t",   "1.", "variable ", "exact ", "invariant "};
    unsigned state = 1;
    int systems = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string text;
        for (unsigned n = state % 13; n > 0; --n) {
            state = state * 1664525u + 1013904223u;
            text += parts[(state >> 16) % parts.size()];
        }
        state = state * 1664525u + 1013904223u;
        INFO(text);
        try {
            const equation_system read = parse(text);
            CHECK_FALSE(read.equations.empty());
        } catch (const error& problem) {
            CHECK(std::string(problem.what()).starts_with("problem "));
            continue;
        }
        ++systems;
        check_canonical(text);
    }
    CHECK(systems > 10);
}

TEST_CASE("the time to read a text grows with its length, not its square", "[ode][parse][notation]") {
    const std::string commas = "y' = (" + std::string(200'000, ',');
    const auto before = std::chrono::steady_clock::now();
    CHECK_THAT(refusal_of(commas), Catch::Contains("problem ',' at line 1, column 7 is not a number or a name"));
    CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(10));
}

}  // namespace equation_text_notation_test
