// Kept integrations: which question continues which of them, and when their steps do not stay.
#include "libration/integration/kept_integrations.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace integration_kept_integrations_test {

using namespace libration;
using namespace libration::ode;

namespace {

const explicit_system& decay() {
    static const explicit_system system(parse("x' = -x; x(0) = 1"));
    return system;
}

}  // namespace

TEST_CASE("the integration with the most bits is kept, one in each direction", "[ode][proved]") {
    kept_integrations all;
    const auto first = all.along(kept_integrations::whole, decay(), 100, 1, {});
    CHECK(all.along(kept_integrations::whole, decay(), 80, 1, {}) == first);
    CHECK(all.along(kept_integrations::whole, decay(), 100, -1, {}) != first);
    CHECK(all.along(0, decay(), 100, 1, {}) != first);
    CHECK(all.along(kept_integrations::whole, decay(), 100, 1, proof_route::second()) != first);
    const auto finer = all.along(kept_integrations::whole, decay(), 101, 1, {});
    CHECK(finer != first);
    CHECK(finer->bits() == 101);
    CHECK(all.along(kept_integrations::whole, decay(), 80, 1, {}) == finer);
}

TEST_CASE("steps are read again and counted once", "[ode][proved]") {
    kept_integrations all;
    const auto value_at = [&](const char* time) {
        proved_march march(kept_part{&all}, decay(), 120, 1);
        return march.at(parse_constant(time).constant()).value().front();
    };
    const precision_scope scope(40);
    CHECK(contains(value_at("2"), exp(ball(-2))));
    const auto made = all.made();
    CHECK(made > 0);
    CHECK(contains(value_at("1"), exp(ball(-1))));
    CHECK(contains(value_at("2"), exp(ball(-2))));
    CHECK(all.made() == made);
    CHECK(contains(value_at("30"), exp(ball(-30))));
    CHECK(all.made() > made);
}

TEST_CASE("steps without room are forgotten, and made anew for an earlier time", "[ode][proved]") {
    kept_integrations all(1);
    const auto value_at = [&](const char* time) {
        proved_march march(kept_part{&all}, decay(), 120, 1);
        return march.at(parse_constant(time).constant()).value().front();
    };
    const precision_scope scope(40);
    CHECK(contains(value_at("20"), exp(ball(-20))));
    const auto made = all.made();
    CHECK(contains(value_at("1"), exp(ball(-1))));
    CHECK(all.made() > made);
}

}  // namespace integration_kept_integrations_test
