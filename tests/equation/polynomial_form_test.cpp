// The polynomial system has the solution of the given one: its coefficients by products alone compared with those by
// the kernels of the functions.
#include "libration/equation/polynomial_form.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/function/ball_values.hpp"
#include "libration/scalar/error.hpp"

namespace equation_polynomial_form_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr int order = 24;

// The values of the added unknowns from those of the given ones, by their definitions.
solution_state<mpfr> lifted_start(const polynomial_form& of, const explicit_system& given) {
    expression_values<mpfr> values(of.leaves, constant_value<mpfr>::of(given.point()));
    for (const auto& of_unknown : given.starts()) {
        for (const number& each : of_unknown) {
            values.push_back(constant_value<mpfr>::of(each));
        }
    }
    for (const ode::expression& each : of.added) {
        values.push_back(values.of(each));
    }
    solution_state<mpfr> state;
    for (const mpfr& each : values.values()) {
        state.push_back({each});
    }
    return state;
}

}  // namespace

// Coefficients near 1 by up to 24 sums of 24 products, in some 30 steps: 24*24*30 units in the last place exceed the
// loss of either method.
TEST_CASE("a lifted system has the coefficients of the given one", "[ode]") {
    const std::string text = GENERATE(
        "y' = exp(-y) + t; y(0) = 1/3", "y' = log(2 + y); y(0) = 1/2", "y' = sqrt(3 + y*t); y(0) = 1",
        "y' = (2 + y)^(2/3); y(0) = 1/5", "y' = (2 + y)^(-3/2) + y^3; y(0) = 1/5", "y' = (2 + y)^pi; y(0) = -1/2",
        "y'' = -sin(y)*cos(2*t); y(0) = 1; y'(0) = 1/2", "y' = tan(y/2) + 1; y(0) = 1/4", "y' = asin(y/3); y(0) = 1",
        "y' = acos(y/3)/2; y(0) = 1", "y' = atan(y*t) - y; y(0) = 1", "y' = sinh(y)/4; y(0) = 1/2",
        "y' = cosh(y)/4; y(0) = 1/2", "y' = tanh(y) - t^2; y(0) = 1/2", "y' = y^(-2)/(1 + t) + 1/y; y(0) = 2",
        "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2); x(0) = 2/5; x'(0) = 0; y(0) = 0; y'(0) = 2",
        "y' = (2 + y)^(2/7) + y/pi; y(0) = 1/5", "y' = ((2 + y)/3)^70 + sin(2)*y; y(0) = 1/5",
        "y' = exp(sin(exp(y/3))); y(0) = 0", "y' = log(2 + sqrt(1 + y^2)); y(0) = 1");
    CAPTURE(text);
    const precision_scope scope(60);
    const explicit_system given(parse(text));
    const polynomial_form polynomial = lifted(given);
    const tape of_given = tape::about_points(given);
    const tape of_lifted = tape::about_points(polynomial.system);
    for (const tape_step& each : of_lifted.steps()) {
        CHECK((is_linear(each.kind) || each.kind == operation::product || each.kind == operation::square));
    }
    taylor_expansion<mpfr> expected(of_given, order);
    taylor_expansion<mpfr> actual(of_lifted, order);
    solution_state<mpfr> start;
    for (const auto& of_unknown : given.starts()) {
        start.emplace_back();
        for (const number& each : of_unknown) {
            start.back().push_back(constant_value<mpfr>::of(each));
        }
    }
    expected.about(constant_value<mpfr>::of(given.point()), start);
    actual.about(constant_value<mpfr>::of(given.point()), lifted_start(polynomial, given));
    int at = 0;
    for (int i = 0; i < static_cast<int>(given.unknowns().size()); ++i) {
        for (int n = 0; n <= order; ++n) {
            CAPTURE(i, n);
            const mpfr& c = expected.coefficients(i)[n];
            const mpfr difference = abs(mpfr(c - actual.coefficients(at)[n]));
            CHECK(difference <= mpfr(24 * 24 * 30 * epsilon<mpfr>() * (abs(c) + 1)));
        }
        at += given.unknowns()[static_cast<std::size_t>(i)].order;
    }
}

TEST_CASE("a singular start is not lifted, and says so", "[ode]") {
    const explicit_system lane_emden(parse("y'' + 2/t*y' + y^3 = 0; y(0) = 1; y'(0) = 0"));
    CHECK_THROWS_WITH(lifted(lane_emden), Catch::Contains("singular"));
}

// sinc(u)' = (cos u - sinc u)/u u' divides by 0 where u is 0, and nowhere else.
TEST_CASE("a function is lifted where its derivative does not divide by 0", "[ode]") {
    const auto count = [](const std::string& text) { return lifted(explicit_system(parse(text))).leaves.size(); };
    CHECK_THROWS_WITH(count("y' = sinc(y); y(0) = 0"), Catch::Contains("takes sinc of 0"));
    CHECK(count("y' = sinc(y); y(0) = 1") > 1);
    CHECK(count("y' = sinc(y); y(0) = pi") > 1);
}

// V' = f'(y) V for y' = y^2 in closed form: y = c/(1 - c t), dy/dc = 1/(1 - c t)^2, whose coefficients are (n + 1) c^n.
TEST_CASE("variations are the derivatives by the start", "[ode]") {
    const explicit_system given(parse("y' = y^2; y(0) = 2/3"));
    const polynomial_form polynomial = lifted(given);
    const explicit_system varied = with_variations(polynomial);
    const tape made = tape::about_points(varied);
    taylor_expansion<rational> expansion(made, order);
    expansion.about(0, {{rational(2, 3)}, {rational(1)}});
    rational power = 1;
    for (int n = 0; n <= order; ++n) {
        CHECK(expansion.coefficients(1)[n] == power * (n + 1));
        power *= rational(2, 3);
    }
}

TEST_CASE("linear equations with entire coefficients have entire solutions", "[ode]") {
    const auto entire = [](const std::string& text) { return has_entire_solutions(explicit_system(parse(text))); };
    for (const std::string text :
         {"y' = (t^2 + 1)*y + exp(t); y(0) = 1", "y'' = sinh(2*t)*y + cosh(t) - sin(t)*cos(t)*y'; y(0) = 1; y'(0) = 0",
          "y' = y/2 + t/3 + sin(t)/pi + t*y/(2 + pi); y(0) = 1", "y' = exp(sin(t))*y; y(0) = 1",
          "y' = tan(1)*y; y(0) = 1", "y' = bessel_j(2, t)*y; y(1) = 1", "x' = x; y' = y*sin(t) + x; x(0) = 1; y(0) = 1",
          "x' = x; y' = x*y; x(0) = 1; y(0) = 1", "y' = sin(t)/t*y; y(1) = 1"}) {
        INFO(text);
        CHECK(entire(text));
    }
    for (const std::string text :
         {"y' = y/t; y(1) = 1", "y' = sqrt(t)*y; y(1) = 1", "y' = t^(-1)*y; y(1) = 1", "y' = t^(1/2) + y; y(1) = 1",
          "y' = log(t)*y; y(1) = 1", "y' = y + tan(t); y(0) = 1", "y' = y^2; y(0) = 1", "y' = exp(1/t)*y; y(1) = 1",
          "y' = t^pi*y; y(1) = 1", "y' = (1/t + t)*y; y(1) = 1", "y' = (t + 1/t)*y; y(1) = 1",
          "y' = (2/t)*t*y + y^2; y(1) = 1", "y' = (t + sqrt(t))^2*y; y(1) = 1", "y' = y*log(t)/t; y(1) = 1",
          "y' = t/(1 + t)*y; y(1) = 1", "y' = bessel_j(1/2, t)*y; y(1) = 1",
          "x' = x^2; y' = x*y; x(0) = 1; y(0) = 1"}) {
        INFO(text);
        CHECK_FALSE(entire(text));
    }
}

// Values of functions of several values are continued along paths, all others recomputed.
TEST_CASE("functions of several values are given unknowns of paths", "[ode]") {
    const auto given = [](const std::string& text) {
        return lifted_for_paths(explicit_system(parse(text))).lifted.given;
    };
    for (const std::string f : {"log", "sqrt", "asin", "acos", "atan"}) {
        INFO(f);
        CHECK(given("y' = " + f + "(1/2 + y/8); y(0) = 1/3") > 1);
    }
    CHECK(given("y' = (1 + y)^(1/3); y(0) = 1") > 1);
    for (const std::string f : {"exp", "sin", "cosh", "tan", "1/"}) {
        INFO(f);
        CHECK(given("y' = " + f + "(1/2 + y/8); y(0) = 1/3") == 1);
    }
}

// The given unknowns come first, in an order that differs from that of the definitions: 1/w, w = u^r, precedes 1/u.
TEST_CASE("the unknowns of paths have the values of their functions", "[ode]") {
    const precision_scope scope(40);
    const explicit_system system(parse("y' = 1/(2-t)^pi + exp(sqrt(y))/y; y(0) = 3"));
    const polynomial_form once = lifted(system);
    const path_form paths = lifted_for_paths(system);
    const auto all = lifted_values(once, mpfr(0), std::vector<mpfr>{3});
    const auto on_path = lifted_values(paths.lifted, mpfr(0), paths.given_of(all));
    REQUIRE(on_path.size() == all.size());
    for (std::size_t i = 0; i < on_path.size(); ++i) {
        const auto same = std::ranges::find(once.leaves, paths.lifted.leaves[i].name(), &ode::expression::name);
        REQUIRE(same != once.leaves.end());
        const mpfr& value = all[static_cast<std::size_t>(same - once.leaves.begin())];
        CHECK(abs(mpfr(on_path[i] - value)) <= 8 * epsilon<mpfr>() * abs(value));  // at most 8 roundings
    }
    // Their derivatives by differences, whose error is about h times the second derivative.
    const auto given = paths.given_of(all);
    const auto varied = varied_values(paths.lifted, mpfr(0), given);
    const mpfr h("1e-20");
    for (std::size_t j = 0; j < given.size(); ++j) {
        auto moved = given;
        moved[j] += h;
        const auto there = lifted_values(paths.lifted, mpfr(0), moved);
        for (std::size_t i = 0; i < there.size(); ++i) {
            const mpfr& derivative = varied[on_path.size() * (j + 1) + i];
            CHECK(abs(mpfr((there[i] - on_path[i]) / h - derivative)) <= 100 * h);
        }
    }
}

// Each of 70 products rounds by half a unit.
TEST_CASE("values of powers by products and by functions", "[ode]") {
    const precision_scope scope(40);
    const std::vector<ode::expression> leaves{unknown("y0")};
    expression_values<mpfr> values(leaves, mpfr(0));
    values.push_back(mpfr(3));
    const auto of = [&](const rational& exponent) { return values.of(pow(leaves[0], ode::expression(exponent))); };
    const auto near = [](const mpfr& a, const mpfr& b) { return abs(mpfr(a - b)) <= 70 * epsilon<mpfr>() * abs(b); };
    CHECK(of(5) == 243);
    CHECK(near(of(-2), mpfr(1) / 9));
    CHECK(near(of(70), pow(mpfr(3), 70)));
    CHECK(near(of(rational(1, 2)), sqrt(mpfr(3))));
    CHECK(near(values.of(pow(leaves[0], parse_constant("pi"))), pow(mpfr(3), pi<mpfr>())));
}

}  // namespace equation_polynomial_form_test
