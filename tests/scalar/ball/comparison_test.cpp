#include "libration/scalar/ball/comparison.hpp"

#include "proved.hpp"

namespace scalar_ball_comparison_test {

using namespace libration;

namespace {

// 1/3 to this many bits, wider by 2^-width.
ball third(long width) { return enclose(ball(ball(1) / 3), ldexp(ball(1), -width)); }

ball power_of_ten(int n) { return pow(ball(10), n); }

}  // namespace

TEST_CASE("a value is compared with all numbers of the truth", "[scalar][comparison]") {
    const precision_scope scope(60);
    const rational off(333'334, 1'000'000);  // 2/3 of 10^-6 above 1/3
    const auto outside = compare(off, {third(150)}, error_bound(power_of_ten(-7)), 10, false);
    REQUIRE(outside);
    CHECK_FALSE(outside->within);
    CHECK(outside->reference == "0.3333333333");
    CHECK(outside->error == "6.67e-7");
    CHECK(outside->tenths_of_digits == 56);  // log10(1/2 10^6) = 5.699
    const auto inside = compare(off, {third(150)}, error_bound(power_of_ten(-6)), 10, false);
    REQUIRE(inside);
    CHECK(inside->within);
}

TEST_CASE("what the truth does not decide is not compared", "[scalar][comparison]") {
    const precision_scope scope(60);
    const rational off(333'334, 1'000'000);
    // An error of 6.7e-7 +- 2^-24 (6e-8), and +- 2^-21 (4.8e-7), for a tolerance of 7e-7: the midpoint is within it.
    CHECK_FALSE(compare(off, {third(24)}, error_bound(power_of_ten(-8) * 70), 5, false));
    CHECK_FALSE(compare(off, {third(21)}, error_bound(power_of_ten(-8) * 70), 4, true));
    CHECK_FALSE(compare(off, {third(21)}, error_bound(power_of_ten(-8) * 60), 4, true));
    // A tolerance larger than the whole ball holds, but the error does not have three digits yet.
    CHECK_FALSE(compare(off, {third(24)}, error_bound(power_of_ten(-6)), 5, false));
    const auto last = compare(off, {third(24)}, error_bound(power_of_ten(-6)), 5, true);
    REQUIRE(last);
    CHECK(last->within);
    CHECK(last->error == "7.27e-7");  // 6.667e-7 + 2^-24, rounded up
}

TEST_CASE("a value that is the truth has no error", "[scalar][comparison]") {
    const precision_scope scope(60);
    const auto equal = compare(rational(3, 2), {ball(ball(3) / 2)}, error_bound(power_of_ten(-20)), 10, false);
    REQUIRE(equal);
    CHECK(equal->within);
    CHECK(equal->error == "0");
    CHECK_FALSE(equal->tenths_of_digits);
}

}  // namespace scalar_ball_comparison_test
