#include "libration/scalar/ball/decimal.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "corner_numbers.hpp"
#include "proved.hpp"

namespace scalar_ball_decimal_test {

using namespace libration;
using namespace libration::tests;

namespace {

ball ball_of(const std::string& midpoint, const std::string& radius) {
    return enclose(from_exact<ball>(read_exact(midpoint)), from_exact<ball>(read_exact(radius)));
}

}  // namespace

TEST_CASE("digits of a ball are printed where all of it is within a unit of the last", "[scalar][ball]") {
    const precision_scope scope(60);
    CHECK(to_proved_decimal(ball(1) / 3, 10)->text == "0.3333333333");
    CHECK(to_proved_decimal(ball(1) / 3, 10)->uncertainty == "3.34e-11");
    CHECK(to_proved_decimal(ball(-1) / 3, 1)->text == "-0.3");
    CHECK(to_proved_decimal(ball(0), 20)->text == "0");
    CHECK(to_proved_decimal(ball(0), 20)->uncertainty == "0");
    CHECK(to_proved_decimal(ball(5), 3)->text == "5.00");
    CHECK(to_proved_decimal(ball(5), 3)->uncertainty == "0");
    CHECK_FALSE(to_proved_decimal(ball(1) / ball(0), 1));
    CHECK_FALSE(to_proved_decimal(enclose(ball(0), epsilon<ball>()), 1));
    CHECK_THROWS_AS(to_proved_decimal(ball(1), 0), libration::error);
}

TEST_CASE("a unit is that of the digits printed", "[scalar][ball]") {
    const precision_scope scope(60);
    // 9.996 is printed as 10.0, whose unit is 0.1; with a radius of 0.05 all is within it.
    CHECK(to_proved_decimal(ball_of("9.996", "0.05"), 3)->text == "10.0");
    CHECK_FALSE(to_proved_decimal(ball_of("9.994", "0.05"), 3));  // 9.99, whose unit is 0.01
    CHECK(to_proved_decimal(ball_of("9.994", "0.0059"), 3)->text == "9.99");
    CHECK_FALSE(to_proved_decimal(ball_of("9.994", "0.0061"), 3));
}

TEST_CASE("the number of proved digits is the largest that can be printed", "[scalar][ball]") {
    const precision_scope scope(60);
    CHECK(proved_digits(ball_of("0.123456789", "1e-6"), 50) == 5);  // 0.12346: 3.2e-6 away, within 1e-5
    CHECK(proved_digits(ball_of("0.123456789", "1e-7"), 50) == 6);  // 0.123457: 0.3e-6 away
    CHECK(proved_digits(ball_of("0.1", "0.2"), 50) == 0);
    CHECK(proved_digits(ball_of("0.5", "0.01"), 50) == 1);
    CHECK(proved_digits(ball(1) / 3, 20) == 20);
    CHECK(proved_digits(ball(1) / ball(0), 20) == 0);
}

TEST_CASE("what is printed, with its uncertainty, contains the number", "[scalar][ball]") {
    corner_numbers next(20260301);  // any fixed seed
    const auto whole = [&next](long least, long most) { return next.between(least, most); };
    for (int i = 0; i < 300; ++i) {
        const long count = whole(1, 40);
        const precision_scope scope(count + 3);
        const rational q = next.half(
            [&] {
                return rational(read_exact(next.decimal()).coefficient * whole(1, 1000) / 8 * (whole(0, 1) * 2 - 1));
            },
            [&] { return rational(integer(whole(-1'000'000, 1'000'000) * 2 + 1), integer(whole(1, 1'000'000'000))); });
        const auto printed = to_proved_decimal(from_rational<ball>(q), count);
        REQUIRE(printed);
        const rational error = abs(rational(read_exact(printed->text).coefficient - q));
        CHECK(error <= read_exact(printed->uncertainty).coefficient);
        std::string unit = printed->text;  // the printed digits as 0...01
        unit = unit.substr(unit.front() == '-' ? 1 : 0);
        const auto mantissa_end = std::min(unit.find('e'), unit.size());
        for (std::size_t at = 0; at < mantissa_end; ++at) {
            unit[at] = unit[at] == '.' ? '.' : at + 1 == mantissa_end ? '1' : '0';
        }
        CHECK(error < read_exact(unit).coefficient);
    }
}

}  // namespace scalar_ball_decimal_test
