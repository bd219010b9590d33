#include "libration/series/exponential.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"
#include "series/random_series.hpp"

namespace series_exponential_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;

namespace {

constexpr int order = 16;

// f_n = (integer -3 .. 3) / 2^n, exact in every scalar: coefficients of a function that is as wild at |x| = 2.
template <class T>
power_series<T> random_dyadic(int constant_in_quarters, parity p = parity::any) {
    tests::random_series random;
    auto f = rescale(random.of_order<T>(order, 0, p), T(T(1) / 2));
    f[0] = T(constant_in_quarters) / 4;
    return f;
}

template <class T>
power_series<T> magnitudes(power_series<T> f) {
    using std::abs;
    for (int n = 0; n <= f.order(); ++n) {
        f[n] = abs(f[n]);
    }
    return f;
}

// Every coefficient n of a and b equal within ulps * epsilon of coefficient n of a majorant.
template <class T>
void check_near(const power_series<T>& a, const power_series<T>& b, long ulps, const power_series<T>& majorant) {
    REQUIRE(a.order() == b.order());
    for (int n = 0; n <= a.order(); ++n) {
        INFO("degree " << n);
        CHECK_THAT(a[n], tests::near<T>(b[n], ulps, majorant[n]));
    }
}

template <class T>
power_series<T> constant(int value) {
    auto series = power_series<T>::zero(order);
    series[0] = T(value);
    return series;
}

}  // namespace

// How errors are bounded here. Computed with |f| instead of f, the recurrence of exp has only positive terms, so each
// coefficient is right to a few epsilon times its degree, and it majorises all partial sums of the recurrences of exp,
// sin and cos of f. An error d in e = exp f is an error d/e in log e: hence exp|f| exp|f| as the scale of the way back.
// Half an epsilon in each of 16 degrees, random in sign, adds up to sqrt(16)/2 epsilon.
constexpr long walked = 2;

TEMPLATE_LIST_TEST_CASE("logarithm and exponential are inverse", "[series][exponential]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto f = random_dyadic<T>(3);
    const auto majorant = exponential(magnitudes(f));
    check_near(logarithm(exponential(f)), f, walked, majorant * majorant);
    const auto g = random_dyadic<T>(4);
    const auto inverse = magnitudes(constant<T>(1) / (constant<T>(2) - magnitudes(g)));  // majorises 1/g: g_0 = 1
    check_near(exponential(logarithm(g)), g, walked, magnitudes(g) * inverse * inverse);
}

TEMPLATE_LIST_TEST_CASE("the exponential solves e' = f' e and adds up", "[series][exponential]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto f = random_dyadic<T>(-2);
    const auto g = random_dyadic<T>(5);
    const auto e = exponential(f);
    const auto majorant = exponential(magnitudes(f)) * exponential(magnitudes(g));
    const auto slope_scale = derivative(magnitudes(f)) * exponential(magnitudes(f)).truncated(order - 1);
    check_near<T>(derivative(e), derivative(f) * e, walked, slope_scale);
    check_near<T>(exponential(f) * exponential(g), exponential(f + g), walked, majorant);
}

TEMPLATE_LIST_TEST_CASE("sine and cosine stay on the circle and double their angle", "[series][exponential]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto f = random_dyadic<T>(7);
    const auto [s, c] = sine_cosine(f);
    const auto [s2, c2] = sine_cosine(f + f);
    const auto e = exponential(magnitudes(f));
    check_near<T>(s * s + c * c, constant<T>(1), walked, e * e);
    check_near<T>(s * c + c * s, s2, walked, e * e);
    check_near<T>(c * c - s * s, c2, walked, e * e);
    CHECK(s.order() == order);
}

TEMPLATE_LIST_TEST_CASE("a start with known sine, cosine and parity gives the same series", "[series][exponential]",
                        all_scalars) {
    using T = typename TestType::type;
    using std::cos, std::sin;
    const typename TestType::precision precision;
    const auto p = GENERATE(parity::any, parity::even, parity::odd);
    const auto f = random_dyadic<T>(3, p);
    const auto [with_s, with_c] = sine_cosine(f, T(sin(f[0])), T(cos(f[0])), p);
    const auto [s, c] = sine_cosine(f);
    // The same products, in double added in another order.
    check_near(with_s, s, walked, exponential(magnitudes(f)));
    check_near(with_c, c, walked, exponential(magnitudes(f)));
}

TEMPLATE_LIST_TEST_CASE("a start with known sine and cosine does not ask the angle", "[series][exponential]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // sin(pi + x) = -sin x with pi exactly, which no scalar holds.
    const power_series<T> f(std::vector<T>{pi<T>(), T(1), T(0)});
    const auto [s, c] = sine_cosine(f, T(0), T(-1), parity::odd);
    CHECK(s.coefficients() == std::vector<T>{T(0), T(-1), T(0)});
    CHECK(c.coefficients() == std::vector<T>{T(-1), T(0), T(T(1) / 2)});
}

// Integer coefficients and f_0 = 1: all of these series have integer coefficients, and nothing is rounded.
TEMPLATE_LIST_TEST_CASE("powers of a series obey the laws of powers exactly", "[series][exponential]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    for (int round = 0; round < 10; ++round) {
        const auto f = random.of_order<T>(9, 1, parity::any, 2);
        CHECK(power(f, T(3)).coefficients() == (f * f * f).coefficients());
        CHECK((power(f, T(-1)) * f).coefficients() == constant<T>(1).truncated(9).coefficients());
        CHECK(power(f * f, T(T(1) / 2)).coefficients() == f.coefficients());
        CHECK(power(f, T(0)).coefficients() == constant<T>(1).truncated(9).coefficients());
    }
}

TEMPLATE_LIST_TEST_CASE("elementary functions have their Taylor coefficients", "[series][exponential]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto x = power_series<T>::zero(order);
    x[1] = T(1);
    const auto e = exponential(x);
    const auto [s, c] = sine_cosine(x);
    const auto l = logarithm(constant<T>(1) + x);
    const auto root = power(constant<T>(1) + x, T(T(1) / 3));
    rational factorial = 1;
    rational binomial = 1;  // C(1/3, n)
    for (int n = 0; n <= order; ++n) {
        INFO("degree " << n);
        const T inverse = from_rational<T>(rational(1) / factorial);
        const T nought(0);
        // One division a degree, half an epsilon each.
        CHECK_THAT(e[n], tests::near<T>(inverse, order / 2));
        CHECK_THAT(s[n], tests::near<T>(n % 2 == 0 ? nought : n % 4 == 1 ? inverse : T(-inverse), order / 2));
        CHECK_THAT(c[n], tests::near<T>(n % 2 == 1 ? nought : n % 4 == 0 ? inverse : T(-inverse), order / 2));
        CHECK_THAT(l[n], tests::near<T>(n == 0 ? nought : T(T(n % 2 == 1 ? 1 : -1) / n), 1));
        // 1/3 is rounded, and a degree has three more roundings, half an epsilon each.
        CHECK_THAT(root[n], tests::near<T>(from_rational<T>(binomial), 2 * order));
        factorial *= n + 1;
        binomial *= (rational(1) / 3 - n) / (n + 1);
    }
}

TEMPLATE_LIST_TEST_CASE("one more coefficient does not change the earlier ones", "[series][exponential]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto f = random_dyadic<T>(5);
    const auto g = f.truncated(6);
    CHECK(exponential(g).coefficients() == exponential(f).truncated(6).coefficients());
    CHECK(logarithm(g).coefficients() == logarithm(f).truncated(6).coefficients());
    CHECK(power(g, T(T(1) / 3)).coefficients() == power(f, T(T(1) / 3)).truncated(6).coefficients());
    CHECK(sine_cosine(g).first.coefficients() == sine_cosine(f).first.truncated(6).coefficients());
    CHECK(sine_cosine(g).second.coefficients() == sine_cosine(f).second.truncated(6).coefficients());
}

}  // namespace series_exponential_test
