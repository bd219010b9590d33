// What the refusal of a solution that ends states to be nearly 0.
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/error.hpp"

namespace query_small_divisor_test {

using namespace libration;
using namespace libration::ode;
using Catch::Contains;

std::string reason_at_two(const std::string& problem) {
    const auto part = proved_part_of_trajectory(explicit_system(parse(problem)), {number(rational(2))}, 10);
    return part.missing ? part.missing->reason() : "";
}

// The divisor is 0 at the end of each solution: at t = pi/sqrt(8) two bodies meet that fall from rest at the distance 1.
TEST_CASE("a divisor that is nearly 0 is stated with a bound where the solution ends", "[ode][proved]") {
    CHECK_THAT(reason_at_two("y' = (y - sin(t))/(t - 1); y(0) = 0"), Contains("there |t - 1| <= "));
    CHECK_THAT(
        reason_at_two("x'' = -x/(x^2+y^2)^(3/2); y'' = -y/(x^2+y^2)^(3/2); x(0) = 1; y(0) = 0; x'(0) = 0; y'(0) = 0"),
        Contains("exist up to 1.1107") && Contains("there |x^2 + y^2| <= "));
    CHECK_THAT(reason_at_two("u'' = -1/(u' + 1); u(0) = 0; u'(0) = 0"), Contains("there |u' + 1| <= "));
    CHECK_THAT(reason_at_two("y' = log(1 - t) - y; y(0) = 1"), Contains("there |-t + 1| <= "));
}

TEST_CASE("a root of what becomes 0 is stated with what to write for a store, a divisor is not", "[ode][proved]") {
    const std::string remedy = "write if(20*h > 0, .., 0)";
    CHECK_THAT(reason_at_two("h' = -2*sqrt(2*10*h); h(0) = 1"), Contains("there |20*h| <= ") && Contains(remedy));
    CHECK_THAT(reason_at_two("h' = -1/sqrt(h); h(0) = 1"), Contains("there |h| <= ") && !Contains("write if"));
    CHECK_THAT(
        reason_at_two("x'' = -x/(x^2+y^2)^(3/2); y'' = -y/(x^2+y^2)^(3/2); x(0) = 1; y(0) = 0; x'(0) = 0; y'(0) = 0"),
        !Contains("write if"));
}

// Zeros of two expressions, a factor that is typed, and a function that is not elementary.
TEST_CASE("a quotient whose numerator is 0 there, too, is named", "[ode][proved]") {
    CHECK_THAT(reason_at_two("x' = 1; w' = 1; y' = sin(x)/w; x(0) = -1; w(0) = -1; y(0) = 0"),
               Contains("there |w| <= ") && Contains("the numerator of sin(x)/w is as small"));
    CHECK_THAT(reason_at_two("y' = (t^2 - 1)/(t - 1); y(0) = 0"),
               Contains("the numerator of (t^2 - 1)/(t - 1) is as small"));
    CHECK_THAT(reason_at_two("x' = 1; y' = erf(x)/x; x(0) = -1; y(0) = 0"),
               Contains("the numerator of erf(x)/x is as small"));
    CHECK_THAT(reason_at_two("y' = cos(t)/(t - 1); y(0) = 0"), Contains("there |t - 1|") && !Contains("numerator"));
    CHECK_THAT(
        reason_at_two("x'' = -x/(x^2+y^2)^(3/2); y'' = -y/(x^2+y^2)^(3/2); x(0) = 1; y(0) = 0; x'(0) = 0; y'(0) = 0"),
        !Contains("numerator"));
}

TEST_CASE("no divisor is stated where none is nearly 0", "[ode][proved]") {
    for (const std::string each : {"y' = 1 + y^2; y(0) = 0", "y' = y^2/(2 + t); y(0) = 4"}) {
        INFO(each);
        CHECK_THAT(reason_at_two(each), Contains("proved to exist up to ") && !Contains("there |"));
    }
}

// x/sin(x) is read as 1/cosrel(1, x), a function with an order.
TEST_CASE("a solution ends at a pole of a quotient from which another zero was removed", "[ode][proved]") {
    CHECK_THAT(reason_at_two("y' = (t + 3)/sin(t + 3); y(0) = 0"),
               Contains("exist up to 0.14159265") && Contains("there |cosrel(1, t + 3)| <= "));
    CHECK_THAT(reason_at_two("y' = sin(t)/sin(2*t); y(-1) = 0"),
               Contains("exist up to 1.5707963") && Contains("there |cosrel(1, 2*t)| <= "));
}

}  // namespace query_small_divisor_test
