#include "libration/series/polynomial_blocks.hpp"

#include "libration/series/arithmetic.hpp"
#include "scalars.hpp"

namespace series_polynomial_blocks_test {

using namespace libration;
using namespace libration::series;
using tests::fraction_of;

TEST_CASE("blocks of powers have the value and the slope of the polynomial", "[series][polynomial_blocks]") {
    const precision_scope scope(40);
    for (const int order : {0, 1, 2, 7, 8, 9, 15, 16, 17, 40, 101}) {
        auto a = power_series<mpfr>::zero(order);
        for (int n = 0; n <= order; ++n) {
            a[n] = n % 2 == 1 ? mpfr(0) : mpfr(cos(mpfr(n * n)));
        }
        for (const mpfr& x : {mpfr(0), mpfr(mpfr(2) / 3), mpfr(-1), mpfr(mpfr(-9) / 7)}) {
            rational value = 0;
            rational slope = 0;
            rational sizes = 0;
            rational power = 1;
            const rational at = fraction_of(x);
            for (int n = 0; n <= order; ++n) {
                value += fraction_of(a[n]) * power;
                sizes += abs(rational(fraction_of(a[n]) * power));
                slope += n < order ? rational((n + 1) * fraction_of(a[n + 1]) * power) : rational(0);
                sizes += n < order ? rational(abs(rational((n + 1) * fraction_of(a[n + 1]) * power))) : rational(0);
                power *= at;
            }
            const polynomial_blocks<mpfr> blocks(a, x);
            const jet<mpfr> found = blocks.value_and_slope();
            CHECK(found.value == blocks.value());
            // x^n is made of n products, with half a unit each; sums over blocks, fewer than 16, add as much.
            const rational allowed = sizes * fraction_of(mpfr(epsilon<mpfr>())) * (order + 16) / 2;
            INFO("order " << order);
            CHECK(abs(rational(fraction_of(found.value) - value)) <= allowed);
            CHECK(abs(rational(fraction_of(found.slope) - slope)) <= allowed);
        }
    }
}

TEST_CASE("blocks serve long polynomials of the working precision in mpfr", "[series][polynomial_blocks]") {
    const precision_scope scope(40);
    const auto a = power_series<mpfr>::zero(8);
    CHECK(polynomial_blocks<mpfr>::serve(a, mpfr(1)));
    CHECK_FALSE(polynomial_blocks<mpfr>::serve(power_series<mpfr>::zero(7), mpfr(1)));
    CHECK_FALSE(polynomial_blocks<double>::serve(power_series<double>::zero(100), 1.0));
    // Of more digits they have more than inner products would leave.
    const precision_scope fewer(20);
    CHECK_FALSE(polynomial_blocks<mpfr>::serve(a, mpfr(1)));
    const auto wide = evaluate(a, mpfr(1));
    CHECK(mpfr_get_prec(handle(wide.value)) > mpfr_get_prec(handle(mpfr())));
}

}  // namespace series_polynomial_blocks_test
