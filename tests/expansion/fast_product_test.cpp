// Sums in blocks: equal to term-by-term sums over fractions, and enclosures and roundings of closed forms by FLINT.
#include "libration/expansion/fast_product.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "proved.hpp"
#include "scalars.hpp"

namespace expansion_fast_product_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

// The definition, for short blocks.
class plain_product final : public series::block_product<rational> {
public:
    explicit plain_product(int least) : least_(least) {}
    void add_middle(rational* sums, int count, const rational* a, int length, const rational* b,
                    int terms) const override {
        ++calls;
        for (int i = 0; i < count; ++i) {
            for (int k = 0; k < length; ++k) {
                const int other = length + i - k;
                if (other < terms) {
                    sums[i] += a[k] * b[other];
                }
            }
        }
    }
    int least_length() const override { return least_; }

    mutable int calls = 0;

private:
    int least_;
};

std::vector<std::vector<rational>> coefficients_of(const std::string& text, int order,
                                                   const series::block_product<rational>* fast) {
    const explicit_system system(parse(text));
    const tape made = tape::about_start(system);
    taylor_expansion<rational> expansion(made, order, fast);
    expansion.about_start();
    std::vector<std::vector<rational>> all;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        const rational* const first = expansion.coefficients(static_cast<int>(i));
        all.emplace_back(first, first + order + 1);
    }
    return all;
}

}  // namespace

TEST_CASE("sums in blocks are those term by term, in every kernel, for every length", "[ode]") {
    const std::string text =
        GENERATE("x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z; x(0) = 1; y(0) = 0; z(0) = 0",  // products
                 "f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 1/3",                                 // every third
                 "f''' + f*f''/2 = 0; f(0) = 1/5; f'(0) = 1/4; f''(0) = 1/3",                             // slopes
                 "y' = y^2 + t; y(0) = 1/2",                                                              // a square
                 "y' = 1/(1 + y) + y/(2 + t^2); y(0) = 1",                                                // quotients
                 "y' = sqrt(1 + y); y(0) = 3",                                                            // a root
                 "y'' = -sin(y) + tan(y)/3; y(0) = 0; y'(0) = 1/2",                                       // odd series
                 "y' = exp(y) - 1/3; y(0) = 0",                                                           // exponential
                 "y' = log(1 + y) + atan(y); y(0) = 0",                                                   // l' and a'
                 "y' = asin(y) + 1/2; y(0) = 0",                                                          // its cosine
                 "y' = sinh(y) + tanh(y) + 1; y(0) = 0",                                                  // hyperbolic
                 "y' = (1 + y)^(1/3) + 1; y(0) = 0",                                                      // a power
                 "y'' + 2/t*y' + y^3 = 0; y(0) = 1; y'(0) = 0");  // a singular start
    CAPTURE(text);
    for (const int order : {7, 12, 23, 24, 25, 41}) {
        const auto expected = coefficients_of(text, order, nullptr);
        for (const int least : {1, 2, 3, 5}) {
            CAPTURE(order, least);
            const plain_product fast(least);
            CHECK(coefficients_of(text, order, &fast) == expected);
            CHECK((order < 41 || fast.calls > 0));
        }
    }
}

// Directly, because the templates of the system are compiled in the library.
TEST_CASE("sums in blocks of two sequences and of the pairs of one", "[ode]") {
    constexpr int order = 60;
    std::vector<rational> a;
    std::vector<rational> b;
    for (int n = 0; n <= order; ++n) {
        a.emplace_back(n * n - 7 * n + 3, n + 1);
        b.emplace_back(5 - n * n, 2 * n + 1);
    }
    const plain_product fast(3);
    series::blocked_sums<rational> sums(&fast, order);
    for (int n = 0; n <= order; ++n) {
        CHECK(sums.product(a.data(), b.data(), n, series::parity::any) ==
              series::product_coefficient(a.data(), b.data(), n));
        CHECK(sums.pairs(a.data(), n, 0, series::parity::any) == series::square_coefficient(a.data(), n));
    }
}

TEST_CASE("another point and another start forget the sums of the one before", "[ode]") {
    const explicit_system system(parse("y' = y^2 + t; y(0) = 1/2"));
    const tape made = tape::about_points(system);
    const plain_product fast(2);
    taylor_expansion<rational> blocks(made, 20, &fast);
    taylor_expansion<rational> terms(made, 20);
    for (const rational& at : {rational(1, 3), rational(-2), rational(0)}) {
        blocks.about(at, {{rational(2, 7)}});
        terms.about(at, {{rational(2, 7)}});
        CHECK(blocks.series_of(0).coefficients() == terms.series_of(0).coefficients());
    }
    blocks.about_start();
    terms.about_start();
    CHECK(blocks.series_of(0).coefficients() == terms.series_of(0).coefficients());
}

// y = 1/(1 - t/7): 7^-n; x = tan t by x' = 1 + x^2, while its quotient sin/cos would be a different series: the balls
// of both methods must overlap, and those of y must contain the fraction.
TEST_CASE("FLINT's products enclose the coefficients, at few digits and at many", "[ode][proved]") {
    const long digits = GENERATE(30, 200, 700);
    const precision_scope scope(digits);
    const explicit_system system(
        parse("y' = y^2/7; y(0) = 1; x' = 1 + x^2; x(0) = 0; z'' = -sin(z); z(0) = 1; z'(0) = 2"));
    const tape made = tape::about_start(system);
    const int order = 700;
    taylor_expansion<ball> blocks(made, order, fast_product<ball>());
    taylor_expansion<ball> terms(made, order);
    blocks.about_start();
    terms.about_start();
    ball expected(1);
    for (int n = 0; n <= order; ++n) {
        CAPTURE(digits, n);
        CHECK(contains(blocks.coefficients(0)[n], expected));
        const precision_scope finer(digits + 30);
        expected /= 7;
        for (int i = 1; i < 3; ++i) {
            CHECK(overlaps(blocks.coefficients(i)[n], terms.coefficients(i)[n]));
        }
    }
}

// y = -c^2 t/(1-t), all of whose coefficients are -c^2, where FLINT's products are wrong up to version 3.6.0.
TEST_CASE("coefficients are right at the bound of FLINT's transform", "[ode][proved]") {
    for (const char* const c : {"0.99999999999999999999", "1 - 2^(-349)", "1 - 2^(-285)"}) {
        const rational square = read_exact(c).coefficient * read_exact(c).coefficient;
        const explicit_system system(parse(std::string("y' = (c/(1-t))*(c/(t-1)); y(0) = 0; c = ") + c));
        const tape made = tape::about_start(system);
        for (const long digits : {172L, 220L, 320L}) {
            const precision_scope scope(digits);
            taylor_expansion<ball> blocks(made, 511, fast_product<ball>());
            blocks.about_start();
            const precision_scope finer(digits + 200);
            for (int n = 1; n <= 511; ++n) {
                CAPTURE(c, digits, n);
                CHECK(contains(blocks.coefficients(0)[n], from_rational<ball>(-square)));
            }
        }
    }
}

// 7^-n again. A coefficient is computed from sums of at most 2 n products, each correct to the last place, so to 4 n
// epsilon; log n rectangles round relative to their largest term, which here differs from the others by at most a
// factor 7^64.
TEST_CASE("FLINT's products in mpfr keep the digits of a geometric series", "[ode]") {
    const precision_scope scope(120);
    const explicit_system system(parse("y' = y^2/7; y(0) = 1"));
    const tape made = tape::about_start(system);
    const int order = 1500;
    taylor_expansion<mpfr> blocks(made, order, fast_product<mpfr>());
    blocks.about_start();
    mpfr scale(1);
    for (int n = 0; n <= order; ++n) {
        CAPTURE(n);
        CHECK(abs(mpfr(blocks.coefficients(0)[n] * scale - 1)) <= mpfr(8 * (n + 1) * epsilon<mpfr>()));
        scale *= 7;
    }
}

// Of exact numbers with far more bits than the working precision, by sums term by term in more.
TEST_CASE("FLINT's products of balls with more bits than the working precision hold the exact sums", "[ode][ball]") {
    constexpr int length = 128;
    std::vector<ball> a, b, exact;
    {
        const precision_scope wide(400);
        for (int k = 0; k < 2 * length; ++k) {
            const ball power = pow(ball(5), static_cast<long>(-k));
            a.push_back(midpoint_alone(power / 3));
            b.push_back(midpoint_alone(power / 7));
        }
        for (int i = 0; i < length; ++i) {  // those of a_k b_(length + i - k) with k < length
            ball sum(0);
            for (int k = 0; k < length; ++k) {
                sum += a[static_cast<std::size_t>(k)] * b[static_cast<std::size_t>(length + i - k)];
            }
            exact.push_back(sum);
        }
    }
    const precision_scope scope(60);
    std::vector<ball> sums(length, ball(0));
    fast_product<ball>()->add_middle(sums.data(), length, a.data(), length, b.data(), 2 * length);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        CAPTURE(i);
        CHECK(contains(sums[i], exact[i]));
        CHECK(certainly_less(radius_of(sums[i]), abs(exact[i]) * pow(ball(10), -50L)));
    }
}

}  // namespace expansion_fast_product_test
