// Solutions with a given amplitude of their decay, compared with closed forms.
#include "../src/libration/query/connection/amplitude_connection.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "../src/libration/query/connection/connection_orbit.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"
#include "query/connection/connected.hpp"

namespace query_connection_amplitude_connection_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

const std::vector<std::string> both{"y(0)", "y'(0)"};

std::string refusal(const std::string& text, const std::vector<std::string>& unknowns = both) {
    try {
        connected(text, unknowns, 12);
    } catch (const error& problem) {
        return problem.what();
    }
    return "";
}

}  // namespace

// sqrt 2 sech(t - s) has the amplitude 2 sqrt 2 exp(s).
TEST_CASE("the amplitude of a soliton gives its initial values", "[ode][proved]") {
    const precision_scope scope(80);
    const auto found = connected("y'' = y - y^3; y(inf) = 0 with amplitude 1", both, 40);
    CHECK(within_a_unit(found.values.at(0), ball(8) / 9, 40));
    CHECK(within_a_unit(found.values.at(1), ball(-56) / 81, 40));
    const auto backwards = connected("y'' = y - y^3; y(-inf) = 0 with amplitude 1", {"y'(0)", "y(0)"}, 20);
    CHECK(within_a_unit(backwards.values.at(0), ball(56) / 81, 20));
    const auto later =
        connected("y'' = y - y^3; y(2) = 1; y'(2) = 1; y(inf) = 0 with amplitude 1", {"y(2)=1", "y'(2)=1"}, 20);
    const ball u = sqrt(ball(8)) * exp(ball(2));
    CHECK(within_a_unit(later.values.at(0), sqrt(ball(8)) / (u + ball(1) / u), 20));
    // The amplitude of y is -2 then.
    const auto by_slope = connected("y'' = y - y^3; y(inf) = 0; y'(inf) = 0 with amplitude 2", both, 20);
    CHECK(within_a_unit(by_slope.values.at(0), ball(-4) / 3, 20));
    REQUIRE(found.orbit);
    const auto states = found.orbit->states({ball(1), ball(50)}, 200);
    REQUIRE(states);
    const ball v = sqrt(ball(8)) * exp(ball(50));
    CHECK(overlaps((*states)[1][0], sqrt(ball(8)) / (v + ball(1) / v)));
}

// A/(A + exp(t)).
TEST_CASE("amplitudes of any size, up to a singularity on the way", "[ode][proved]") {
    const precision_scope scope(80);
    const std::string field = "y' = y^2 - y; y(inf) = 0 with amplitude ";
    CHECK(within_a_unit(connected(field + "3", {"y(0)"}, 30).values.at(0), ball(3) / 4, 30));
    CHECK(within_a_unit(connected(field + "10^6", {"y(0)"}, 30).values.at(0), ball(1000000) / 1000001, 30));
    CHECK(within_a_unit(connected(field + "1/10^20", {"y(0)"}, 30).values.at(0),
                        ball(1) / (ball(1) + pow(ball(10), 20L)), 30));
    CHECK(within_a_unit(connected(field + "-1/2", {"y(0)"}, 30).values.at(0), ball(-1), 30));
    CHECK_THAT(refusal(field + "-2", {"y(0)"}), Catch::Contains("back to the initial point"));  // a pole at log 2
}

TEST_CASE("amplitudes that do not determine a solution", "[ode]") {
    using Catch::Contains;
    CHECK_THAT(refusal("y'' = y - y^3; y(inf) = 0 with amplitude 0"), Contains("amplitude 0"));
    CHECK_THAT(refusal("y'' = -3*y' - 2*y; y(inf) = 0 with amplitude 1"), Contains("2 directions"));
    CHECK_THAT(refusal("y'' = y - y^3; y(-inf) = 0; y(inf) = 0 with amplitude 1"), Contains("limits at both ends"));
    CHECK_THAT(refusal("y'' = y - y^3; y'(0) = 1; y(inf) = 0 with amplitude 1", {"y(0)"}), Contains("y(0),y'(0)"));
    CHECK_THAT(refusal("y'' = t*y; y(inf) = 0 with amplitude 1"), Contains("autonomous"));
}

}  // namespace query_connection_amplitude_connection_test
