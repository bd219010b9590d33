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

TEST_CASE("what is refused of linear equations, with its place", "[asymptotics][proved]") {
    CHECK(reason_of("(1-t)^2*y' = y; y(0) = 1").find("irregular singular point at t - t0 = 1.0") != std::string::npos);
    CHECK(reason_of("y' = y/(1-t)/3; y(0) = 1", {.within = 1}).find("not decided to be inside") != std::string::npos);
    CHECK(reason_of("(1-t)*(2-t)*y' = y/3; y(0) = 1", {.within = 3}).find("take a RHO below") != std::string::npos);
    // Below the irregular point a bound is proved.
    CHECK_FALSE(law_at("(1-t)^2*y' = y; y(0) = 1", {.within = 0.5}).has_singularities());
}

}  // namespace asymptotics_linear_law_test
