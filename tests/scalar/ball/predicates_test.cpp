// The end points, hulls and signs of balls, also with more bits than the working precision: rounded outwards only.
#include "libration/scalar/ball/predicates.hpp"

#include "proved.hpp"

namespace scalar_ball_predicates_test {

using namespace libration;

namespace {

// 1/3 to 100 digits, +- 2^-50, in the caller's 20 digits.
ball long_third() {
    const precision_scope scope(100);
    return enclose(ball(ball(1) / 3), ldexp(ball(1), -50));
}

bool is_at_most(const ball& a, const ball& b) { return arb_le(a.handle(), b.handle()) != 0; }

}  // namespace

TEST_CASE("the ends of a ball are no nearer than its numbers", "[scalar][ball]") {
    for (const long digits : {20L, 100L}) {
        const precision_scope scope(digits);
        for (const int sign : {-1, 1}) {
            ball x = long_third();
            x = sign < 0 ? -x : x;  // exactly: a negation rounds nothing
            const ball below = lower_bound(x);
            const ball above = upper_bound(x);
            CHECK(is_exact(below));
            CHECK(is_exact(above));
            CHECK(is_at_most(below, x));
            CHECK(is_at_most(x, above));
            // By 2^-50 and a rounding, not more.
            const ball width = above - below;
            CHECK(is_at_most(width, ldexp(ball(1), -48)));
            CHECK(is_at_most(ldexp(ball(1), -49), width));
        }
    }
}

TEST_CASE("a hull contains both", "[scalar][ball]") {
    const precision_scope scope(20);
    const ball one = enclose(ball(1), ldexp(ball(1), -30));
    const ball two = enclose(ball(2), ldexp(ball(1), -20));
    for (const ball& both : {hull(one, two), hull(two, one)}) {
        CHECK(contains(both, one));
        CHECK(contains(both, two));
        CHECK_FALSE(contains(both, ball(3)));
    }
}

TEST_CASE("a ball that is cut to the working precision contains what it was", "[scalar][ball]") {
    const precision_scope scope(20);
    const ball x = long_third();
    CHECK(contains(narrow<ball>(x), x));
    CHECK(is_at_most(radius_of(narrow<ball>(x)), ldexp(ball(1), -49)));
    const ball exact_number = midpoint(x);  // of 100 digits
    CHECK(contains(narrow<ball>(exact_number), exact_number));
    CHECK_FALSE(is_exact(narrow<ball>(exact_number)));
}

TEST_CASE("a sign is that of all numbers", "[scalar][ball]") {
    const precision_scope scope(20);
    const ball small = ldexp(ball(1), -10);
    CHECK(decided_sign(enclose(ball(1), small)) == 1);
    CHECK(decided_sign(enclose(ball(-1), small)) == -1);
    CHECK(decided_sign(ball(0)) == 0);
    CHECK_THROWS_AS(decided_sign(enclose(small, ldexp(small, 1))), precision_exhausted);
    CHECK_THROWS_AS(decided_sign(enclose(ball(0), small)), precision_exhausted);
}

}  // namespace scalar_ball_predicates_test
