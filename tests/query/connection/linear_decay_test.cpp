// Solutions of linear equations that decay, compared with closed forms in gamma and Bessel functions.
#include <arb_hypgeom.h>

#include <catch2/catch.hpp>
#include <string>

#include "libration/query/connection/connection.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"
#include "query/connection/connected.hpp"

namespace query_connection_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

ball gamma_of(const rational& x) {
    ball result;
    arb_gamma(result.handle(), from_rational<ball>(x).handle(), ball::working_bits());
    return result;
}

ball bessel_i(long order, const ball& x) {
    ball result;
    arb_hypgeom_bessel_i(result.handle(), ball(order).handle(), x.handle(), ball::working_bits());
    return result;
}

bool has_value(const std::string& text, const std::string& unknown, const ball& expected, long digits) {
    return within_a_unit(connected(text, {unknown}, digits).values.at(0), expected, digits);
}

}  // namespace

TEST_CASE("linear equations whose solution decays at infinity", "[ode][proved]") {
    const precision_scope scope(120);
    const ball airy = -exp(log(ball(3)) / 3) * gamma_of({2, 3}) / gamma_of({1, 3});
    CHECK(has_value("y'' = t*y; y(0) = 1; y(inf) = 0", "y'(0)", airy, 50));
    CHECK(has_value("y'' = -t*y; y'(0) = 1; y(-inf) = 0", "y(0)", ball(-1) / airy, 50));
    CHECK(has_value("y'' = (t-3)*y; y(3) = sqrt(2); y(inf) = 0", "y'(3)", sqrt(ball(2)) * airy, 30));
    const ball cylinder = gamma_of({3, 4}) / gamma_of({1, 4}) * -2;
    CHECK(has_value("y'' = t^2*y; y(0) = 1; y(inf) = 0", "y'(0)", cylinder, 100));
    CHECK(has_value("y'' = (3*t-1)^2*y/81; y(1/3) = 1; y(inf) = 0", "y'(1/3)", cylinder / sqrt(ball(3)), 20));
    // i^n erfc: with q = 0 the constants are solutions too.
    const ball root = sqrt(scalar_traits<ball>::pi());
    CHECK(has_value("y'' + 2*t*y' = 0; y(0) = 1; y(inf) = 0", "y'(0)", ball(-2) / root, 50));
    CHECK(has_value("y'' + 2*t*y' = 4*y; y(0) = 1; y(inf) = 0", "y'(0)", ball(-4) / root, 50));
    // I_1(exp(-t)).
    const ball at_one = bessel_i(1, ball(1));
    CHECK(has_value("y'' = (1 + exp(-2*t))*y; y(0) = 1; y(inf) = 0", "y'(0)", ball(1) - bessel_i(0, ball(1)) / at_one,
                    30));
    // exp(-t): p has poles off the real axis.
    CHECK(has_value("y'' + y'/(t^2+1) = (1 - 1/(t^2+1))*y; y(-5) = 1; y(inf) = 0", "y'(-5)", ball(-1), 30));
    // exp(-t)/(t + 3).
    CHECK(has_value("y'' + 2*y'/(t+3) = y; y(-1) = 1; y(inf) = 0", "y'(-1)", ball(-3) / 2, 30));
}

TEST_CASE("linear equations whose limit is not proved to determine a solution", "[ode][proved]") {
    const auto refusal = [](const std::string& text, const std::string& unknown = "y'(0)") -> std::string {
        try {
            connected(text, {unknown}, 20);
        } catch (const error& problem) {
            return problem.what();
        }
        return "";
    };
    using Catch::Contains;
    CHECK_THAT(refusal("y'' = -t*y; y(0) = 1; y(inf) = 0"), Contains("no limit > 0"));
    // The bounded solutions are I_0(exp(-t/2)) times constants, which tend to 1.
    CHECK_THAT(refusal("y'' = exp(-t)*y/4; y(0) = 1; y(inf) = 0"), Contains("no limit > 0"));
    // exp(-t^2) and Dawson's function both tend to 0.
    CHECK_THAT(refusal("y'' + 2*t*y' + 2*y = 0; y(0) = 1; y(inf) = 0"), Contains("q < 0 at infinity"));
    // exp(-t), and another one that decays.
    CHECK_THAT(refusal("y'' + (3 + 1/(t+1))*y' + (2 + 1/(t+1))*y = 0; y(0) = 1; y(inf) = 0"), Contains("q < 0"));
    CHECK_THAT(refusal("y'' - t*y' = y; y(0) = 1; y(inf) = 0"), Contains("p < 0 at infinity"));
    // y = (t - 1)^-2 exp(-t) is infinite on the way.
    CHECK_THAT(refusal("y'' + 4*y'/(t-1) = (1 - 2/(t-1)^2)*y; y(0) = 1; y(inf) = 0"), Contains("no pole"));
    CHECK_THAT(refusal("y'' = t*y; y(0) = 0; y(inf) = 0"), Contains("only the solution 0"));
    // exp(-t^2/2).
    CHECK_THAT(refusal("y'' = (t^2-1)*y; y(0) = 1; y(inf) = 0"), Contains("not distinguished from 0"));
    // t exp(-t^2/2).
    CHECK_THAT(refusal("y'' = (t^2-3)*y; y(0) = 1; y(inf) = 0"), Contains("value at the initial point is not"));
    CHECK_THAT(refusal("y'' = t*y; y(0) = a; y'(0) = -a; y(inf) = 0; a = 1", "a"), Contains("one linear equation"));
}

}  // namespace query_connection_test
