#include "libration/digits/proved_decimals.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "libration/scalar/ball/ball.hpp"

namespace digits_proved_decimals_test {

using namespace libration;

TEST_CASE("a planted loss costs a proof more digits and never a wrong one", "[digits][proved]") {
    for (const long lost : {0L, 19L, 60L, 1000L}) {
        INFO(lost);
        const auto root = proved_value(50, [&] {
            const ball small = sqrt(ball(2)) / pow(ball(10), lost);
            return ((ball(1) + small) - ball(1)) * pow(ball(10), lost);
        });
        CHECK(root.text == "1.4142135623730950488016887242096980785696718753769");
        std::ostringstream printed;
        printed << root;
        CHECK(printed.str() == root.text);
    }
}

TEST_CASE("what is exactly 0 is said to be so, or is undecided", "[digits][proved]") {
    const auto compute = [] { return std::vector<ball>{sqrt(ball(2)) * sqrt(ball(2)) - 2, ball(1) / 3}; };
    CHECK_THROWS_AS(proved_decimals(10, compute), error);
    int asked = 0;
    const auto values = proved_decimals(10, compute, [&] {
        ++asked;
        return std::vector<bool>{true, false};
    });
    CHECK(asked == 1);
    CHECK(values[0].text == "0");
    CHECK(values[1].text == "0.3333333333");
}

}  // namespace digits_proved_decimals_test
