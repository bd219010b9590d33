// A bound compared with the first digit of its decimal.
#include "libration/scalar/proved_digits.hpp"

#include <catch2/catch.hpp>

namespace scalar_proved_digits_test {

using libration::has_a_digit;

TEST_CASE("a proved decimal has a digit", "[scalar]") {
    CHECK(has_a_digit({"1.115", "0.00196"}));
    CHECK_FALSE(has_a_digit({"1.115", "1.96e106944"}));
    CHECK_FALSE(has_a_digit({"-1.115", "1.01"}));
    CHECK(has_a_digit({"-1.115", "1.00"}));
    CHECK(has_a_digit({"0.00734", "0.00100"}));
    CHECK_FALSE(has_a_digit({"0.00734", "0.00734"}));
    CHECK(has_a_digit({"9.99e-1000001", "1e-1000001"}));
    CHECK_FALSE(has_a_digit({"9.99e-1000001", "1.01e-1000001"}));
    CHECK(has_a_digit({"123.4", "100"}));
    CHECK_FALSE(has_a_digit({"123.4", "1.01e2"}));
    // 0 with a bound, where nothing else is known; infinity; fractions, which are exact.
    CHECK(has_a_digit({"0", "1e-60"}));
    CHECK(has_a_digit({"inf", "0"}));
    CHECK(has_a_digit({"22/7", "0"}));
}

}  // namespace scalar_proved_digits_test
