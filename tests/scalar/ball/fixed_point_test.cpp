#include "libration/scalar/ball/fixed_arithmetic.hpp"

#include <flint/fmpq.h>

#include <catch2/catch.hpp>

#include "corner_numbers.hpp"

namespace scalar_ball_fixed_test {

using namespace libration;

namespace {

// A number in fixed point and a rational member of it, anywhere up to its ends.
struct sample {
    fixed_ball held;
    rational member;
};

// Numbers between 2^-20 and 2^5, half of them corner cases and the others not representable in binary, with radii up to
// 2^20 units.
class samples {
public:
    explicit samples(int n) : n_(n) {}

    sample operator()() {
        const rational number = corners_.half([&] { return corner(); }, [&] { return usual(); });
        const long units = below(2) == 0 ? 0 : below(1L << 20U);
        fixed_ball held = at(number);
        held.widen_by(static_cast<int>(units));
        const rational unit(integer(1), integer(1) << static_cast<unsigned>(64 * n_));
        return {held, rational(number + unit * (below(2) == 0 ? units : -units))};
    }

private:
    fixed_ball at(const rational& number) const {
        const precision_scope scope(decimal_digits(64L * n_ + 80));
        return {n_, from_rational<ball>(number)};
    }
    rational usual() { return {integer(1 + below(1'000'000)), integer(61'000 * (1L << below(6)))}; }
    rational corner() {
        const long bits = corners_.length(64L * n_ + 64);
        return rational(corners_.positive(bits) << static_cast<unsigned long>(below(6)),
                        integer(1) << static_cast<unsigned long>(bits + below(18)));
    }
    long below(long n) { return corners_.between(0, n - 1); }

    int n_;
    tests::corner_numbers corners_{5};
};

// Exact: Arb compares without rounding.
bool holds(const fixed_ball& x, const rational& number) {
    fmpq_t member;
    fmpq_init(member);
    fmpq_set_mpq(member, number.backend().data());
    const bool inside = arb_contains_fmpq(x.to_ball().handle(), member) != 0;
    fmpq_clear(member);
    return inside;
}

}  // namespace

TEST_CASE("fixed point encloses sums, products and quotients of members", "[scalar][ball_fixed]") {
    for (const int n : {1, 2, 5, 20}) {
        samples next(n);
        for (int i = 0; i < 300; ++i) {
            const auto [x, a] = next();
            const auto [y, b] = next();
            INFO(n << " limbs, " << a << " and " << b);
            CHECK(holds(x + y, rational(a + b)));
            CHECK(holds(x * y, rational(a * b)));
            CHECK(holds(x * x, rational(a * a)));
            CHECK(holds(ldexp(x, 5), rational(a * 32)));
            CHECK(holds(ldexp(x, -5), rational(a / 32)));
            if (a > b) {
                CHECK(holds(x - y, rational(a - b)));
            }
            if (y.below() * 1024 > 1) {
                CHECK(holds(x / y, rational(a / b)));
            }
        }
    }
}

TEST_CASE("fixed point encloses roots, and its radii are not wasteful", "[scalar][ball_fixed]") {
    for (const int n : {1, 2, 5, 20}) {
        const precision_scope scope(decimal_digits(64L * n + 80));
        samples next(n);
        for (int i = 0; i < 200; ++i) {
            const auto [x, a] = next();
            const auto [y, b] = next();
            INFO(n << " limbs, " << a << " and " << b);
            CHECK(contains(fixed_ball::root_of_half(n, a).to_ball(), sqrt(from_rational<ball>(rational(a / 2)))));
            CHECK(fixed_ball::root_of_half(n, a).radius() <= 1);
            if (x.below() * 1024 > 1 && y.below() * 1024 > 1) {
                const fixed_ball mean = geometric_mean(x, y);
                CHECK(contains(mean.to_ball(), sqrt(from_rational<ball>(rational(a * b)))));
                // sqrt(x x) is as uncertain as x: plus 2^-10 and 2^-20 for inexact factors, and the truncated unit.
                CHECK(geometric_mean(x, x).radius() <= x.radius() * (1 + 1.0 / 256) + 2);
            }
        }
    }
}

TEST_CASE("fixed point takes the radius of a ball with it", "[scalar][ball_fixed]") {
    const precision_scope scope(100);
    const ball third = ball(1) / 3;
    for (const int n : {1, 2, 4}) {
        const ball wide = enclose(third, ldexp(ball(1), 10 - 64L * n));
        const fixed_ball x(n, wide);
        CHECK(contains(x.to_ball(), wide));
        // 2^10 units, a unit for truncation, and 2^-20 more for each of two roundings.
        CHECK(x.radius() < 1024 * (1 + 1.0 / 256) + 1);
        CHECK(x.radius() > 1024);
    }
}

TEST_CASE("fixed point refuses what it cannot hold", "[scalar][ball_fixed]") {
    const fixed_ball one(2, mp_limb_t{1});
    const fixed_ball two = one + one;
    const fixed_ball large = ldexp(one, 63);
    CHECK_THROWS_AS(one - two, precision_exhausted);
    CHECK_THROWS_AS(large + large, precision_exhausted);
    CHECK_THROWS_AS(large * two, precision_exhausted);
    CHECK_THROWS_AS(ldexp(large, 1), precision_exhausted);
    CHECK_THROWS_AS(one / fixed_ball(2), precision_exhausted);
    CHECK_THROWS_AS(one / ldexp(one, -40), precision_exhausted);
    CHECK_THROWS_AS(geometric_mean(one, fixed_ball(2)), precision_exhausted);
    CHECK_THROWS_AS(fixed_ball(2, ldexp(ball(1), 64)), precision_exhausted);
    CHECK((one - one).is_zero());
    CHECK(overlaps((two / one).to_ball(), ball(2)));
}

}  // namespace scalar_ball_fixed_test
