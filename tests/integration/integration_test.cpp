// The loop over a rule, whose steps are kept, and times that are read from them.
#include "libration/integration/integration.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace integration_integration_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long bits = 120;

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }

integration along(const std::string& text, march_watch watch = {}, step_observer observer = {}) {
    const explicit_system system = system_of(text);
    return integration(start_of(system, bits), rule_for(system, {bits}), infinite_distance(1), bits, std::move(watch),
                       std::move(observer));
}

// y = cos t, in many short steps of Taylor series or few of collocation.
const std::string stiff = "y' = -1e6*(y - cos(t)) - sin(t); y(0) = 1";

}  // namespace

TEST_CASE("steps are made once, and kept for all who read them", "[integration][proved]") {
    const precision_scope scope(60);
    int made = 0;
    integration steps = along("y'' = -y; y(0) = 0; y'(0) = 1", {}, [&](const step_report&) { ++made; });
    for (const int reader : {0, 1}) {
        CAPTURE(reader);
        for (std::size_t k = 0; k < 6; ++k) {
            const step* const here = steps[k];
            REQUIRE(here != nullptr);
            const ball half = exact_multiple(here->length(), 1, -1);
            CHECK(overlaps(here->values(half)[0], sin(here->from().time + half)));
            CHECK(overlaps(here->end().set.hull()[1], cos(here->end_time())));
        }
    }
    CHECK(made == 6);
    steps.forget_before(3);
    CHECK(steps[2] == nullptr);
    CHECK(steps[3] != nullptr);
    steps.forget_before(100);  // the last one remains
    CHECK(steps[5] != nullptr);
    REQUIRE(steps[6] != nullptr);
    CHECK(steps.first() <= 5);
    CHECK(steps.why() == stop::none);
}

TEST_CASE("an integration that its watch has ended can be continued", "[integration][proved]") {
    const precision_scope scope(60);
    bool ends = true;
    integration steps = along("y'' = -y; y(0) = 0; y'(0) = 1", [&](const ball&, long) {
        if (ends) {
            throw std::runtime_error("no time left");
        }
    });
    CHECK_THROWS_AS(steps[200], std::runtime_error);
    const ball reached = steps.reached();
    ends = false;
    REQUIRE(steps[200] != nullptr);
    CHECK(certainly_less(reached, steps.reached()));
}

TEST_CASE("the method is chosen towards the farthest time", "[integration][proved]") {
    const precision_scope scope(60);
    const explicit_system system = system_of(stiff);
    proved_march march(system, bits);
    march.aim(number(rational(10)));
    for (int k = 1; k <= 100; ++k) {
        const auto state = march.at(number(rational(k, 10)));
        REQUIRE(state);
        CHECK(overlaps((*state)[0], cos(ball(k) / 10)));
        CHECK(certainly_less(radius_of((*state)[0]), pow(ball(10), -20L)));
    }
    CHECK(march.collocation().steps > 0);
    CHECK(march.collocation().steps < 30);
}

// A step of collocation does not hold before its beginning.
TEST_CASE("times about the end of a step are read from both steps", "[integration][proved]") {
    const precision_scope scope(60);
    const explicit_system system = system_of(stiff);
    integration steps(start_of(system, bits), rule_for(system, {bits}), ball(10), bits);
    int read = 0;
    for (std::size_t k = 1; certainly_less(steps.reached(), ball(10)); ++k) {
        const step* const here = steps[k];
        REQUIRE(here != nullptr);
        const ball width = abs(steps[k - 1]->length()) / 1024;
        const ball times = enclose(here->from().time, width);
        std::size_t found = 0;
        const auto place = steps_about(steps, found, times);
        REQUIRE(place);
        CHECK((place->before == nullptr) == here->covers(times - here->from().time));
        const ball value = values_at(*place)[0];
        CHECK(contains(value, cos(here->from().time)));
        CHECK(overlaps(value, cos(lower_bound(times))));
        CHECK(overlaps(value, cos(upper_bound(times))));
        read += place->before != nullptr ? 1 : 0;
    }
    CHECK(read > 0);
}

}  // namespace integration_integration_test
