// Problems as text: the same objects as constructed by operators, and the messages for invalid ones.
#include "libration/equation/text/parse.hpp"
#include "libration/equation/renamed_unknowns.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/unused_parameters.hpp"
#include "libration/scalar/error.hpp"

namespace equation_text_parse_test {

using namespace libration;
using namespace libration::ode;
using libration::ode::expression;

namespace {

// The error message for a problem, without "problem".
std::string refusal_of(const std::string& text) {
    try {
        const explicit_system solved(parse(text));
        return "nothing is wrong";
    } catch (const error& problem) {
        return problem.what();
    }
}

// The left-hand side of the only equation of a text.
expression read(const std::string& formula) {
    return parse(formula + " = y' + z'; z' = 1; k = 2; m = 3").equations.front().left;
}

}  // namespace

TEST_CASE("text and operators make the same expressions", "[ode][parse]") {
    const auto y = unknown("y");
    const auto z = unknown("z");
    const auto k = parameter("k");
    const auto t = variable();
    const std::vector<std::pair<std::string, expression>> pairs{
        {"y + z*t", y + z * t},
        {"y - z - t", (y - z) - t},
        {"y/z/t", (y / z) / t},
        {"8/3*z", expression(rational(8, 3)) * z},
        {"-y^2", -pow(y, 2)},
        {"2^3^2*y", 512 * y},
        {"y**2**k", pow(y, pow(2, k))},
        {"y''^2", pow(unknown("y", 2), 2)},
        {"y^-1", pow(y, -1)},
        {"2*-y", 2 * -y},
        {"y^(3/2)", pow(y, rational(3, 2))},
        {"sin(y)*exp(-t)", sin(y) * exp(-t)},
        {"sqrt(2)*y", expression(apply(function_kind::sqrt, number(rational(2)))) * y},
        {"2E-3*y", expression(rational(1, 500)) * y},
        {"pi*y", expression(number(1, unit::pi)) * y},
        {"(y+z)*(y-z)", (y + z) * (y - z)},
        {"y*1 + 0*z", y},
    };
    for (const auto& [text, built] : pairs) {
        INFO(text);
        CHECK(same_form(read(text), built));
        CHECK(read(text).hash() == built.hash());
    }
    CHECK_FALSE(same_form(y + z, z + y));
    CHECK_FALSE(same_form(y, unknown("y", 1)));
}

TEST_CASE("a problem's statements are read in any order and on any lines", "[ode][parse]") {
    const auto system = parse(
        "# Blasius\nf''(1/2) = k  # the wall\nf''' + f*f''/2 = 0; f(1/2) = 0; f'(1/2) = 30deg\nk = 3*m; m = 1/3 + "
        "2pi\ninvariant f*f' - (m)\nexact f = k*t^2\r\n");
    CHECK(system.equations.size() == 1);
    CHECK(system.equations[0].at.line == 3);
    CHECK(system.starts.size() == 3);
    CHECK(system.starts[0].of.derivative() == 2);
    CHECK(system.starts[0].at.column == 1);
    CHECK(system.invariants.size() == 1);
    REQUIRE(system.exact.size() == 1);
    CHECK(same_form(system.exact[0].value, parameter("k") * pow(variable(), 2)));
    const explicit_system solved(system);
    CHECK(solved.unknowns().front().order == 3);
    CHECK(solved.point().fraction() == rational(1, 2));
    CHECK(same_form(expression(solved.starts()[0][2]), expression(number(1) + number(6, unit::pi))));
    CHECK(same_form(expression(solved.starts()[0][1]), expression(number(30, unit::degree))));
    // Names: the variable may be another one, then t is free; e, E, I, S, T are free; case counts.
    const auto named = parse("variable x; t' = x*T; T' = E; E = 2; t(0) = 0; T(0) = 1");
    CHECK(named.variable == "x");
    CHECK(named.unknowns() == std::vector<std::string>{"t", "T"});
    CHECK(parse("invariant(0) = 1; invariant' = invariant").unknowns().front() == "invariant");
}

TEST_CASE("an interval is the whole value of a parameter or of a start, and nothing else", "[ode][parse]") {
    for (const std::string sign : {"+-", " +-", "-+", "\u00b1", " \u2213 "}) {
        INFO(sign);
        const auto system = parse("x' = -k*x; x(0) = 1" + sign + "0.1; k = 2 " + sign + " 1e-3");
        REQUIRE(system.sets.size() == 2);
        CHECK(system.sets[0].name == "x(0)");
        CHECK(system.sets[0].lower.constant().plain()->coefficient == rational(9, 10));
        CHECK(system.sets[0].upper.constant().plain()->coefficient == rational(11, 10));
        CHECK(system.sets[1].name == "k");
        CHECK_THROWS_WITH(explicit_system(system), Catch::Contains("'x(0)' at line 1, column 12 is a set of values"));
        // As an expression 1 +- 0.1 would be 0.9.
        const auto of_interval = Catch::Contains("denotes an interval, which is not supported here");
        CHECK_THROWS_WITH(parse("x' = 1" + sign + "x; x(0) = 1"), of_interval);
        CHECK_THROWS_WITH(parse("x' = x; x(0) = 2*(1" + sign + "0.1)"), of_interval);
        CHECK_THROWS_WITH(parse("x' = x; x(0) = 1" + sign + "0.1" + sign + "0.2"), of_interval);
        CHECK_THROWS_WITH(parse_constant("1" + sign + "0.1"), of_interval);
    }
    const auto system = parse("x' = k*x; x(0) = [0.9,1.1], k = [-1, min0]; min0 = 2");
    REQUIRE(system.sets.size() == 2);
    CHECK(system.sets[0].upper.constant().plain()->coefficient == rational(11, 10));
    CHECK(canonical_text("x' = k*x; x(0) = 1\u00b10.1; k = [1,2]") == "x' = k*x\nx(0) = 1 +- 0.1\nk = [1, 2]\n");
    for (const std::string wrong : {"[1]", "[1, 2, 3]", "[1, 2", "[, 2]", "[1, 2] + 1", "[1; 2]"}) {
        INFO(wrong);
        CHECK_THROWS_WITH(parse("x' = x; x(0) = " + wrong), Catch::Contains("is not an interval: write both ends"));
    }
    CHECK_THROWS_WITH(parse("x' = [0, 1]*x; x(0) = 1"), Catch::Contains("is not a parenthesis here"));
    CHECK(parse_constant("1 + (-0.1)").constant().plain()->coefficient == rational(9, 10));
    CHECK(parse_constant("1 + -0.1").constant().plain()->coefficient == rational(9, 10));
}

TEST_CASE("a change replaces numbers and sets by each other", "[ode][parse]") {
    const auto of = parse("x' = k*x; x(0) = [1, 2]; k = 3");
    CHECK(changed(of, "x(0) = 1").sets.empty());
    CHECK(explicit_system(changed(of, "x(0) = 1")).starts()[0][0].fraction() == rational(1));
    const auto other = changed(of, "x(0) = [4, 5]; k = 1 +- 1/2");
    REQUIRE(other.sets.size() == 2);
    CHECK(other.sets[0].lower.fraction() == rational(4));
    CHECK(other.parameter_of("k") == nullptr);
    CHECK(changed(other, "k = 7").sets.size() == 1);
    CHECK(changed(parse("x' = k*x; x(0) = 1"), "k = [1, 2]").open.empty());
    CHECK_THROWS_WITH(changed(of, "q = [1, 2]"), Catch::Contains("is not a parameter of this problem"));
}

TEST_CASE("unused parameters are those that stand in their definition alone", "[ode][parse]") {
    CHECK(unused_parameters("y' = y; y(0) = 1; k = 3") == std::vector<std::string>{"k"});
    CHECK(unused_parameters("y' = -a*y; y(0) = b; a = c; b = 1; c = 2 # d = 1").empty());
    CHECK(unused_parameters("y' = y; y(0) = 1; c = b*k; b = a + 1; a = 2*y; k = 1").empty());  // c may be shown
    CHECK(unused_parameters("y' = y; y(0) = 1; b = a + 1; a = 2") == std::vector<std::string>{"b"});
    CHECK(unused_parameters("y' = y; y(0) = 1; y1 = 3; invariant y*k; k = 1") == std::vector<std::string>{"y1"});
    CHECK(unused_parameters("y' = y; y(0) = 1; exact y = a*exp(t); a = 1").empty());
}

TEST_CASE("names for expressions are replaced in equations and conditions", "[ode][parse]") {
    const std::string rest = "; k = 2; x(0) = 1; y(0) = 0";
    const explicit_system named(parse("x' = -s; y' = s - y; s = r + t; r = k*x^2" + rest));
    const explicit_system plain(parse("x' = -(k*x^2 + t); y' = (k*x^2 + t) - y" + rest));
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(same_form(named.right()[i], plain.right()[i]));
    }
    const equation_system given = parse("x' = -r; r = k*x; k = 2; x(0) = 1");
    CHECK(same_form(parse_condition(given, "r = 1"), 2 * unknown("x") - 1));
    CHECK(same_form(explicit_system(changed(given, "k = 3")).right()[0], -(3 * unknown("x"))));
    // One more unknown r, whose derivative is -k r.
    const explicit_system shown(with_column(given, "r"));
    CHECK(names_of_state(shown) == std::vector<std::string>{"x", "r"});
    CHECK(shown.starts()[1][0].fraction() == 2);
    CHECK_THROWS_WITH(with_column(given, "k"),
                      "problem 'k' is not a name for an expression in unknowns or time: define "
                      "it in the problem, as k = x^2 + y^2");
    CHECK_THROWS_WITH(with_column(given, "x"),
                      "problem 'x' already has a column, like every unknown and lower derivative");
    CHECK_THROWS_WITH(with_column(given, "x'"), "problem 'x'' is a derivative: name it in the problem, as v = x'");
    CHECK_THROWS_WITH(changed(given, "r = 3"),
                      "problem 'r' at line 1, column 1 is a name for an expression in unknowns "
                      "or time: change it in the problem");
}

TEST_CASE("unknowns without a derivative are those that more equations determine", "[ode][parse]") {
    const equation_system computed = parse("x' = z; 0 = z - k*x; k = 2; x(0) = 1");
    CHECK(computed.unknowns() == std::vector<std::string>{"x", "z"});
    CHECK(computed.is_algebraic("z"));
    CHECK_FALSE(computed.is_algebraic("x"));
    CHECK(computed.order_of("z") == 1);
    // k is open, and z has an initial value.
    const equation_system open = parse("x' = z; 0 = z - k*x; x(0) = 1; z(0) = 2");
    CHECK(open.unknowns() == std::vector<std::string>{"x", "z"});
    CHECK(open.is_open("k"));
    // As many equations as unknowns: z is open.
    CHECK(parse("x' = z; x(0) = 1").is_open("z"));
}

TEST_CASE("parameters and starts are changed one at a time", "[ode][parse]") {
    const auto system = parse("f'' = -k*f; f(0) = 1; f'(0) = 0; k = 1");
    const explicit_system solved(changed(changed(system, "k = 1/3"), "f'(0) = 2*k"));
    CHECK(solved.starts()[0][1].fraction() == rational(2, 3));
    CHECK(same_form(solved.right()[0], expression(rational(-1, 3)) * unknown("f")));
    CHECK_THROWS_WITH(changed(system, "m = 1"),
                      "problem 'm' at line 1, column 1 is not a parameter of this problem: choose one of its own, k");
    CHECK_THROWS_WITH(changed(system, "kk = 1"), Catch::Contains("of this problem (did you mean k?): choose"));
    CHECK_THROWS_WITH(changed(parse("f' = f; f(0) = 1"), "k = 1"),
                      Catch::Contains("is not a parameter of this problem, which has none: leave it out"));
    CHECK_THROWS_WITH(changed(system, "f''(0) = 1"),
                      "problem 'f''' at line 1, column 1 has no initial value in this problem: choose one that has");
    CHECK_THROWS_WITH(
        changed(system, "f'' = f"),
        "problem 'f'' = f' at line 1, column 1 is neither a parameter nor an initial value: write k = 1 or f(0) = 1");
    CHECK(parse_constant("3pi/4").constant().plain()->coefficient == rational(3, 4));
    CHECK_THROWS_WITH(
        parse_constant("y"),
        "problem 'y' at line 1, column 1 has no value: write y = number for a parameter, y' = ... for an unknown");
}

TEST_CASE("wrong texts are told the place and the remedy", "[ode][parse]") {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"y' = (y)(y); y(0) = 1", "problem ')(' at line 1, column 8 multiplies without *: write y' = (y)*(y)"},
        {"y' = k*y\ny(0) = 1\nk = 1/2pi",
         "problem '1/2pi' at line 3, column 6 is ambiguous: write k = 1/(2*pi), or k = (1/2)*pi"},
        {"y' = k*y; y(0) = 1; k = 1/2T",
         "problem 'T' at line 1, column 28 is the period of a pendulum, of which a problem has none: write a number"},
        {"pi = 3; y' = y", "problem 'pi' at line 1, column 1 is a reserved name: choose another, as pi_"},
        {"t = 3; y' = y",
         "problem 't' at line 1, column 1 is the independent variable: choose another name, or `variable x`"},
        {"sin' = 1",
         "problem 'sin'' at line 1, column 1 is the derivative of a function: write primes only after unknowns, and "
         "choose another name for an unknown, as sin_"},
        {"y' = sin y; y(0) = 0",
         "problem 'sin' at line 1, column 6 is a function without ( after it: write y' = sin(y)"},
        {"y' = Sin(y); y(0) = 0",
         "problem 'Sin' at line 1, column 6 is not a function: write y' = sin(y), or one of " + function_names()},
        {"y' = erf(y, 1); y(0) = 1", "problem 'erf' at line 1, column 6 has one argument: write erf(x)"},
        {"y' = bessel_j(y); y(0) = 1",
         "problem 'bessel_j' at line 1, column 6 has two arguments, its order and its argument: write bessel_j(0, x)"},
        {"y' = bessel_j(0, y, 1); y(0) = 1",
         "problem 'bessel_j' at line 1, column 6 has two arguments: write bessel_j(0, x)"},
        {"y' = bessel_j(y, 1); y(0) = 1",
         "problem 'y' = bessel_j(y, 1)' at line 1, column 6 has an order that is not constant: write a number first, "
         "as "
         "in bessel_j(0, y)"},
        {"y' = bessel_j(pi, y); y(0) = 1",
         "problem 'y' = bessel_j(pi, y)' at line 1, column 6 has an order that is not a fraction: write a number "
         "first, as "
         "in bessel_j(0, y)"},
        {"y' = acosh(1/2)*y; y(0) = 1",
         "problem 'y' = acosh(1/2)*y' at line 1, column 6 takes acosh of a number below 1: choose another number"},
        {"y' = k; y(0) = 0",
         "problem 'k' at line 1, column 6 has no value: write k = number for a parameter, k' = ... for an unknown"},
        {"variable x; y' = t; y(0) = 0", "problem 't' at line 1, column 18 has no value: use the variable, x"},
        {"y' = (-2)^t; y(0) = 1",
         "problem 'y' = (-2)^t' at line 1, column 6 has an exponent that is not constant over a base that is not "
         "positive: x^y is exp(y*log(x)), for x > 0"},
        {"y' = (y + 1; y(0) = 1", "problem '(' at line 1, column 6 is not closed: add a )"},
        {"y' = y + 1); y(0) = 1", "problem ')' at line 1, column 11 closes nothing: add a ("},
        {"y' = y +; y(0) = 1",
         "problem 'y' = y +' at line 1, column 8 ends where a number or a name is missing: write one"},
        {"y' = y*/2; y(0) = 1", "problem '/' at line 1, column 8 is not a number or a name: write one"},
        {"y' == y; y(0) = 1", "problem '==' at line 1, column 4 is not an equation: write ="},
        {"y' - y; y(0) = 1", "problem 'y' - y' at line 1, column 1 is not an equation: write one with ="},
        {"y' = ; y(0) = 1", "problem 'y' =' at line 1, column 4 has nothing on one side of =: write both sides"},
        {"y' = y/0; y(0) = 1", "problem 'y' = y/0' at line 1, column 7 divides by zero: choose another number"},
        {"y' = atan2(0, 0); y(0) = 1",
         "problem 'y' = atan2(0, 0)' at line 1, column 6 takes atan2 of 0 and 0, which has no value: choose another "
         "number"},
        {"y' = log(-1)*y; y(0) = 1",
         "problem 'y' = log(-1)*y' at line 1, column 6 takes the logarithm of a number that is not positive: choose "
         "another number"},
        {"y' = y; y(0) = y'",
         "problem 'y(0) = y'' at line 1, column 16 has a value that is not constant: give a number or parameters"},
        {"y' = a*y; a = b; b = a*y; y(0) = 1",
         "problem 'b' at line 1, column 18 needs itself: b -> a -> b: give one of them a number"},
        {"y' = a*y; a = 2*y; y(0) = a", "problem 'a' depends on the solution or on time here: give a number"},
        {"y' = y; k = 1; k = 2; y(0) = 1",
         "problem 'k = 2' at line 1, column 16 gives k a second value, after `k = 1` at line 1: give it only one"},
        {"x' = y\ny' = -x\nx' = 2*y",
         "problem 'x' = 2*y' at line 3, column 1 is a second equation for x, in addition to `x' = y` at line 1: give "
         "it "
         "only one"},
        {"x' = if(t > 1 AND t < 2, 1, 2)",
         "problem 'AND' at line 1, column 15 is not an operator between conditions: write x > 1 and y > 2"},
        {"x' = if(t > 1 nor t < 2, 1, 2)",
         "problem 'nor' at line 1, column 15 is not an operator between conditions: write not (x > 1 or y > 2)"},
        {"x' = if(Not(t > 1), 1, 2)",
         "problem 'Not' at line 1, column 9 is not an operator between conditions: write not (x > 1)"},
        {"x' = Not(t)*x; Not = 2",
         "problem 'Not(' at line 1, column 6 is ambiguous: write x' = Not*(t)*x for a product, "
         "or for a function one of " +
             function_names()},
        {"x' = if(~(t > 1), 1, 2)",
         "problem '~' at line 1, column 9 is not an operator: write not (t > 1) for ~(t > 1)"},
        {"x' = if(t ~= 1, 1, 2)", "problem '~=' at line 1, column 11 is not a comparison: write x != 1 for x ~= 1"},
        {"x' = if(t <> 1, 1, 2)", "problem '<>' at line 1, column 11 is not a comparison: write x != 1 for x <> 1"},
        {"x' = t % 2", "problem '%' at line 1, column 8 is not an operator: write mod(t, 2) for t % 2"},
        {"x' = if(t > 1 .And. t < 2, 1, 2)", "problem '.And.' at line 1, column 15 is not an operator: write and"},
        {"x' = if(t .ge. 1, 1, 2)", "problem '.ge.' at line 1, column 11 is not an operator: write >="},
        {"x' = y; y' = -x\nx = max(0, x); x(0) = 1; y(0) = 0",
         "problem 'x = max(0, x)' at line 2, column 1 is a second equation for x, in addition to `x' = y` at line 1: "
         "give it "
         "only "
         "one"},
        {"y' = $; y(0) = 1",
         "problem '$' at line 1, column 6 is not allowed in a problem: write names, numbers, + - * / ^ ( ) = and ;"},
        {"y' = y; y(0) = 1 '",
         "problem ''' at line 1, column 18 does not follow a name: write primes directly after an unknown, as f''"},
        {"# nothing", "problem has no equation: write one, as y' = y"},
        {"y' = 1e1000000; y(0) = 1",
         "problem '1e1000000; y(0) = 1' at line 1, column 6 is beyond the range 1e-100000 .. 1e100000: choose another "
         "number"},
    };
    for (const auto& [text, told] : wrong) {
        INFO(text);
        CHECK(refusal_of(text) == told);
    }
}

TEST_CASE("deep and long texts are refused before they cost anything", "[ode][parse]") {
    const std::string many(200, '(');
    CHECK(refusal_of("y' = " + many + "y" + std::string(200, ')')).find("is nested more than 100 deep") !=
          std::string::npos);
    CHECK(refusal_of("y' = " + std::string(300, '-') + "y").find("is nested more than 100 deep") != std::string::npos);
    // One level for each parenthesis, function, sign and exponent: 100 of them are read.
    for (const auto& [before, behind] : {std::pair<std::string, std::string>("(", ")"),
                                         {"sin(", ")"},
                                         {"-", ""},
                                         {"2^", ""},
                                         {"+", ""},
                                         {"(y + ", ")"}}) {
        const auto nested = [&, &first = before, &last = behind](int levels) {
            std::string text;
            for (int i = 0; i < levels; ++i) {
                text += first;
            }
            text += first == "2^" ? "1" : "y";
            for (int i = 0; i < levels; ++i) {
                text += last;
            }
            return refusal_of("y' = " + text);
        };
        INFO(before);
        CHECK(nested(100).find("deep") == std::string::npos);
        CHECK(nested(101).find("is nested more than 100 deep") != std::string::npos);
    }
    CHECK(refusal_of(std::string(1'000'001, ' ')) == "problem is longer than 1000000 characters: write less");
    const std::string name(201, 'a');
    CHECK(refusal_of(name + "' = 1") ==
          "problem '" + std::string(60, 'a') +
              "...' at line 1, column 1 has more than 200 characters, including primes: choose another");
    CHECK(refusal_of("y" + std::string(200, '\'') + " = 1").find("has more than 200 characters") != std::string::npos);
}

// The solutions are e^-t, and cos and sin with the name of a column.
TEST_CASE("an unknown with the name of a column of tables has another column", "[ode][parse]") {
    const auto decay = parse("n' = -n; n(0) = 1");
    CHECK(decay.unknowns() == std::vector<std::string>{"n_"});
    CHECK(renamed_unknowns("n' = -n; n(0) = 1") == std::map<std::string, std::string>{{"n", "n_"}});
    CHECK(renamed_unknowns("N' = -N*n; N(0) = 1; n = 2").empty());
    CHECK(name_before_renaming("n_") == "n");
    CHECK(name_before_renaming("count__") == "count");
    CHECK(name_before_renaming("m_") == "m_");
    CHECK(same_form(parse_condition(decay, "n = 1/2"), unknown("n_") - rational(1, 2)));
    CHECK(changed(decay, "n(0) = 3").starts.front().value.fraction() == rational(3));
    CHECK(same_form(parse_value_at_time(decay, "n(0)").of, unknown("n_")));
    const auto both = parse("time' = n_; n' = -time; n_ = 2; time(0) = 0; n(0) = 1");
    CHECK(both.unknowns() == std::vector<std::string>{"time_", "n__"});
    CHECK(parse("step' = -lambda*step; lambda = 2; step(0) = 1; when step = 1/2: step = 1").unknowns() ==
          std::vector<std::string>{"step"});
    CHECK(canonical_text("n' = -n; n(0) = 1") == "n' = -n\nn(0) = 1\n");
}

}  // namespace equation_text_parse_test
