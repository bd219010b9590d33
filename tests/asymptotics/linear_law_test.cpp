// Laws of linear equations compared with fractions of their recurrences, closed forms and values of the gamma function.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/asymptotics/coefficient_law.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/query/problem_coefficients.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"

namespace asymptotics_linear_law_test {

using namespace libration;
using namespace libration::ode;

namespace {

explicit_system typed(const std::string& text) { return explicit_system(parse(text)); }

coefficient_law law_at(const std::string& text, const law_request& asked = {}) {
    const precision_scope scope(40);
    return coefficient_law::of(typed(text), asked);
}

std::string reason_of(const std::string& text, const law_request& asked = {}) {
    try {
        law_at(text, asked);
    } catch (const error& problem) {
        CHECK(problem.kind() == error_kind::undecided);
        return problem.reason();
    }
    return "";
}

// All coefficients from the first of the law on; the last one has so many digits.
void check_against_recurrence(const std::string& text, long last, long digits, const law_request& asked = {}) {
    INFO(text);
    const precision_scope scope(60);
    coefficient_law law = law_at(text, asked);
    law.sharpen();
    const auto exact = exact_coefficients({typed(text), 0, last});
    for (long n = law.first(); n <= last; n += n < 60 ? 1 : 37) {
        INFO("n = " << n);
        CHECK(overlaps(law.value(n), from_rational<ball>(exact.values[static_cast<std::size_t>(n)])));
    }
    const ball a = from_rational<ball>(exact.values[static_cast<std::size_t>(last)]);
    CHECK(overlaps(law.value(last), a));
    CHECK(certainly_less(radius_of(law.value(last)), ball(abs(a) * pow(ball(10), -digits))));
}

}  // namespace

TEST_CASE("linear equations: the law contains the coefficients of the recurrence", "[asymptotics][proved]") {
    // Legendre, Gegenbauer, the hypergeometric equation about 1/3, and with an exponent that is irrational or complex.
    check_against_recurrence("(1-t^2)*y'' - 2*t*y' + 4/9*y = 0; y(0) = 1; y'(0) = 1/2", 300, 40);
    check_against_recurrence("(1-t^2)*y'' - 5/3*t*y' + 1/2*y = 0; y(0) = 1; y'(0) = 1", 300, 40);
    check_against_recurrence("t*(1-t)*y'' + (2/3 - 17/10*t)*y' - 1/10*y = 0; y(1/3) = 1; y'(1/3) = 1", 300, 40);
    check_against_recurrence("(1-t)^2*y'' + 3*(1-t)*y' + y = 0; y(0) = 1; y'(0) = 0", 200, 40);
    check_against_recurrence("(1-t)^2*y'' + 2*y = 0; y(0) = 1; y'(0) = 0", 200, 40);
    // Algebraic singular points, three at one distance, and a third order with logarithms.
    check_against_recurrence("(t^3-2)*y'' + t*y' + y = 0; y(0) = 1; y'(0) = 1", 200, 40);
    check_against_recurrence("(1+t^4)*y''' + t*y' + y = 0; y(0) = 1; y'(0) = 1; y''(0) = 0", 300, 40);
    // Inhomogeneous, and with a pole beside another singular point.
    check_against_recurrence("y'' = t/(1-t)*y' + 1/(1+t)^2*y + t^2; y(0) = 1/3; y'(0) = -2", 200, 30);
    check_against_recurrence("(1-t)*(3-2*t)*y' = (2-t)*y + 1; y(0) = 1", 200, 15);
    // An exponent far below 0, -301/3.
    check_against_recurrence("y' = 301/3*y/(1-t); y(0) = 1", 300, 30);
}

TEST_CASE("equal exponents give powers of the logarithm", "[asymptotics][proved]") {
    // y = log(1 - t)^2/2: H_(n-1)/n
    check_against_recurrence("y' = 1/(1-t); y(0) = 0", 200, 40);
    const std::string square = "(1-t)^2*y''' - 3*(1-t)*y'' + y' = 0; y(0) = 0; y'(0) = 0; y''(0) = 1";
    check_against_recurrence(square, 200, 40);
    const coefficient_law law = law_at(square);
    REQUIRE(law.fixed_points().size() == 1);
    CHECK(law.fixed_points()[0].leading().front().power == 2);
}

// a_n = Gamma(n + 1/3)/(Gamma(1/3) n!).
TEST_CASE("the coefficient of order 10^6 of (1 - t)^(-1/3)", "[asymptotics][proved]") {
    const precision_scope scope(60);
    coefficient_law law = law_at("y' = y/3/(1-t); y(0) = 1");
    law.sharpen();
    constexpr long n = 1'000'000;
    const ball third = ball(1) / 3;
    const ball truth =
        exp(ball(apply(arb_lgamma, ball(third + n)) - apply(arb_lgamma, ball(n + 1)) - apply(arb_lgamma, third)));
    CHECK(overlaps(law.value(n), truth));
    CHECK(certainly_less(radius_of(law.value(n)), ball(truth * pow(ball(10), -40L))));
}

// (1 - t)^(-1/3): a_n/a_(n-1) = 1 - (2/3)/n.
TEST_CASE("the ratios of Domb and Sykes, far beyond those that a recurrence reaches", "[asymptotics][proved]") {
    const precision_scope scope(50);
    coefficient_law law = law_at("y' = y/3/(1-t); y(0) = 1");
    law.sharpen();
    for (const long n : {60L, 1'000'000L}) {
        CHECK(overlaps(law.ratio(n), ball(1) - ball(2) / 3 / n));
    }
    CHECK(certainly_less(radius_of(law.ratio(1'000'000)), pow(ball(10), -30L)));
    CHECK_FALSE(is_finite(law_at("y' = 1/(1+t^2); y(0) = 0").ratio(101)));
}

// atan: only +-i, with the residues of the logarithm.
TEST_CASE("arc tangent and its derivative", "[asymptotics][proved]") {
    const precision_scope scope(50);
    const coefficient_law law = law_at("y' = 1/(1+t^2); y(0) = 0");
    REQUIRE(law.fixed_points().size() == 1);
    for (const long n : {21L, 1001L}) {
        CHECK(overlaps(law.value(n), ball(n % 4 == 1 ? 1 : -1) / n));
        CHECK(law.vanishes(n + 1));
    }
    CHECK(overlaps(law_at("y' = 1/(1+t^2); y(0) = 0", {.derivative = 1}).value(100), ball(1)));
}

TEST_CASE("apparent singular points and entire solutions have no terms", "[asymptotics][proved]") {
    const coefficient_law apparent = law_at("y' = -2*y/(1-t); y(0) = 1");  // (1 - t)^2
    CHECK_FALSE(apparent.has_singularities());
    CHECK(apparent.rho() > 1);
    const precision_scope scope(40);
    CHECK(certainly_less(apparent.error_bound(40), pow(ball(10), -15L)));
    const coefficient_law sine = law_at("y'' = -y; y(0) = 0; y'(0) = 1", {.within = 20});
    CHECK_FALSE(sine.has_singularities());
    ball factorial(1);
    for (long n = 1; n < 80; ++n) {
        factorial = factorial / n;
        CHECK((n % 2 == 0 || certainly_less(factorial, ball(sine.error_bound(n)))));
    }
    // The mean of |sin| on the circle is below cosh 20, and so is the bound.
    CHECK(certainly_less(sine.mean().exact(), ball(cosh(ball(20)) * 2)));
}

// a_n of 2F1(a, b; c; t) is the product of (a + k)(b + k)/((c + k)(1 + k)), k < n, which balls compute without the equation.
void check_hypergeometric(const std::string& text, const rational& a, const rational& b, const rational& c,
                          const ball& first, long digits) {
    INFO(text);
    const precision_scope scope(60);
    coefficient_law law = law_at(text);
    law.sharpen();
    ball truth = first;
    for (long n = 0; n <= 1000; ++n) {
        if (n >= law.first() && (n < law.first() + 20 || n % 97 == 0 || n == 1000)) {
            INFO("n = " << n);
            CHECK(overlaps(law.value(n), truth));
        }
        if (n == 1000) {
            CHECK(certainly_less(radius_of(law.value(n)), ball(abs(truth) * pow(ball(10), -digits))));
        }
        const rational k(static_cast<int>(n));
        truth *= from_rational<ball>(rational((a + k) * (b + k) / ((c + k) * (1 + k))));
    }
}

TEST_CASE("solutions from a singular initial point", "[asymptotics][proved]") {
    // The elliptic integral K(m), 2F1 with a logarithm and with a power at 1, and one whose other exponent at 0 is -3/2.
    check_hypergeometric("t*(1-t)*y'' + (1-2*t)*y' - y/4 = 0; y(0) = pi/2; y'(0) = pi/8", rational(1, 2),
                         rational(1, 2), 1, ball(pi<ball>() / 2), 40);
    check_hypergeometric("t*(1-t)*y'' + (1/3-2*t)*y' - y/4 = 0; y(0) = 1; y'(0) = 3/4", rational(1, 2), rational(1, 2),
                         rational(1, 3), ball(1), 40);
    check_hypergeometric("t*(1-t)*y'' + (5/2-3*t)*y' - 3/4*y = 0; y(0) = 1; y'(0) = 3/10", rational(1, 2),
                         rational(3, 2), rational(5, 2), ball(1), 40);
    const precision_scope scope(60);
    const coefficient_law elliptic = law_at("t*(1-t)*y'' + (1-2*t)*y' - y/4 = 0; y(0) = pi/2; y'(0) = pi/8");
    REQUIRE(elliptic.fixed_points().size() == 1);
    CHECK(elliptic.fixed_points()[0].leading().front().power == 1);
    CHECK(contains(elliptic.fixed_points()[0].leading().front().coefficient.re, ball(-1) / 2));
    // log(1 + t)/t by an inhomogeneous equation: a_n = (-1)^n/(n + 1)
    coefficient_law quotient = law_at("t*y' = -y + 1/(1+t); y(0) = 1");
    quotient.sharpen();
    for (const long n : {60L, 61L, 1000L}) {
        CHECK(overlaps(quotient.value(n), ball(n % 2 == 0 ? 1 : -1) / (n + 1)));
    }
    // J_0 is entire: a_(2k) = (-1/4)^k/k!^2, below the bound of any rho.
    const coefficient_law bessel = law_at("y'' + y'/t + y = 0; y(0) = 1; y'(0) = 0", {.within = 10});
    CHECK_FALSE(bessel.has_singularities());
    CHECK(bessel.stride() == 2);
    ball a(1);
    for (long k = 1; k < 60; ++k) {
        a = a / (4 * k * k);
        CHECK(certainly_less(a, ball(bessel.error_bound(2 * k))));
    }
    // The mean of |J_0| on the circle is below I_0(10) = 2815.7.
    CHECK(certainly_less(bessel.mean().exact(), ball(3 * 2816)));
    CHECK(reason_of("y'' + y'/t + y = 0; y(0) = 1; y'(0) = 0").find("has an entire solution") != std::string::npos);
}

// (1 - t)^(1/3) + .. by an equation whose leading coefficient has multiple zeros, the paths of which pass two of them.
TEST_CASE("multiple zeros of the leading coefficient", "[asymptotics][proved]") {
    check_against_recurrence("(1-t)^2*(1+t^2)^2*y'' + y = 0; y(0) = 1; y'(0) = 1/3", 300, 10);
}

TEST_CASE("what is refused of linear equations, with its place", "[asymptotics][proved]") {
    CHECK(reason_of("(1-t)^2*y' = y; y(0) = 1").find("irregular singular point at t - t0 = 1.0") != std::string::npos);
    CHECK(reason_of("y' = y/(1-t)/3; y(0) = 1", {.within = 1}).find("not decided to be inside") != std::string::npos);
    CHECK(reason_of("(1-t)*(2-t)*y' = y/3; y(0) = 1", {.within = 3}).find("take a RHO below") != std::string::npos);
    // Below the irregular point a bound is proved.
    CHECK_FALSE(law_at("(1-t)^2*y' = y; y(0) = 1", {.within = 0.5}).has_singularities());
}

}  // namespace asymptotics_linear_law_test
