#include "libration/scalar/ball/judgement.hpp"

#include "proved.hpp"

namespace scalar_ball_judgement_test {

using namespace libration;

namespace {

// 1/3 to so many bits, wider by 2^-width.
ball third(long width) { return enclose(ball(ball(1) / 3), ldexp(ball(1), -width)); }

ball power_of_ten(int n) { return pow(ball(10), n); }

}  // namespace

TEST_CASE("a value is judged by all numbers of the truth", "[scalar][judgement]") {
    const precision_scope scope(60);
    const rational off(333'334, 1'000'000);  // 2/3 of 10^-6 above 1/3
    const auto outside = judge(off, third(150), power_of_ten(-7), 10, false);
    REQUIRE(outside);
    CHECK_FALSE(outside->within);
    CHECK(outside->reference == "0.3333333333");
    CHECK(outside->error == "6.67e-7");
    CHECK(outside->tenths_of_digits == 56);  // log10(1/2 10^6) = 5.699
    const auto inside = judge(off, third(150), power_of_ten(-6), 10, false);
    REQUIRE(inside);
    CHECK(inside->within);
}

TEST_CASE("what the truth does not decide is not judged", "[scalar][judgement]") {
    const precision_scope scope(60);
    const rational off(333'334, 1'000'000);
    // An error of 6.7e-7 +- 2^-24 (6e-8), and +- 2^-21 (4.8e-7), against a tolerance of 7e-7: the midpoint keeps it.
    CHECK_FALSE(judge(off, third(24), power_of_ten(-8) * 70, 5, false));
    CHECK_FALSE(judge(off, third(21), power_of_ten(-8) * 70, 4, true));
    CHECK_FALSE(judge(off, third(21), power_of_ten(-8) * 60, 4, true));
    // A tolerance beyond the whole ball is kept, but the error has no three digits yet.
    CHECK_FALSE(judge(off, third(24), power_of_ten(-6), 5, false));
    const auto last = judge(off, third(24), power_of_ten(-6), 5, true);
    REQUIRE(last);
    CHECK(last->within);
    CHECK(last->error == "7.27e-7");  // 6.667e-7 + 2^-24, rounded up
}

TEST_CASE("a value that is the truth has no error", "[scalar][judgement]") {
    const precision_scope scope(60);
    const auto equal = judge(rational(3, 2), ball(ball(3) / 2), power_of_ten(-20), 10, false);
    REQUIRE(equal);
    CHECK(equal->within);
    CHECK(equal->error == "0");
    CHECK_FALSE(equal->tenths_of_digits);
}

}  // namespace scalar_ball_judgement_test
