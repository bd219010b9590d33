// Laws compared with closed forms, and with coefficients that the recurrence of the equation gives as fractions.
#include "libration/asymptotics/coefficient_law.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/query/problem_coefficients.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "proved.hpp"

namespace asymptotics_coefficient_law_test {

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

// The law contains the fractions of the recurrence for some n, and is narrow for the last of them.
void check_against_fractions(const std::string& text, const std::vector<long>& orders, long digits) {
    INFO(text);
    const precision_scope scope(80);
    const coefficient_law law = law_at(text);
    const auto exact = exact_coefficients({typed(text), 0, orders.back()});
    const std::size_t unknowns = typed(text).unknowns().size();
    for (const long n : orders) {
        INFO("n = " << n);
        const ball a = from_rational<ball>(exact.values[static_cast<std::size_t>(n) * unknowns]);
        const ball value = law.value(n);
        CHECK(overlaps(value, a));
        if (n == orders.back()) {
            CHECK(certainly_less(radius_of(value), ball(abs(a) * pow(ball(10), -digits))));
        }
    }
}

}  // namespace

TEST_CASE("poles: the law contains all coefficients of the recurrence", "[asymptotics][proved]") {
    const std::vector<long> all{0, 1, 2, 3, 7, 20, 61, 130};
    check_against_fractions("y' = 1 + y^2; y(0) = 1/3", all, 12);
    check_against_fractions("y' = 1 + t - y + 2*y^2; y(0) = 1/2", all, 12);
    check_against_fractions("y'' = 6*y^2 + t; y(0) = 1; y'(0) = 0", all, 20);
    check_against_fractions("y'' = 2*y^3 + t*y + 1/3; y(0) = 1; y'(0) = -1/2", all, 20);
    check_against_fractions("x'' = -x^3; x(0) = 1; x'(0) = 1/2", all, 10);
    check_against_fractions("y'' = 6*y^2 - 1/2; y(0) = 1/5; y'(0) = -1/3", all, 8);
    // sn, by an equation along the solution whose linear coefficient is from the third derivative, since sn(0) = 0
    check_against_fractions("x' = y*z; y' = -x*z; z' = -x*y/4; x(0) = 0; y(0) = 1; z(0) = 1", {0, 1, 2, 3, 7, 61, 131},
                            10);
}

TEST_CASE("branch points: the law contains the coefficients of the recurrence", "[asymptotics][proved]") {
    const std::vector<long> all{1, 2, 5, 20, 61, 100, 200};
    check_against_fractions("y' = y^3 + t; y(0) = 1", all, 25);
    check_against_fractions("y' = y^4 + t; y(0) = 1", all, 20);
    check_against_fractions("y' = -y^3 + t; y(0) = -1", all, 3);
    check_against_fractions("x'' = 2*(1-x^2)*x' - x; x(0) = 1; x'(0) = 0", all, 2);
    check_against_fractions("y' = 1/y; y(0) = 1", all, 20);
    check_against_fractions("y' = (2 + t)/y; y(0) = 1", all, 20);
    check_against_fractions("y' = t/(1 + y); y(0) = 1", all, 3);
    check_against_fractions("y' = 1/y^2; y(0) = 1", all, 20);
    check_against_fractions("y' = t/(2*y^2); y(0) = 1", {2, 20, 60, 100, 200}, 20);
    // In the time of the chart y is linear and t a cubic: discs of any radius.
    check_against_fractions("y' = 1/(1 - y^2); y(0) = 1/3", all, 20);
    check_against_fractions("y' = 1/(1 + y^2); y(0) = 0", {1, 3, 5, 21, 61, 101, 201}, 20);
}

// tan t: a_n = 2^(n+2) (2^(n+1) - 1) zeta(n+1)/(2 pi)^(n+1) .. for odd n: a_n = 2 (2/pi)^(n+1) (1 - 2^-(n+1)) zeta(n+1).
TEST_CASE("the coefficient of order 10^6 of the tangent", "[asymptotics][proved]") {
    const whole_exponent_range exponents;
    const precision_scope scope(120);
    coefficient_law law = law_at("y' = 1 + y^2; y(0) = 0");
    law.sharpen();
    constexpr long n = 1'000'001;
    const ball tangent = pow(ball(ball(2) / pi<ball>()), n + 1) * 2;  // zeta(n+1) (1 - 2^-(n+1)) = 1 + 3^-(n+1) + ..
    CHECK(overlaps(law.value(n), tangent));
    CHECK(certainly_less(radius_of(law.value(n)), ball(tangent * pow(ball(10), -100L))));
    CHECK(law.vanishes(n + 1));
    CHECK((is_exact(law.value(n + 1)) && contains_zero(law.value(n + 1))));
}

// y = -log(1 - t): a_n = 1/n; its derivative 1/(1 - t).
TEST_CASE("a movable logarithm, and derivatives", "[asymptotics][proved]") {
    const precision_scope scope(60);
    const coefficient_law law = law_at("y' = exp(y); y(0) = 0");
    CHECK(law.shift() == -1);
    CHECK(law.first() == 1);
    for (const long n : {1L, 2L, 50L, 1000L}) {
        CHECK(contains(law.value(n), ball(1) / n));
        CHECK(contains(law_at("y' = exp(y); y(0) = 0", {.derivative = 2}).value(n), ball(n + 1)));
    }
    CHECK_THROWS_AS(law.value(0), error);
}

// w'' = (E - 1) w - w^3/2 for w = th', E = w(0)^2/2.
TEST_CASE("the angular velocity of the pendulum has an equation of its own", "[asymptotics][proved]") {
    const precision_scope scope(60);
    const coefficient_law law = law_at("th'' = -sin(th); th(0) = 0; th'(0) = 3/2", {.derivative = 1});
    CHECK(law.shift() == 0);
    const auto exact = exact_coefficients({typed("w'' = (9/8 - 1)*w - w^3/2; w(0) = 3/2; w'(0) = 0"), 0, 60});
    for (const long n : {0L, 2L, 3L, 30L, 60L}) {
        CHECK(overlaps(law.value(n), from_rational<ball>(exact.values[static_cast<std::size_t>(n)])));
    }
    for (const pole_terms& each : law.poles()) {  // +-2i, on the imaginary axis exactly
        CHECK((is_exact(each.place.re) && contains_zero(each.place.re)));
        CHECK((is_exact(each.principal.front().re) && contains_zero(each.principal.front().re)));
        CHECK(contains(abs(each.principal.front().im), ball(2)));
    }
}

TEST_CASE("entire solutions have a bound for the radius that is asked for", "[asymptotics][proved]") {
    const precision_scope scope(40);
    const coefficient_law law = law_at("y'' = -t*y; y(0) = 1; y'(0) = 0", {.within = 3});
    CHECK_FALSE(law.has_singularities());
    const auto exact = exact_coefficients({typed("y'' = -t*y; y(0) = 1; y'(0) = 0"), 0, 60});
    for (long n = 0; n <= 60; ++n) {
        CHECK(certainly_less(abs(from_rational<ball>(exact.values[static_cast<std::size_t>(n)])),
                             ball(law.error_bound(n))));
    }
    CHECK(reason_of("y'' = -t*y; y(0) = 1; y'(0) = 0").find("--within") != std::string::npos);
}

TEST_CASE("what is refused, with its place", "[asymptotics][proved]") {
    // A pole on the circle, and on it in double.
    CHECK(reason_of("y' = y^2; y(0) = 1", {.within = 1}).find("not decided to be inside") != std::string::npos);
    CHECK(!reason_of("y' = 1 + y^2; y(0) = 0", {.within = 1.5707963267948966}).empty());
    // y ~ log(t* - t) where x has a pole.
    CHECK(reason_of("x' = x^2 - y; y' = y^2 + x; x(0) = 1; y(0) = 1/2").find("has a singularity near 1.08") !=
          std::string::npos);
    CHECK(reason_of("y'' + 2*y'/t + y^5 = 0; y(0) = 1; y'(0) = 0").find("singular initial point") != std::string::npos);
    // A slit longer than its disc.
    CHECK(reason_of("x'' = 2*(1-x^2)*x' - x; x(0) = 1; x'(0) = 0", {.within = 1.6}).find("smaller RHO") !=
          std::string::npos);
}

// y = 1/(s - t)
TEST_CASE("any scale of time", "[asymptotics][proved]") {
    const whole_exponent_range exponents;
    for (const std::string s : {"1e-30", "1e20"}) {
        const precision_scope scope(60);
        const coefficient_law law = law_at("y' = y^2; y(0) = 1/" + s);
        const ball place =
            from_rational<ball>(rational(s == "1e20" ? "100000000000000000000" : "1/1000000000000000000000000000000"));
        CHECK(overlaps(law.value(100), pow(place, -101L)));
    }
}

// y = e^(4t)/4, whose mean on |t| = 2 is I_0(8)/4 = 106.89..; that of x is 11.3.
TEST_CASE("the bound for a later unknown of an entire system is its own", "[asymptotics][proved]") {
    law_request asked;
    asked.unknown = 1;
    asked.within = 2;
    const coefficient_law law = law_at("x' = 2*x; y' = x*x; x(0) = 1; y(0) = 1/4", asked);
    CHECK(law.mean().above() > 106.8);
    CHECK(law.mean().above() < 200);
}

}  // namespace asymptotics_coefficient_law_test
