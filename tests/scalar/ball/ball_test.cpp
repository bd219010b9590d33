// A header that uses the concept comes first on purpose: the order of includes must not matter.
#include "libration/elliptic/complete_integral.hpp"
// Second.
#include "libration/scalar/ball/ball.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

#include "corner_numbers.hpp"
#include "proved.hpp"

namespace scalar_ball_test {

using namespace libration;
using namespace libration::tests;

namespace {

// Half of the numbers are corner cases.
class random_numbers {
public:
    long whole(long least, long most) { return corners_.between(least, most); }
    /// Below 10^6 in size.
    rational fraction() {
        return corners_.half(
            [&] {
                const long bits = corners_.length(200);
                return rational(corners_.whole(bits), integer(1) << static_cast<unsigned long>(bits)) *
                       rational(integer(1) << static_cast<unsigned long>(whole(0, 19)));
            },
            [&] { return rational(integer(whole(-1'000'000, 1'000'000)), integer(whole(1, 1'000'000))); });
    }
    /// In (0, 1), 10^-6 or more from both ends: as corner cases, multiples of 1/64 and their neighbours.
    rational inside() {
        return corners_.half(
            [&] {
                const rational away(integer(whole(-1, 1)), integer(1) << static_cast<unsigned long>(whole(20, 200)));
                return rational(rational(integer(whole(1, 63)), integer(64)) + away);
            },
            [&] { return rational(integer(whole(1, 999'999)), integer(1'000'000)); });
    }

private:
    corner_numbers corners_{20260229};  // any fixed seed
};

// A function on balls with the same function on mpfr, and its domain as an interval of fractions.
struct function_pair {
    const char* name;
    std::function<ball(const ball&)> of_balls;
    std::function<mpfr(const mpfr&)> of_numbers;
    int least;
    int most;
};

#define LIBRATION_PAIR(f, least, most)                                                                \
    {                                                                                                 \
#f, [](const ball& x) { return f(x); }, [](const mpfr& x) { return mpfr(f(x)); }, least, most \
    }

const std::vector<function_pair>& functions() {
    static const std::vector<function_pair> all{
        LIBRATION_PAIR(sqrt, 0, 9),
        LIBRATION_PAIR(exp, -9, 9),
        LIBRATION_PAIR(log, 0, 9),
        LIBRATION_PAIR(sin, -9, 9),
        LIBRATION_PAIR(cos, -9, 9),
        LIBRATION_PAIR(tan, -1, 1),
        LIBRATION_PAIR(asin, -1, 1),
        LIBRATION_PAIR(acos, -1, 1),
        LIBRATION_PAIR(atan, -9, 9),
        LIBRATION_PAIR(sinh, -9, 9),
        LIBRATION_PAIR(cosh, -9, 9),
        LIBRATION_PAIR(tanh, -9, 9),
        LIBRATION_PAIR(asinh, -9, 9),
        LIBRATION_PAIR(atanh, -1, 1),
        LIBRATION_PAIR(log1p, 0, 9),
        LIBRATION_PAIR(expm1, -9, 9),
        LIBRATION_PAIR(abs, -9, 9),
        {"x^-3", [](const ball& x) { return pow(x, -3); }, [](const mpfr& x) { return mpfr(1 / (x * x * x)); }, 0, 9},
        {"x^5", [](const ball& x) { return pow(x, 5); }, [](const mpfr& x) { return mpfr(x * x * x * x * x); }, -9, 9},
        {"x^x", [](const ball& x) { return pow(x, x); }, [](const mpfr& x) { return mpfr(pow(x, x)); }, 0, 9},
        {"ldexp", [](const ball& x) { return ldexp(x, -7); }, [](const mpfr& x) { return mpfr(x / 128); }, -9, 9}};
    return all;
}

#undef LIBRATION_PAIR

// f(x) with 60 digits more than the working precision, as an expected value with their uncertainty.
expected_value more_digits(const function_pair& f, const rational& x) {
    const precision_scope scope(working_digits() + 60);
    const mpfr value = f.of_numbers(from_rational<mpfr>(x));
    return {value, (abs(value) + 1) * epsilon<mpfr>() * 1'000'000};  // no condition number here exceeds 10^6
}

}  // namespace

TEST_CASE("a ball is a scalar of the precision in force", "[scalar][ball]") {
    STATIC_REQUIRE(scalar<ball>);
    STATIC_REQUIRE(proved_scalar<ball>);
    STATIC_REQUIRE_FALSE(rounding_scalar<ball>);
    STATIC_REQUIRE_FALSE(std::is_constructible_v<ball, double>);
    STATIC_REQUIRE_FALSE(std::is_convertible_v<int, ball>);
    STATIC_REQUIRE(std::is_nothrow_move_constructible_v<ball>);
    STATIC_REQUIRE(std::is_same_v<wide_t<ball>, ball>);
    for (const long asked : {1L, 7L, 50L, 1000L}) {
        const precision_scope scope(asked);
        CHECK(digits<ball>() == digits<mpfr>());
        CHECK(contains(epsilon<ball>(), ball(epsilon<mpfr>())));
        CHECK(is_exact(epsilon<ball>()));
        // One rounding: within half a unit in the last place, the radius with its 30 bits a little above.
        CHECK(certainly_less(radius_of(pi<ball>()), ball(epsilon<mpfr>()) * 4));
        const ball rounded = pi<ball>();
        const precision_scope wider(asked + 30);
        CHECK(contains(rounded, pi<ball>()));
        CHECK(contains(narrow<ball>(rounded), rounded));
    }
}

TEST_CASE("balls contain what fractions give exactly", "[scalar][ball]") {
    random_numbers random;
    for (int i = 0; i < 200; ++i) {
        const precision_scope scope(random.whole(2, 120));
        rational q = random.fraction();
        ball x = from_rational<ball>(q);
        for (int step = 0; step < 12; ++step) {
            const rational r = random.fraction() + 2'000'000;
            const int n = static_cast<int>(random.whole(1, 1000));
            const ball y = from_rational<ball>(r);
            switch (random.whole(0, 9)) {
                case 0: q = q + r, x = x + y; break;
                case 1: q = q - r, x -= y; break;
                case 2: q = q * r, x *= y; break;
                case 3: q = q / r, x = x / y; break;
                case 4: q = n - q, x = n - x; break;
                case 5: q = q * n + n, x = n + x * n; break;
                case 6: q = -q / n, x = -(x / n); break;
                case 7: q = (q - n) / 2, x = (x - n) / 2; break;
                case 8: q = n / r + q, x += n / y; break;
                default: q = q * q + 1, x = x * x + 1; break;
            }
            q = q / (1 + abs(q));  // the fractions stay short enough
            x = x / (1 + abs(x));
        }
        const precision_scope wide(2000);
        CHECK(overlaps(x, from_rational<ball>(q)));
        CHECK(contains(enclose(x, from_rational<ball>(rational(1, boost::multiprecision::pow(integer(10), 1900)))),
                       from_rational<ball>(q)));
    }
}

TEST_CASE("each function of a number contains its value and little more", "[scalar][ball]") {
    random_numbers random;
    for (const function_pair& f : functions()) {
        INFO(f.name);
        for (int i = 0; i < 20; ++i) {
            const precision_scope scope(random.whole(10, 200));
            const rational x = f.least + random.inside() * (f.most - f.least);
            const expected_value value = more_digits(f, x);
            // The argument is rounded once, and conditions stay below 10^6 (six digits to an end of the domain).
            CHECK_THAT(f.of_balls(from_rational<ball>(x)), encloses(value, 10'000'000, mpfr(abs(value.value) + 1)));
        }
    }
}

TEST_CASE("each function of a wide ball contains its values on all of it", "[scalar][ball]") {
    random_numbers random;
    for (const function_pair& f : functions()) {
        INFO(f.name);
        for (int i = 0; i < 20; ++i) {
            const precision_scope scope(random.whole(10, 60));
            const rational x = f.least + random.inside() * (f.most - f.least);
            const rational to_end = std::min(rational(x - f.least), rational(f.most - x));
            const rational radius = to_end * random.inside();
            const ball image = f.of_balls(enclose(from_rational<ball>(x), from_rational<ball>(radius)));
            for (int j = 0; j < 5; ++j) {
                const expected_value value = more_digits(f, rational(x + radius * (2 * random.inside() - 1)));
                CHECK(contains(enclose(image, ball(value.uncertainty)), ball(value.value)));
            }
        }
    }
}

TEST_CASE("the angle of a point is that of its quadrant", "[scalar][ball]") {
    const precision_scope scope(40);
    const ball turn = pi<ball>() / 4;
    const ball one(1);
    CHECK(overlaps(atan2(one, one), turn));
    CHECK(overlaps(atan2(one, -one), turn * 3));
    CHECK(overlaps(atan2(-one, -one), turn * -3));
    CHECK(overlaps(atan2(ball(0), -one), turn * 4));
    CHECK(is_exact(atan2(ball(0), one)));
    // Across the cut: both ends of the range.
    const ball around = enclose(ball(0), epsilon<ball>());
    CHECK(contains(atan2(around, -one), turn * 3));
    CHECK(contains(atan2(around, -one), turn * -3));
}

TEST_CASE("a decision is proved or refused", "[scalar][ball]") {
    const precision_scope scope(30);
    const ball third = ball(1) / 3;
    CHECK(decided_sign(third) == 1);
    CHECK(decided_sign(-third) == -1);
    CHECK(decided_sign(ball(0)) == 0);
    const ball difference = third * 3 - 1;  // 0, which cannot be proved at any precision
    CHECK(contains_zero(difference));
    CHECK_THROWS_AS(decided_sign(difference), precision_exhausted);
    CHECK(certainly_less(third, ball(1)));
    CHECK_FALSE(certainly_less(third, third));
    CHECK_FALSE(certainly_less(difference, ball(0)));
    CHECK_FALSE(certainly_less(ball(0), difference));
    CHECK_NOTHROW(require_below(third, ball(1), "x"));
    CHECK_THROWS_WITH(require_below(third * 3, ball(1), "a branch"), "a branch is not decided by this many digits");
    CHECK(nearest_integer(ball(7) / 2) == 4);
    CHECK(nearest_integer(ball(-5) / 2) == -2);
    CHECK(nearest_integer(third) == 0);
    CHECK(binary_exponent(ball(0)) == exponent_of_zero);
    CHECK(binary_exponent(third) == -1);
    CHECK(binary_exponent(ball(-4)) == 3);
}

TEST_CASE("what is undefined contains everything, and decides nothing", "[scalar][ball]") {
    const precision_scope scope(30);
    for (const ball& all :
         {ball(1) / ball(0), sqrt(ball(-1)), log(ball(0)), asin(ball(2)), ball(1) / (ball(1) / 3 * 3 - 1)}) {
        CHECK_FALSE(is_finite(all));
        CHECK_FALSE(certainly_less(all, ball(0)));
        CHECK_FALSE(certainly_less(ball(0), all));
        CHECK_THROWS_AS(decided_sign(all), precision_exhausted);
        CHECK_THROWS_AS(nearest_integer(all), precision_exhausted);
        CHECK_THROWS_AS(binary_exponent(all), precision_exhausted);
        CHECK_FALSE(is_finite(all * 0 + all));
    }
    CHECK_FALSE(is_finite(enclose(ball(1), ball(1) / ball(0))));
}

TEST_CASE("what is left out widens a ball by its largest size", "[scalar][ball]") {
    const precision_scope scope(30);
    const ball widened = enclose(ball(2), enclose(ball(-1), ball(1) / 2));
    CHECK(contains(widened, ball(1) / 2));
    CHECK(contains(widened, ball(7) / 2));
    CHECK_FALSE(contains(widened, ball(1) / 3));
    CHECK(is_exact(midpoint(widened)));
    CHECK(contains(widened, midpoint(widened)));
}

TEST_CASE("exact numbers become balls around them", "[scalar][ball]") {
    const precision_scope scope(40);
    CHECK(contains(from_exact<ball>(read_exact("150deg")) * 6, from_exact<ball>(read_exact("900deg"))) ==
          contains(from_exact<ball>(read_exact("5pi/6")) * 6, from_exact<ball>(read_exact("5pi"))));
    CHECK(overlaps(from_exact<ball>(read_exact("150deg")), pi<ball>() * 5 / 6));
    CHECK(is_exact(from_exact<ball>(read_exact("0.375"))));
    CHECK_FALSE(is_exact(from_exact<ball>(read_exact("0.1"))));
    CHECK(contains_zero(from_exact<ball>(read_exact("0.1")) * 10 - 1));
    CHECK_THROWS_AS(from_exact<ball>(read_exact("T/4")), libration::error);
}

TEST_CASE("balls are copied, moved and assigned as values", "[scalar][ball]") {
    const precision_scope scope(30);
    const ball third = ball(1) / 3;
    ball a = third;
    ball b = std::move(a);
    CHECK(contains(b, third));
    a = b;
    const ball& same = a;
    a = same;
    CHECK(contains(a, third));
    b = ball(2);
    CHECK(contains(a, third));
    a = std::move(b);
    CHECK(is_exact(a));
    a += a;
    a *= a;
    CHECK(certainly_less(abs(a - 16), ball(1)));
    a -= a;
    CHECK(decided_sign(a) == 0);
    std::vector<ball> many(100, third);
    many.resize(1000, ball(1));
    CHECK(contains(many.front(), third));
}

TEST_CASE("each thread has its own precision, and its balls outlive it", "[scalar][ball]") {
    const std::vector<long> asked{20, 50, 300, 1000};
    std::vector<std::vector<ball>> made(asked.size());
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            threads.emplace_back([&, i] {
                const precision_scope scope(asked[i]);
                for (int n = 1; n <= 50; ++n) {
                    made[i].push_back(exp(log(ball(n)) + pi<ball>()) * atan(ball(n)));
                }
            });
        }
    }
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const precision_scope scope(asked[i]);
        for (int n = 1; n <= 50; ++n) {
            const ball& there = made[i][static_cast<std::size_t>(n) - 1];
            const ball here = exp(log(ball(n)) + pi<ball>()) * atan(ball(n));
            CHECK(contains(there, here));
            CHECK(contains(here, there));
        }
    }
}

}  // namespace scalar_ball_test
