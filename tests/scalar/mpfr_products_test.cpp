// Inner products of mpfr: one rounding of a sum in fixed point. Compared with exact fractions.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <vector>

#include "libration/scalar/inner_product.hpp"
#include "scalars.hpp"

namespace scalar_mpfr_products_test {

using namespace libration;
using tests::fraction_of;

namespace {

// Of the precision in force and of others, with exponents that vary by `spread` bits; some are 0.
std::vector<mpfr> random_numbers(std::mt19937& random, int count, int spread) {
    std::uniform_int_distribution<int> exponent(-spread, spread);
    std::uniform_int_distribution<int> bits(1, 700);
    std::vector<mpfr> numbers;
    gmp_randstate_t state;
    gmp_randinit_default(state);
    gmp_randseed_ui(state, random());
    for (int i = 0; i < count; ++i) {
        mpfr x;
        if (i % 3 == 1) {
            mpfr_set_prec(handle(x), bits(random));
        }
        mpfr_urandomb(handle(x), state);
        mpfr_mul_2si(handle(x), handle(x), exponent(random), MPFR_RNDN);
        if (random() % 2 == 0) {
            mpfr_neg(handle(x), handle(x), MPFR_RNDN);
        }
        if (random() % 11 == 0) {
            mpfr_set_zero(handle(x), 1);
        }
        numbers.push_back(x);
    }
    gmp_randclear(state);
    return numbers;
}

}  // namespace

TEST_CASE("an inner product of mpfr is the exact sum, rounded once", "[scalar][mpfr][mpfr_products]") {
    std::mt19937 random(7);
    for (const int digits : {2, 15, 19, 20, 38, 39, 60, 160, 700}) {
        const precision_scope scope(digits);
        for (const int spread : {0, 3, 70, 2000}) {
            for (const int count : {1, 2, 3, 17, 64}) {
                const auto x = random_numbers(random, 2 * count, spread);
                const auto y = random_numbers(random, count, spread);
                rational sum = 0;
                rational largest = 0;
                for (int i = 0; i < count; ++i) {
                    const rational term = fraction_of(x[static_cast<std::size_t>(2 * i)]) *
                                          fraction_of(y[static_cast<std::size_t>(count - 1 - i)]);
                    sum += term;
                    largest = std::max(largest, rational(abs(term)));
                }
                const mpfr found = inner_product(x.data(), 2, &y.back(), -1, count);
                REQUIRE(mpfr_get_prec(handle(found)) == mpfr_get_prec(handle(mpfr())));
                // Half a unit in the last place of the sum, and 2^(-p-30) of the largest product.
                const rational unit = fraction_of(mpfr(epsilon<mpfr>()));
                const rational allowed = abs(sum) * unit / 2 + largest * unit / (integer(1) << 31);
                INFO(digits << " digits, " << count << " terms over " << spread << " bits");
                REQUIRE(abs(rational(fraction_of(found) - sum)) <= allowed);
            }
        }
    }
}

TEST_CASE("an inner product of mpfr knows squares, nothing, and what is no number", "[scalar][mpfr][mpfr_products]") {
    const precision_scope scope(50);
    const std::vector<mpfr> x{mpfr(3), mpfr(-4), mpfr(0)};
    CHECK(inner_product(x.data(), 1, x.data(), 1, 3) == 25);
    CHECK(inner_product(x.data(), 1, x.data(), 1, 0) == 0);
    CHECK(inner_product(x.data() + 2, 1, x.data(), 1, 1) == 0);
    // Cancellation is exact if the terms are: 3 * 5 - 4 * 15/4.
    const std::vector<mpfr> y{mpfr(5), mpfr(mpfr(15) / 4), mpfr(9)};
    CHECK(inner_product(x.data(), 1, y.data(), 1, 3) == 0);
    // A sum of terms far below the largest one, which cancels, is accurate to 2^-30 beyond the precision.
    const std::vector<mpfr> ones{mpfr(1), mpfr(1), mpfr(1)};
    const std::vector<mpfr> cancel{mpfr(1), ldexp(mpfr(1), -180), mpfr(-1)};
    CHECK(inner_product(ones.data(), 1, cancel.data(), 1, 3) == ldexp(mpfr(1), -180));
    const mpfr infinite = std::numeric_limits<mpfr>::infinity();
    const std::vector<mpfr> with_infinity{mpfr(1), infinite, mpfr(2)};
    CHECK(inner_product(ones.data(), 1, with_infinity.data(), 1, 3) == infinite);
    const std::vector<mpfr> zeros{mpfr(0), mpfr(0), mpfr(0)};
    CHECK(isnan(inner_product(zeros.data(), 1, with_infinity.data(), 1, 3)));
}

}  // namespace scalar_mpfr_products_test
