// Functions of other programs: integrals in closed form, and values at exact numbers by the definitions.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/mpfr.hpp"

namespace ode_written_function_test {

using namespace libration;

namespace {

struct known_integral {
    std::string integrand;
    std::string from, to;
    mpfr value;
};

void check_integrals(const std::vector<known_integral>& all) {
    for (const known_integral& each : all) {
        INFO(each.integrand << " from " << each.from << " to " << each.to);
        const std::string text = "y' = " + each.integrand + "; y(" + each.from + ") = 0";
        const answer found = solve(problem(text))->states(each.to, proved_digits(20));
        CHECK(abs(mpfr(mpfr(found.at(0, "y")) - each.value)) <= abs(each.value) * pow(mpfr(10), -19));
    }
}

mpfr q(int n, int d) { return mpfr(mpfr(n) / d); }

}  // namespace

TEST_CASE("quotients and inverses of elementary functions have their integrals", "[ode][parse]") {
    const precision_scope scope(60);
    const mpfr one = 1;
    const mpfr e = exp(one);
    check_integrals({
        {"cot(t)", "1", "2", log(mpfr(sin(mpfr(2)) / sin(one)))},
        {"sec(t)", "0", "1", asinh(mpfr(tan(one)))},
        {"csc(t)", "1", "2", log(mpfr(tan(one) / tan(q(1, 2))))},
        {"coth(t)", "1", "2", log(mpfr(sinh(mpfr(2)) / sinh(one)))},
        {"sech(t)", "0", "1", mpfr(2 * atan(mpfr(tanh(q(1, 2)))))},
        {"csch(t)", "1", "2", log(mpfr(tanh(one) / tanh(q(1, 2))))},
        {"acot(t)", "1", "2", mpfr(2 * atan(q(1, 2)) + log(q(5, 2)) / 2 - atan(one))},
        {"asec(t)", "2", "3", mpfr(3 * acos(q(1, 3)) - acosh(mpfr(3)) - 2 * acos(q(1, 2)) + acosh(mpfr(2)))},
        {"acsc(t)", "2", "3", mpfr(3 * asin(q(1, 3)) + acosh(mpfr(3)) - 2 * asin(q(1, 2)) - acosh(mpfr(2)))},
        {"acoth(t)", "2", "3", mpfr(3 * atanh(q(1, 3)) + log(mpfr(8)) / 2 - 2 * atanh(q(1, 2)) - log(mpfr(3)) / 2)},
        {"asech(t)", "1/4", "1/2", mpfr(acosh(mpfr(2)) / 2 + asin(q(1, 2)) - acosh(mpfr(4)) / 4 - asin(q(1, 4)))},
        {"acsch(t)", "1", "2", mpfr(2 * asinh(q(1, 2)) + asinh(mpfr(2)) - 2 * asinh(one))},
        {"logistic(t)", "0", "1", log(mpfr((1 + e) / 2))},
        {"softplus(t) - softplus(-t)", "0", "1", q(1, 2)},
        {"pow(t, 3/2)", "1", "4", q(62, 5)},
        {"pow(2, t)", "0", "2", mpfr(3 / log(mpfr(2)))},
        {"ln(t)", "1", "2", mpfr(2 * log(mpfr(2)) - 1)},
        {"arctan(t)", "0", "1", mpfr(libration::pi<mpfr>() / 4 - log(mpfr(2)) / 2)},
        {"tg(t)", "0", "1", mpfr(-log(mpfr(cos(one))))},
    });
}

TEST_CASE("powers with exponents that are not constant have their integrals", "[ode][parse]") {
    const precision_scope scope(60);
    const mpfr two = 2;
    check_integrals({
        {"2^t", "0", "2", mpfr(3 / log(two))},
        {"(1/2)^(-t)", "0", "2", mpfr(3 / log(two))},
        {"1^t", "0", "2", 2},
        {"t^t*(log(t) + 1)", "1", "2", 3},
        {"(1 + t)^(2*t)*(2*log(1 + t) + 2*t/(1 + t))", "0", "1", 3},
        // A constant exponent on each branch, of a negative base.
        {"(-1)^floor(t)", "0", "7/2", q(1, 2)},
        {"(t - 2)^3", "0", "4", 0},
        {"(-2)^(-3)", "0", "1", q(-1, 8)},
    });
    const auto value = [](const std::string& text, const std::string& time) {
        return mpfr(solve(problem(text))->states(time, proved_digits(20)).at(0, "y"));
    };
    CHECK(abs(mpfr(value("y' = a^t; y(0) = 0; a = 2", "2") - 3 / log(two))) < pow(mpfr(10), -18));
    CHECK(abs(mpfr(value("y' = r; r = a^(k*t); y(0) = 0; a = 2; k = 1", "2") - 3 / log(two))) < pow(mpfr(10), -18));
    CHECK(abs(mpfr(value("y' = x^y*0 + x; x' = x; x(0) = 1; y(0) = 0", "1") - (exp(mpfr(1)) - 1))) <
          pow(mpfr(10), -18));
    const auto refused = [](const std::string& text) {
        CHECK_THROWS_WITH(solve(problem(text)), Catch::Contains("logarithm of a number that is not positive") ||
                                                    Catch::Contains("base that is not positive"));
    };
    refused("y' = a^t; y(0) = 0; a = -2");
    refused("y' = 0^t; y(0) = 0");
}

TEST_CASE("an angle turns through its jump, and lengths pass 0", "[ode][parse][hybrid]") {
    const precision_scope scope(60);
    const mpfr pi = libration::pi<mpfr>();
    check_integrals({
        {"atan2(sin(t), cos(t))", "0", "7", mpfr(pi * pi / 2 + (49 - pi * pi) / 2 - 2 * pi * (7 - pi))},
        {"atan2(-sin(t), cos(t))", "0", "4", mpfr(-pi * pi / 2 + (pi * pi - 16) / 2 + 2 * pi * (4 - pi))},
        {"atan2(1, 1 - t)", "0", "2", pi},
        {"atan2(-1, 1 - t)", "0", "2", mpfr(-pi)},
        {"atan2(t - 1, 2)", "0", "1", mpfr(log(q(5, 4)) - atan(q(1, 2)))},
        {"atan2(t - 1, -1)", "0", "1", mpfr(-pi + atan(mpfr(1)) - log(mpfr(2)) / 2)},
        {"atan2(t - 1, t - 1)", "2", "3", mpfr(pi / 4)},
        {"hypot(3*t, 4*t)", "0", "2", 10},
        {"hypot(3*t, -4*t)", "-1", "2", q(25, 2)},
        {"hypot(t - 1)", "0", "2", 1},
        {"hypot(0, t, 0)", "-1", "2", q(5, 2)},
        {"hypot(t, 1, 2)", "0", "1", mpfr((sqrt(mpfr(6)) + 5 * asinh(mpfr(1 / sqrt(mpfr(5))))) / 2)},
    });
}

TEST_CASE("piecewise functions have the integrals of their pieces", "[ode][parse][hybrid]") {
    const precision_scope scope(60);
    const mpfr pi = libration::pi<mpfr>();
    check_integrals({
        {"ceil(t)", "0", "5/2", q(9, 2)},
        {"trunc(t - 5/2)", "0", "5", 0},
        {"fix(t - 5/2)", "0", "2", q(-2, 1)},
        {"round(t)", "0", "2", 2},
        {"round(t - 5/2)", "0", "5/2", q(-3, 1)},
        {"mod(t, 2)", "0", "5", q(9, 2)},
        {"mod(t - 2, 3)", "0", "2", 4},
        {"mod(t, 2*pi)", "0", "7", mpfr(2 * pi * pi + (7 - 2 * pi) * (7 - 2 * pi) / 2)},
        {"mod(t, -2)", "0", "2", q(-2, 1)},
        {"fmod(t - 2, 3)", "0", "2", q(-2, 1)},
        {"rem(t, 2)", "0", "3", q(5, 2)},
        {"remainder(t, 2)", "0", "2", 0},
        {"remainder(t, 2)", "1", "2", q(-1, 2)},
        {"if(mod(t, 3) > 2, 1, 0)", "0", "7", 2},
        {"clip(t, 1, 2)", "0", "3", q(9, 2)},
        {"relu(t - 1)", "0", "3", 2},
        {"heaviside(t - 1, 1/2)", "0", "3", 2},
        {"step(t - 1)", "0", "3", 2},
        {"sgn(t - 1)", "0", "3", 1},
        {"max(2 - t, 1/2, t - 2)", "0", "4", q(17, 4)},
        {"min(t, 1, 4 - t)", "0", "4", 3},
        {"fabs(t - 1)", "0", "2", 1},
        {"ifelse(t < 1, 2, 3)", "0", "2", 5},
        {"piecewise(1, t < 2, 3)", "0", "4", 8},
        {"piecewise(1, t < 2, 3, t < 3)", "0", "4", 5},
        {"piecewise(t < 2, 1, t < 3, 3)", "0", "4", 5},
        {"piecewise(t < 2, 1, 3)", "0", "4", 8},
        {"Piecewise((1, t < 2), (3, t < 3), (7, True))", "0", "4", 12},
        {"piecewise(1, t < 1 or t > 3, 2, 1 <= t <= 3)", "0", "4", 6},
        // What is not chosen need not be defined.
        {"piecewise(log(2 - t), t < 1, 0)", "0", "3", mpfr(2 * log(mpfr(2)) - 1)},
    });
}

TEST_CASE("functions to whole numbers have the values of their definitions at halves", "[ode][parse][hybrid]") {
    const std::vector<std::pair<std::string, std::string>> all{
        {"round(5/2)", "3"},         {"round(-5/2)", "-3"},     {"rint(5/2)", "2"},         {"rint(7/2)", "4"},
        {"rint(-5/2)", "-2"},        {"rint(-7/2)", "-4"},      {"rint(9/4)", "2"},         {"ceil(2)", "2"},
        {"ceil(-5/2)", "-2"},        {"trunc(-7/2)", "-3"},     {"floor(-7/2)", "-4"},      {"mod(-7, 3)", "2"},
        {"mod(7, -3)", "-2"},        {"mod(6, 3)", "0"},        {"fmod(-7, 3)", "-1"},      {"fmod(7, -3)", "1"},
        {"remainder(7, 2)", "-1"},   {"remainder(5, 2)", "1"},  {"remainder(-7, 3)", "-1"}, {"remainder(3, 2)", "-1"},
        {"heaviside(0)", "1/2"},     {"heaviside(0, 1)", "1"},  {"heaviside(0, 0)", "0"},   {"atan2(0, -1)/pi", "1"},
        {"atan2(-1, 0)/pi", "-1/2"}, {"sgn(0)", "0"},           {"max(1, 3, 2)", "3"},      {"min(3, 1, 2)", "1"},
        {"clip(5, 1, 2)", "2"},      {"hypot(3, 4, 12)", "13"}, {"(-1)^floor(5)", "-1"}};
    const precision_scope scope(60);
    for (const auto& [call, value] : all) {
        INFO(call);
        const auto found = solve(problem("y' = " + call + "; y(0) = 0"))->states("1", proved_digits(20));
        const auto right = solve(problem("y' = " + value + "; y(0) = 0"))->states("1", proved_digits(20));
        CHECK(mpfr(found.at(0, "y")) == mpfr(right.at(0, "y")));
    }
}

TEST_CASE("calls with another number of arguments, or outside an equation, are refused", "[ode][parse]") {
    const auto refused = [](const std::string& text, const std::string& reason) {
        INFO(text);
        CHECK_THROWS_WITH(ode::parse(text), Catch::Contains(reason));
    };
    refused("y' = mod(y); y(0) = 0",
            "'mod(y)' at line 1, column 6 has another number of arguments than 2: write mod(x, y)");
    refused("y' = max(y); y(0) = 0", "has another number of arguments than 2 or more: write max(a, b)");
    refused("y' = heaviside(y, 1, 2); y(0) = 0", "has another number of arguments than 1 or 2: write heaviside(x)");
    refused("y' = piecewise(1, 2); y(0) = 0", "has no condition for each value but the last");
    refused("y' = piecewise(y > 0, 1, y > 1); y(0) = 0", "has no condition for each value but the last");
    refused("y' = y; y(0) = ceil(3/2)",
            "'ceil' at line 1, column 16 is piecewise, which is supported only in equations");
    // Names of functions of other programs remain free for unknowns and parameters.
    CHECK(ode::parse("round' = mod*round; mod = 2; round(0) = 1").unknowns() == std::vector<std::string>{"round"});
}

}  // namespace ode_written_function_test
