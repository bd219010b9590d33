// The law as an object: coefficients, ratios and roots against closed forms.
#include "libration/problem/proved_law.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace problem_proved_law_test {

using namespace libration;

namespace {

proved_law law_of_text(const std::string& text, const std::string& show = "") {
    return {ode::explicit_system(ode::parse(text)), {.show = show}, proved_digits(30)};
}

ball ball_of(const std::string& text, const std::string& bound) {
    ball result;
    const std::string with_bound = text + " +/- " + bound;
    arb_set_str(result.handle(), with_bound.c_str(), ball::working_bits());
    return result;
}

void check_value(const known_value& value, const ball& truth, long digits) {
    REQUIRE(value.decimal);
    CHECK(overlaps(ball_of(value.decimal->text, value.decimal->uncertainty), truth));
    CHECK(certainly_less(ball_of(value.decimal->uncertainty, "0"), ball(abs(truth) * pow(ball(10), 1 - digits))));
}

}  // namespace

// (1 - 2t)^(-1/2): a_n = (2n)!/(2^n n!^2), a_n/a_(n-1) = 2 - 1/n exactly, which is the line itself.
TEST_CASE("coefficients, ratios and roots of a branch point", "[problem][asymptotics]") {
    const precision_scope scope(60);
    const auto law = law_of_text("y' = y^3; y(0) = 1");
    CHECK(law.stride() == 1);
    check_value(law.radius(20), ball(1) / 2, 20);
    check_value(law.limit(20), ball(2), 20);
    check_value(law.exponent(20), ball(-1) / 2, 20);
    ball product(1);
    for (long n = 1; n <= 300; ++n) {
        product = product * (ball(2) - ball(1) / n);
    }
    check_value(law.coefficient(300, 20).value, product, 20);
    for (const long n : {1L, 7L, 300L, 100'000L}) {
        INFO("n = " << n);
        const law_ratio found = law.ratio(n, 20);
        const ball truth = ball(2) - ball(1) / n;
        check_value(found.ratio, truth, 20);
        check_value(found.line, truth, 20);
        CHECK_FALSE(found.deviation.empty());
    }
    CHECK(law.ratio(7, 20).by == "recurrence");
    CHECK(law.ratio(300, 20).by == "law");
    const law_root root = law.root(300, 20);
    const ball truth = pow(product, ball(ball(-1) / 300));
    check_value(root.root, truth, 20);
    CHECK(
        certainly_less(ball(abs(ball(truth - ball(1) / 2)) * (1 - pow(ball(10), -2L))), ball_of(root.deviation, "0")));
}

// 1/(1 + t^2), t^2 between the coefficients.
TEST_CASE("ratios of a law with a stride are those of its nonzero coefficients", "[problem][asymptotics]") {
    const precision_scope scope(60);
    const auto law = law_of_text("y' = -2*t*y^2; y(0) = 1");
    CHECK(law.stride() == 2);
    CHECK(law.residue() == 0);
    check_value(law.ratio(400, 15).ratio, ball(-1), 15);
    CHECK(law.coefficient(401, 15).by == "symmetry");
    CHECK_THROWS_AS(law.ratio(401, 15), error);
    CHECK_THROWS_AS(law.ratio(0, 15), error);
    CHECK_THROWS_AS(law.root(401, 15), error);
    CHECK_THROWS_AS(law_of_text("y' = y^2; y(0) = 1", "z"), error);
}

// 1/(1 - t + t^2): 1, 1, 0, -1, -1, 0, .. without a symmetry, which fractions decide up to n = 2000.
TEST_CASE("zeros among the coefficients are decided by fractions", "[problem][asymptotics]") {
    const auto law = law_of_text("y' = (1 - 2*t)*y^2; y(0) = 1");
    CHECK(law.stride() == 1);
    for (const long n : {2L, 302L, 2000L}) {
        const auto found = law.coefficient(n, 20);
        REQUIRE(found.value.decimal);
        CHECK(found.value.decimal->text == "0");
        CHECK(found.value.decimal->uncertainty == "0");
        CHECK(found.by == "recurrence");
        CHECK(found.complete);
        CHECK_THROWS_WITH(law.root(n, 20), Catch::Contains("has the coefficient 0"));
    }
    const precision_scope scope(60);
    check_value(law.coefficient(301, 20).value, ball(1), 20);
    check_value(law.coefficient(2001, 20).value, ball(-1), 20);
    CHECK_FALSE(law.ratio(303, 20).ratio.decimal);
    // (7/5)^n times these, whose fractions are long, so that the recurrence in balls would need 10000 digits.
    const auto scaled = law_of_text("y' = (7/5 - 98/25*t)*y^2; y(0) = 1").coefficient(302, 20);
    REQUIRE(scaled.value.decimal);
    CHECK(scaled.value.decimal->text == "0");
    CHECK(scaled.value.bound.empty());
    const auto derivative = law_of_text("y' = (7/5 - 98/25*t)*y^2; y(0) = 1", "y'").coefficient(301, 20);
    REQUIRE(derivative.value.decimal);
    CHECK(derivative.value.decimal->text == "0");
}

// (1 - t)^(1/3) (1 - 2t/3), whose constants are computed anew for more digits, with the callback of the request.
TEST_CASE("a law calls back as long as it exists", "[problem][asymptotics]") {
    long calls = 0;
    request how = proved_digits(10);
    how.stage = [&](const std::string&) { ++calls; };
    const auto made = [&] {
        return proved_law(ode::explicit_system(ode::parse("3*(1-t)*(3-2*t)*y' = (8*t-9)*y; y(0) = 1")), {},
                          request(how));
    };
    const proved_law law = made();
    const long before = calls;
    CHECK(before > 0);
    const precision_scope scope(160);
    ball product(1);
    ball last(0);
    for (long n = 1; n <= 500; ++n) {
        last = product;
        product *= (ball(n - 1) - ball(1) / 3) / n;
    }
    check_value(law.coefficient(500, 100).value, product - last * 2 / 3, 100);
    CHECK(calls > before);
}

// The deviation is a bound: a_n of y' = y^3 + t by exact fractions is farther from the line than the law's terms of it leave.
TEST_CASE("the deviation bounds the distance from the line", "[problem][asymptotics]") {
    const precision_scope scope(60);
    const auto law = law_of_text("y' = y^3 + t; y(0) = 1");
    const law_ratio at = law.ratio(100, 20, proved_law::source::law);
    const law_ratio by_recurrence = law.ratio(100, 30);
    REQUIRE(at.ratio.decimal);
    REQUIRE(by_recurrence.line.decimal);
    CHECK(by_recurrence.by == "recurrence");
    const ball ratio = ball_of(by_recurrence.ratio.decimal->text, by_recurrence.ratio.decimal->uncertainty);
    const ball line = ball_of(by_recurrence.line.decimal->text, by_recurrence.line.decimal->uncertainty);
    CHECK(overlaps(ratio, ball_of(at.ratio.decimal->text, at.ratio.decimal->uncertainty)));
    CHECK(certainly_less(abs(ball(ratio - line)), ball_of(at.deviation, "0")));
    // |t1 a_n/a_(n-1) - 1 + 1/(2n)| <= 0.01864 n^-4 by DS1 of docs/asymptotics.md, 0.995 of it at n = 100
    CHECK(certainly_less(ball_of(at.deviation, "0"), ball(ball(1864) / pow(ball(10), 13L) / ball_of("0.4746", "0"))));
}

}  // namespace problem_proved_law_test
