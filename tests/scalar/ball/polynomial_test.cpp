// Products and quotients of whole sequences of balls, compared with coefficient-by-coefficient computation.
#include "libration/scalar/ball/polynomial.hpp"

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

#include <catch2/catch.hpp>
#include <functional>
#include <vector>

#include "corner_numbers.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/ball/product_self_test.hpp"
#include "proved.hpp"

namespace scalar_ball_polynomial_test {

using namespace libration;
using namespace libration::tests;

namespace {

// Of size 1, with the radius of a rounding, and without a pattern.
std::vector<ball> sines(long first, std::size_t count) {
    std::vector<ball> all;
    all.reserve(count);
    for (std::size_t n = 0; n < count; ++n) {
        const auto angle = static_cast<long>(n * n) + first;
        all.push_back(sin(ball(angle)));
    }
    return all;
}

using ball_product =
    std::function<std::vector<ball>(const ball* a, int a_terms, const ball* b, int b_terms, int count, slong bits)>;

// Arb's product, with FLINT's product of integer polynomials.
std::vector<ball> unguarded_product(const ball* a, int a_terms, const ball* b, int b_terms, int count, slong bits) {
    std::vector<ball> c(static_cast<std::size_t>(count));
    _arb_poly_mullow(c.front().handle(), a->handle(), a_terms, b->handle(), b_terms, count, bits);
    return c;
}

// sum_k a_k b_{n-k} of exact balls, exactly or in this many bits.
ball exact_sum(const std::vector<ball>& a, const std::vector<ball>& b, int n, slong bits) {
    ball sum;
    for (int k = std::max(0, n + 1 - static_cast<int>(b.size())); k <= n && k < static_cast<int>(a.size()); ++k) {
        arb_addmul(sum.handle(), a[static_cast<std::size_t>(k)].handle(), b[static_cast<std::size_t>(n - k)].handle(),
                   bits);
    }
    return sum;
}

std::vector<ball> members(corner_numbers& next, const std::vector<ball>& a) {
    std::vector<ball> inside;
    for (const ball& each : a) {
        inside.push_back(next.member(each));
    }
    return inside;
}

// Corner cases near a geometric sequence, some of them 0.
std::vector<ball> corner_sequence(corner_numbers& next, int terms, long bits, long far) {
    std::vector<ball> all;
    const long slope = next.between(-20, 20);
    const bool exact = next.one_in(2);
    for (int k = 0; k < terms; ++k) {
        all.push_back(exact ? next.exact(next.length(bits), far) : next.wide(next.length(bits), far));
        arb_mul_2exp_si(all.back().handle(), all.back().handle(), slope * k);
    }
    return all;
}

struct ball_operands {
    std::vector<ball> a, b;
    bool square = false;
    int count;

    std::vector<ball> product(const ball_product& by, slong bits) const {
        const std::vector<ball>& right = square ? a : b;
        return by(a.data(), static_cast<int>(a.size()), right.data(), static_cast<int>(b.size()), count, bits);
    }
};

ball_operands corner_operands(corner_numbers& next, int most_terms, long bits, long far) {
    ball_operands of;
    of.a = corner_sequence(next, static_cast<int>(next.between(1, most_terms)), bits, far);
    of.b = corner_sequence(next, static_cast<int>(next.between(1, most_terms)), bits, far);
    if (next.one_in(4)) {
        of.square = true;
        of.b.assign(of.a.begin(),
                    of.a.end() - (next.one_in(2) ? 0 : next.between(0, static_cast<long>(of.a.size()) - 1)));
    }
    of.count = static_cast<int>(next.between(1, static_cast<long>(of.a.size() + of.b.size()) + 1));
    return of;
}

// All ones, so that the integers of the single block are at the bound of the transform (integer_product.hpp).
ball_operands aimed_operands(corner_numbers& next) {
    const long log = next.between(4, 7);
    const auto terms = std::size_t{1} << static_cast<unsigned>(log);
    const long s = next.between(250, 700);
    const long t = 64 * next.between((s + 400) / 64, (s + 900) / 64) - 1 - log - s;
    const auto ones = [](long bits) { return from_rational<ball>(rational(corner_numbers::ones(bits))); };
    ball_operands of;
    const precision_scope enough(decimal_digits(2000));
    of.a.assign(terms, ones(s));
    of.b.assign(terms, -ones(t));
    of.count = static_cast<int>(terms);
    return of;
}

int wrong_ones(const ball_product& by, corner_numbers& next, int products) {
    int wrong = 0;
    for (int i = 0; i < products; ++i) {
        const ball_operands of = aimed_operands(next);
        const auto c = of.product(by, next.between(60, 800));
        bool right = true;
        for (int n = 0; n < of.count; ++n) {
            right = right && contains(c[static_cast<std::size_t>(n)], exact_sum(of.a, of.b, n, ARF_PREC_EXACT));
        }
        wrong += right ? 0 : 1;
    }
    return wrong;
}

// A product contains the sums at numbers of its operands; about `checked` of its coefficients are tested.
void require_products(const ball_product& by, corner_numbers& next, int products, int most_terms, long far,
                      int checked) {
    for (int i = 0; i < products; ++i) {
        const long bits = next.length(900);
        const ball_operands of = corner_operands(next, most_terms, bits, far);
        const auto c = of.product(by, next.between(2, bits + 70));
        const std::vector<ball> x = members(next, of.a);
        std::vector<ball> y = members(next, of.b);
        if (of.square) {
            y.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(of.b.size()));
        }
        for (int look = 0; look < checked; ++look) {
            const int n =
                of.count <= checked ? look % of.count : static_cast<int>(next.below(static_cast<unsigned>(of.count)));
            INFO(i << ": coefficient " << n << " of " << of.count << ", " << of.a.size() << " by " << of.b.size());
            const ball truth = exact_sum(x, y, n, far > 100'000 ? 4000 : ARF_PREC_EXACT);
            CHECK((far > 100'000 ? overlaps(c[static_cast<std::size_t>(n)], truth)
                                 : contains(c[static_cast<std::size_t>(n)], truth)));
        }
    }
}

}  // namespace

TEST_CASE("products of sequences of balls contain the exact ones in corner cases", "[ball_polynomial][ball]") {
    corner_numbers next(20261125);
    require_products(leading_product, next, 150, 40, 60, 40);
    require_products(leading_product, next, 40, 150, 800, 40);
    require_products(leading_product, next, 40, 100, 4000, 30);
    require_products(leading_product, next, 30, 80, 1L << 60, 30);
    require_products(leading_product, next, 2, 1000, 60, 20);
}

TEST_CASE("products of sequences of balls contain the exact ones in many corner cases", "[.long][ball_polynomial]") {
    corner_numbers next(20261127);
    require_products(leading_product, next, 3000, 150, 800, 40);
    require_products(leading_product, next, 1000, 400, 4000, 30);
    require_products(leading_product, next, 500, 200, 1L << 60, 30);
    require_products(leading_product, next, 10, 9000, 60, 20);
    CHECK(wrong_ones(leading_product, next, 2000) == 0);
}

TEST_CASE("products of sequences of balls are right where FLINT's transform is not", "[ball_polynomial][ball]") {
    corner_numbers next(2790);
    CHECK(wrong_ones(leading_product, next, 60) == 0);
    if (!flint_products().transform_is_right) {
        CHECK(wrong_ones(unguarded_product, next, 60) > 0);
    }
}

TEST_CASE("a sequence is multiplied by a part of itself", "[ball_polynomial][ball]") {
    corner_numbers next(3);
    for (const int part : {100, 99, 60}) {
        std::vector<ball> a;
        for (int k = 0; k < 100; ++k) {
            a.push_back(next.exact(300, 20));
        }
        const std::vector<ball> b(a.begin(), a.begin() + part);
        const auto c = leading_product(a.data(), 100, a.data(), part, 100 + part - 1, 700);
        for (std::size_t n = 0; n < c.size(); ++n) {
            INFO(n << " of 100 by " << part);
            CHECK(contains(c[n], exact_sum(a, b, static_cast<int>(n), ARF_PREC_EXACT)));
        }
    }
}

// 1/k! +- 2^-bits of it, with signs without a pattern: far from geometric, so that a block contains very different
// sizes.
std::vector<ball> inverse_factorials(int terms, slong bits) {
    std::vector<ball> all;
    ball term(1);
    for (int k = 0; k < terms; ++k) {
        all.push_back((k * k) % 5 < 2 ? term : -term);
        arb_mul_2exp_si(term.handle(), term.handle(), -bits);
        all.back() = enclose(all.back(), term);
        arb_mul_2exp_si(term.handle(), term.handle(), bits);
        term = midpoint(term / (k + 1));
    }
    return all;
}

TEST_CASE("the radii of a product are those of its sums written out", "[ball_polynomial][ball]") {
    for (const long digits : {40L, 300L}) {
        const precision_scope scope(digits);
        const slong bits = ball::working_bits();
        const auto a = inverse_factorials(200, bits - 30);
        const auto b = inverse_factorials(200, bits);
        const auto c = leading_product(a.data(), 200, b.data(), 200, 200, bits);
        for (std::size_t n = 0; n < c.size(); ++n) {
            const ball sum = scalar_traits<ball>::sum_of_products(a.data(), 1, &b[n], -1, static_cast<int>(n) + 1);
            INFO(digits << " digits, coefficient " << n);
            // 1 + 2^-19, the roundings of magnitudes, and one unit of the last place.
            CHECK(certainly_less(radius_of(c[n]), radius_of(sum) * 1001 / 1000 + abs(sum) * epsilon<ball>() * 4));
        }
    }
}

// (1 +- r) + (1 +- r) x + ...: the largest numbers of the operands have the largest sums, which the radii must cover.
TEST_CASE("radii of products reach the largest sums, also where neighbours share them", "[ball_polynomial][ball]") {
    const precision_scope scope(20);
    const ball wide = enclose(ball(1), ball(1) / 8);
    for (const int terms : {100, 4096, 4097, 9001}) {
        const std::vector<ball> a(static_cast<std::size_t>(terms), wide);
        const auto c = whole_product(a, a);
        for (int n = 0; n < terms; n = 2 * n + 1) {
            for (const int at : {n, terms - 1 - n}) {
                INFO(at << " of " << terms);
                CHECK(contains(c[static_cast<std::size_t>(at)], ball(81) / 64 * (at + 1)));
                CHECK(certainly_less(radius_of(c[static_cast<std::size_t>(at)]), ball(18) / 64 * (at + 8)));
            }
        }
    }
}

// q with b q = a at numbers of the balls, term by term in many bits.
std::vector<ball> quotient_by_recurrence(const std::vector<ball>& a, const std::vector<ball>& b, slong bits) {
    std::vector<ball> q(a.size());
    for (std::size_t n = 0; n < a.size(); ++n) {
        ball sum = a[n];
        for (std::size_t k = 1; k <= n; ++k) {
            arb_submul(sum.handle(), b[k].handle(), q[n - k].handle(), bits);
        }
        arb_div(q[n].handle(), sum.handle(), b[0].handle(), bits);
    }
    return q;
}

TEST_CASE("quotients of sequences of balls contain the exact ones in corner cases", "[ball_polynomial][ball]") {
    corner_numbers next(2012);
    for (int run = 0; run < 40; ++run) {
        const precision_scope scope(next.between(5, 200));
        const int terms = static_cast<int>(next.between(1, 120));
        const auto a = corner_sequence(next, terms, next.length(600), 20);
        auto b = corner_sequence(next, terms, next.length(600), 20);
        if (contains_zero(b.front())) {
            b.front() = ball(next.one_in(2) ? 1 : -3);
        }
        const auto q = whole_quotient(a, b);
        const auto truth = quotient_by_recurrence(members(next, a), members(next, b), 4000 + 60 * terms);
        for (std::size_t n = 0; n < q.size(); ++n) {
            INFO("run " << run << ", coefficient " << n << " of " << terms);
            CHECK(overlaps(q[n], truth[n]));
        }
    }
}

TEST_CASE("quotients of all ones are those of integers", "[ball_polynomial][ball]") {
    // c / (1-t) and c / (1+t), c = 2^s - 1: all coefficients +-c.
    for (const long s : {67L, 285L, 349L, 509L}) {
        const precision_scope scope(300);
        const ball c = from_rational<ball>(rational(corner_numbers::ones(s)));
        for (const int sign : {1, -1}) {
            std::vector<ball> a(256, ball(0));
            std::vector<ball> b(256, ball(0));
            a[0] = c;
            b[0] = ball(1);
            b[1] = ball(-sign);
            const auto q = whole_quotient(a, b);
            // The square of a quotient: c^2 (n+1) sign^n.
            const auto square = whole_product(q, q);
            const precision_scope exactly(400);
            for (long n = 0; n < 256; ++n) {
                const long to_n = n % 2 == 0 ? 1 : sign;
                CHECK(contains(q[static_cast<std::size_t>(n)], c * to_n));
                CHECK(contains(square[static_cast<std::size_t>(n)], c * c * (to_n * (n + 1))));
            }
        }
    }
}

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
                // Two radii in each of up to 200 products, and the same for the blocks.
                CHECK(certainly_less(radius_of(c[n]), epsilon<ball>() * 1000));
            }
        }
    }
}

// Exponents beyond those of blocks, in either factor.
TEST_CASE("a whole product has terms of any size", "[ball_polynomial][ball]") {
    const precision_scope scope(20);
    const ball huge = ldexp(ball(1), 1'000'000'000);
    const auto a = sines(1, 200);
    auto b = sines(2, 200);
    b[150] = huge;
    const auto c = whole_product(a, b);
    const auto d = whole_product(b, a);
    for (std::size_t n = 0; n < 200; ++n) {
        const ball expected = scalar_traits<ball>::sum_of_products(a.data(), 1, &b[n], -1, static_cast<int>(n) + 1);
        CHECK(overlaps(c[n], expected));
        CHECK(overlaps(d[n], expected));
    }
    CHECK(certainly_less(abs(c[150] - a[0] * huge), huge * pow(ball(10), -15)));
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
