// Laws of systems compared with closed forms and with coefficients by the recurrence.
#include "libration/asymptotics/movable_terms.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "libration/asymptotics/coefficient_law.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/query/problem_coefficients.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/exponent_range.hpp"

namespace asymptotics_movable_terms_test {

using namespace libration;
using namespace libration::ode;

namespace {

coefficient_law law_at(const std::string& text, std::size_t unknown = 0) {
    const precision_scope scope(40);
    law_request asked;
    asked.unknown = unknown;
    return coefficient_law::of(explicit_system(parse(text)), asked);
}

// All n from the least one on, and the width at the last.
void check_against_recurrence(const std::string& text, std::size_t unknown, long last, long digits) {
    INFO(text);
    const coefficient_law law = law_at(text, unknown);
    const explicit_system system{parse(text)};
    const auto all = proved_coefficients({system, 0, last}, 40);
    REQUIRE(law.first(3) <= last - 20);
    const precision_scope scope(60);
    for (long n = law.first(); n <= last; n += n + 29 > last ? std::max(1L, last - n) : 29) {
        INFO("n = " << n);
        const proved_decimal& of = all.values[static_cast<std::size_t>(n) * system.unknowns().size() + unknown];
        ball a;
        const std::string typed = of.text + " +/- " + of.uncertainty;
        arb_set_str(a.handle(), typed.c_str(), ball::working_bits());
        const ball value = law.value(n);
        CHECK(overlaps(value, a));
        if (n == last) {
            CHECK(certainly_less(radius_of(value), ball(abs(a) * pow(ball(10), -digits))));
        }
    }
}

}  // namespace

// x = -u'/u, u = 1 - t - t^2/2: a_n = t_1^(-n-1) + t_2^(-n-1)
TEST_CASE("the law of coupled Riccati equations is that of their two poles", "[asymptotics][proved]") {
    const whole_exponent_range exponents;
    const coefficient_law law = law_at("x' = x^2 + y; y' = x*y; x(0) = 1; y(0) = 1");
    CHECK(law.first() == 0);
    const precision_scope scope(60);
    const ball root = sqrt(ball(3));
    for (const long n : {0L, 1L, 5L, 100L, 1000L, 1000000L}) {
        const ball exact = pow(ball(root - 1), -n - 1) + pow(ball(-1 - root), -n - 1);
        CHECK(overlaps(law.value(n), exact));
        if (n >= 1000) {
            CHECK(certainly_less(radius_of(law.value(n)), ball(abs(exact) * pow(ball(10), -40L))));
        }
    }
}

// (1 - 2 t)^(-1/2): a_n = 2^n Gamma(n + 1/2)/(Gamma(1/2) n!)
TEST_CASE("the law at a branch point of a system", "[asymptotics][proved]") {
    const coefficient_law law = law_at("y' = y*w; w' = 2*w^2; y(0) = 1; w(0) = 1");
    const precision_scope scope(60);
    ball a(1);
    for (long n = 1; n <= 400; ++n) {
        a = a * (2 * n - 1) / n;
        if (n >= law.first(9)) {
            CHECK(overlaps(law.value(n), a));
        }
    }
    CHECK(certainly_less(radius_of(law.value(400)), ball(a * pow(ball(10), -40L))));
}

TEST_CASE("laws with logarithms and complex exponents contain the coefficients of the recurrence",
          "[asymptotics][proved]") {
    check_against_recurrence("x' = x - x*y; y' = x*y - y; x(0) = 2; y(0) = 1", 0, 260, 15);
    check_against_recurrence("x'' = -x'/5 - x - x^3; x(0) = 1; x'(0) = 0", 0, 200, 15);
}

TEST_CASE("laws with long proofs contain the coefficients of the recurrence", "[.long][asymptotics][proved]") {
    check_against_recurrence("f''' = -f*f''/2; f(0) = 0; f'(0) = 0; f''(0) = 1", 0, 260, 7);
    check_against_recurrence("x' = x - x*y; y' = x*y - y; x(0) = 2; y(0) = 1", 1, 200, 12);
    check_against_recurrence("x' = 10*(y-x); y' = x*(28-z)-y; z' = x*y - 8/3*z; x(0) = 1; y(0) = 1; z(0) = 1", 0, 300,
                             6);
}

// y = sqrt(1 - t) (1 - (s - 1) log(1 - t)), u = (1 - t)^(1/4): the logarithm has the factor s - 1 by a leading term of two vanishing unknowns,
// without a positive power of x, so that s = 1 does not show it.
TEST_CASE("logarithms whose factor depends on a free number of the leading terms", "[asymptotics][proved]") {
    check_against_recurrence(
        "x' = x^2; u' = -x*u/4; y' = -x*y/2 + (s-1)*x*u^2; s' = 0; x(0) = 1; u(0) = 1; y(0) = 1; s(0) = 2", 2, 200, 8);
    check_against_recurrence(
        "x' = x^2; u' = -x*u; y' = -2*x*y + (s-1)*x*u^2; s' = 0; x(0) = 1; u(0) = 1; y(0) = 1; s(0) = 2", 2, 200, 8);
}

// x = (1 - t)^(-1/5) and smaller terms, a series in (1 - t/t*)^(1/30).
TEST_CASE("series in small powers have all of them", "[asymptotics][proved]") {
    check_against_recurrence("x' = x^6/5 + y + 1; y' = x^5*y/6; x(0) = 1; y(0) = 1", 0, 300, 8);
}

// A slit that ends beyond the reach, and an index below the least one.
TEST_CASE("terms of a movable point keep to their domain", "[asymptotics]") {
    const precision_scope scope(30);
    const explicit_system system{parse("y' = y*w; w' = 2*w^2; y(0) = 1; w(0) = 1")};
    const chart_atlas atlas(system, 1.6, 0);
    const movable_point at = movable_point_near(system, atlas, 0, complex_ball(ball(1) / 2));
    CHECK_THROWS_AS(movable_terms(at, 1.2), precision_exhausted);
    CHECK_THROWS_AS(movable_terms(at, 0.4), precision_exhausted);
    const movable_terms terms(at, 0.75);
    const auto uniform = terms.uniform(3);
    for (const long n : {terms.first(3), 50L, 400L}) {
        const ball by = uniform.circle * pow(ball(ball(3) / 4), -n) +
                        uniform.slit * pow(ball(ball(1) / 2), -n) *
                            exp(ball(apply(arb_lgamma, ball(ball(n) - from_rational<ball>(uniform.index))) -
                                     apply(arb_lgamma, ball(n + 1))));
        CHECK_FALSE(certainly_less(ball(by * 2), terms.bound(n, 3)));
    }
}

// Exponents 5/2 +- i sqrt(47)/2: |x^r| grows by exp(pi sqrt(47)/2) = 47600 around the point, so that the expansion reaches a hundredth.
TEST_CASE("the law of Henon and Heiles' system", "[.long][asymptotics][proved]") {
    const whole_exponent_range exponents;
    check_against_recurrence(
        "x'' = -x - 2*x*y; y'' = -y - x^2 + y^2; x(0) = 1/5; x'(0) = 1/10; y(0) = 1/10; y'(0) = 1/5", 0, 1000, 3);
}

// x^3 log x at 1, as the only term: a_n = 6 (n - 4)!/n!, and the integral beyond the circle is what the bound has to contain.
TEST_CASE("the jump of a single logarithm", "[asymptotics][proved]") {
    const precision_scope scope(40);
    movable_point at;
    at.place = complex_ball(1);
    at.real = true;
    at.reach = 0.9;
    at.least_weight = 60;
    at.terms = {{complex_ball(3), rational(3), {complex_ball(0), complex_ball(1)}}};
    const movable_terms terms(at, 1.5);
    for (const long n : {20L, 40L, 300L}) {
        ball exact(6);
        for (long k = 0; k < 4; ++k) {
            exact /= n - k;
        }
        CHECK(overlaps(terms.coefficient(n, 5), exact));
        // with J = 1 it is not summed: then it is the error
        CHECK_FALSE(certainly_less(terms.bound(n, 1), exact));
        CHECK(certainly_less(terms.bound(n, 1), ball(exact * 40)));
        // the part of the slit beyond 1.5: int of w^3 (1 + w)^(-n-1) from 1/2 on
        ball beyond(0);
        for (long k = 0; k < 4; ++k) {
            const ball sign(k % 2 == 0 ? -1 : 1);
            const long binomial = k == 0 || k == 3 ? 1 : 3;
            beyond += sign * binomial * pow(ball(ball(3) / 2), k - n) / (n - k);
        }
        CHECK_FALSE(certainly_less(terms.bound(n, 5), abs(beyond)));
    }
}

}  // namespace asymptotics_movable_terms_test
