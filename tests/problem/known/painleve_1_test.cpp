// The tritronquee solution against digits in print, against itself along other ways, and against its own expansion.
#include "libration/problem/known/painleve_1.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/lohner_set.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/plane/singularity_map.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace problem_known_painleve_1_test {

using namespace libration;
using namespace libration::ode;

namespace {

std::string value(long digits) {
    return proved_value(digits, [] { return tritronquee_start().value; }).text;
}

std::string slope(long digits) {
    return proved_value(digits, [] { return tritronquee_start().slope; }).text;
}

}  // namespace

// -0.1875543083404949 and 0.3049055602612289 [JoshiKitaev2001; Fornberg, Weideman 2011].
TEST_CASE("the tritronquee solution has the digits in print at 0", "[ode][proved]") {
    CHECK(value(16) == "-0.1875543083404949");
    CHECK(slope(16) == "0.3049055602612289");
}

// Starts farther out, longer expansions and marches.
TEST_CASE("enclosures of the tritronquee solution from different distances meet", "[ode][proved]") {
    value_and_slope last{ball(0), ball(0)};
    for (const long digits : {10L, 20L, 40L, 80L}) {
        INFO(digits);
        const precision_scope scope(digits);
        const value_and_slope now = tritronquee_start();
        CHECK(certainly_less(radius_of(now.value), pow(ball(10), -digits)));
        CHECK(certainly_less(radius_of(now.slope), pow(ball(10), -digits)));
        if (digits > 10) {
            CHECK(overlaps(now.value, last.value));
            CHECK(overlaps(now.slope, last.slope));
        }
        last = now;
    }
}

// The bound at infinity against the solution there, which comes from farther out: with one term and with many.
TEST_CASE("the lemma of the tritronquee solution bounds what short expansions leave out", "[ode][proved]") {
    const precision_scope scope(60);
    const value_and_slope start = tritronquee_start();
    const explicit_system system(parse("variable z; u'' = 6*u^2 + z; u(0) = 0; u'(0) = 0"));
    for (const int x : {1, 2, 6, 10}) {
        proved_march march(system, {start.value, start.slope}, 220);
        const auto state = march.at(ball(-x));
        REQUIRE(state);
        for (const int most : {1, 2, 5, 9}) {
            INFO(x << " " << most);
            const value_and_slope far = tritronquee_far_out(x, most);
            CHECK(overlaps(far.value, (*state)[0]));
            CHECK(overlaps(far.slope, -(*state)[1]));
            // The barrier takes the whole defect for an oscillation, and twice it: less than two digits are lost.
            const ball missing = abs((*state)[0] - exact_midpoint(far.value));
            CHECK(certainly_less(radius_of(far.value), missing * 100));
        }
    }
}

// The nearest pole on z > 0 is printed as 2.38416876956881664 [Fornberg, Weideman 2011].
TEST_CASE("the tritronquee solution has the pole in print", "[ode][proved][singularity]") {
    auto system = parse(std::string(problem_text("painleve_1")));
    system = changed(changed(system, "u(0) = " + value(40)), "u'(0) = " + slope(40));
    singularity_request request;
    request.nearest_alone = true;
    request.digits = 25;
    const singularity_map map = singularities_of(explicit_system(system), request);
    REQUIRE_FALSE(map.all.empty());
    const precision_scope scope(30);
    CHECK(map.all.front().offset.im == 0);
    CHECK(abs(map.all.front().offset.re - mpfr("2.38416876956881664")) < mpfr("1e-17"));
}

}  // namespace problem_known_painleve_1_test
