// Products and quotients of whole sequences of balls against one coefficient after the other.
#include "libration/scalar/ball/polynomial.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "libration/scalar/ball/ball.hpp"
#include "proved.hpp"

namespace scalar_ball_polynomial_test {

using namespace libration;
using namespace libration::tests;

namespace {

// Of the size of 1, with the radius of a rounding, and without a pattern.
std::vector<ball> sines(long first, std::size_t count) {
    std::vector<ball> all;
    all.reserve(count);
    for (std::size_t n = 0; n < count; ++n) {
        const auto angle = static_cast<long>(n * n) + first;
        all.push_back(sin(ball(angle)));
    }
    return all;
}

}  // namespace

TEST_CASE("a whole product is that of its coefficients, alone and for long sequences", "[ball_polynomial][ball]") {
    for (const long asked : {20L, 300L}) {
        const precision_scope scope(asked);
        for (const std::size_t count : {1U, 2U, 37U, 200U}) {
            const auto a = sines(1, count);
            const auto b = sines(2, count + 3);
            const auto c = whole_product(a, b);
            REQUIRE(c.size() == count);
            for (std::size_t n = 0; n < count; ++n) {
                INFO(asked << " digits, " << n << " of " << count);
                CHECK(overlaps(c[n],
                               scalar_traits<ball>::sum_of_products(a.data(), 1, &b[n], -1, static_cast<int>(n) + 1)));
                // Two radii in each of up to 200 products, and as much for the blocks.
                CHECK(certainly_less(radius_of(c[n]), epsilon<ball>() * 1000));
            }
        }
    }
}

TEST_CASE("a whole quotient times its divisor is what was divided", "[ball_polynomial][ball]") {
    for (const long asked : {20L, 300L}) {
        const precision_scope scope(asked);
        for (const std::size_t count : {1U, 2U, 37U, 200U}) {
            const auto a = sines(1, count);
            auto b = sines(2, count);
            b[0] = ball(static_cast<long>(count) + 1);  // no zero in the unit circle
            const auto q = whole_quotient(a, b);
            const auto product = whole_product(q, b);
            REQUIRE(q.size() == count);
            for (std::size_t n = 0; n < count; ++n) {
                INFO(asked << " digits, " << n << " of " << count);
                CHECK(overlaps(product[n], a[n]));
            }
        }
    }
}

TEST_CASE("quotients of integers contain their exact coefficients", "[ball_polynomial][ball]") {
    const precision_scope scope(30);
    // 1/(1-x)^2 = sum (n+1) x^n.
    std::vector<ball> one(300, ball(0));
    std::vector<ball> square(300, ball(0));
    one[0] = ball(1);
    square[0] = ball(1);
    square[1] = ball(-2);
    square[2] = ball(1);
    const auto q = whole_quotient(one, square);
    for (long n = 0; n < 300; ++n) {
        CHECK(contains(q[static_cast<std::size_t>(n)], ball(n + 1)));
    }
}

TEST_CASE("a quotient by what may begin with 0 contains everything", "[ball_polynomial][ball]") {
    const precision_scope scope(30);
    const std::vector<ball> a{ball(1), ball(2)};
    const std::vector<ball> b{enclose(ball(0), ball(1)), ball(1)};
    for (const ball& q : whole_quotient(a, b)) {
        CHECK_FALSE(is_finite(q));
    }
}

}  // namespace scalar_ball_polynomial_test
