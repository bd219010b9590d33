#include "libration/series/scaled_quotient.hpp"

#include <catch2/catch.hpp>
#include <cstddef>
#include <optional>
#include <vector>

#include "libration/scalar/ball/quotient.hpp"
#include "proved.hpp"
#include "scalars.hpp"
#include "series/random_series.hpp"

namespace series_scaled_quotient_test {

using namespace libration;
using namespace libration::series;

TEST_CASE("mpfr divides whole sequences only where the program says so", "[series][convolution][ball]") {
    CHECK_FALSE(has_whole_quotients<mpfr>());
    {
        const whole_quotient_scope fast(quotient_by_flint);
        CHECK(supplied_quotient() == quotient_by_flint);
        CHECK(has_whole_quotients<mpfr>());
        const whole_quotient_scope slow(nullptr);
        CHECK_FALSE(has_whole_quotients<mpfr>());
    }
    CHECK(supplied_quotient() == nullptr);
    CHECK(has_whole_quotients<ball>());
    CHECK_FALSE(has_whole_quotients<double>());
}

TEST_CASE("FLINT's quotients of mpfr numbers are those of one coefficient at a time", "[series][convolution][ball]") {
    const precision_scope scope(40);
    const whole_quotient_scope fast(quotient_by_flint);
    tests::random_series random;
    // Poles far outside of the unit circle: |b_k| <= 3/(k + 1)^2 beside b_0 = 64.
    for (const int order : {0, 3, 150}) {
        const auto a = random.of_order<mpfr>(order, 2);
        auto b = random.of_order<mpfr>(order + 5, 64);
        for (int n = 1; n <= b.order(); ++n) {
            b[n] /= (n + 1) * (n + 1);
        }
        const auto q = quotient_by_flint(a.coefficients(), b.coefficients());
        REQUIRE(q);
        REQUIRE(q->size() == a.coefficients().size());
        const auto checked = quotient(a, b);
        // The contract's 2^48 epsilon of the largest coefficient, which is below 1/16 and holds the other side's too.
        const mpfr allowed = ldexp(epsilon<mpfr>(), 48 - 4);
        for (int n = 0; n <= order; ++n) {
            INFO(n << " of " << order);
            CHECK(abs(mpfr((*q)[static_cast<std::size_t>(n)] - checked[n])) <= allowed);
            CHECK(scaled_quotient(a, b)[n] == (*q)[static_cast<std::size_t>(n)]);
        }
    }
}

TEST_CASE("a quotient whose radii prove too little is left to the recurrence", "[series][convolution][ball]") {
    const precision_scope scope(20);
    constexpr int order = 60;
    auto one = power_series<mpfr>::zero(order);
    auto b = one;  // 1 + x - x^2 + x^3 - .. = (1 + 2x)/(1 + x)
    one[0] = 1;
    b[0] = 1;
    for (int n = 1; n <= order; ++n) {
        b[n] = n % 2 == 0 ? -1 : 1;
    }
    std::vector<mpfr> without_first(b.coefficients());
    without_first[0] = 0;
    CHECK_FALSE(quotient_by_flint(one.coefficients(), without_first));
    const std::vector<mpfr> nothing(order + 1, mpfr(0));
    const whole_quotient_scope fast(quotient_by_flint);
    CHECK(scaled_quotient(power_series<mpfr>(nothing), b).coefficients() == nothing);
    const auto never = [](const std::vector<mpfr>&, const std::vector<mpfr>&) {
        return std::optional<std::vector<mpfr>>();
    };
    const whole_quotient_scope none_proved(never);
    const auto q = scaled_quotient(one, b);
    CHECK(q[0] == 1);
    for (int n = 1; n <= order; ++n) {
        CHECK(q[n] == ldexp(mpfr(n % 2 == 0 ? 1 : -1), n - 1));
    }
}

}  // namespace series_scaled_quotient_test
