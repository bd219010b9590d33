// The kernels over fractions, where every identity is exact, over complex numbers, and fed one coefficient at a time.
#include "libration/series/kernel.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "libration/scalar/complex_functions.hpp"
#include "libration/series/exponential.hpp"
#include "libration/series/square_root.hpp"
#include "libration/series/tangent.hpp"
#include "proved.hpp"
#include "scalars.hpp"
#include "series/random_series.hpp"

namespace series_kernel_test {

using namespace libration;
using namespace libration::series;
using namespace libration::tests;

namespace {

constexpr int order = 14;
const rational zero(0);
const rational one(1);

// A fraction for each power, the constant as given.
power_series<rational> fractions(const rational& first, int seed) {
    auto f = power_series<rational>::zero(order);
    f[0] = first;
    for (int n = 1; n <= order; ++n) {
        f[n] = rational((n * seed) % 7 - 3) / ((n + seed) % 5 + 1);
    }
    return f;
}

template <ring R>
power_series<R> unit() {
    auto f = power_series<R>::zero(order);
    f[0] = R(1);
    return f;
}

template <ring R>
bool same(const power_series<R>& a, const power_series<R>& b) {
    return a.coefficients() == b.coefficients();
}

}  // namespace

TEST_CASE("over fractions exponential, logarithm and powers obey their laws exactly", "[series][kernel]") {
    const auto f = fractions(zero, 3);
    const auto g = fractions(zero, 5);
    const auto e = exponential(f, one);
    CHECK(same(derivative(e), derivative(f) * e));
    CHECK(same(e * exponential(g, one), exponential(f + g, one)));
    CHECK(same(logarithm(e, zero), f));
    const auto h = fractions(one, 4);
    CHECK(same(exponential(logarithm(h, zero), one), h));
    const auto root = power(h, rational(rational(1) / 3), one);
    CHECK(same(root * root * root, h));
    CHECK(same(power(h, rational(-2), one) * h * h, unit<rational>()));
    CHECK(same(square_root(h * h, one), h));
    CHECK(same(square_root(h, one) * square_root(h, one), h));
    CHECK(same(square_root(h * h, rational(-1)), unit<rational>() - h - unit<rational>()));
}

TEST_CASE("over fractions sine, cosine and the tangents obey their laws exactly", "[series][kernel]") {
    const auto f = fractions(zero, 3);
    const auto [s, c] = sine_cosine(f, zero, one);
    CHECK(same(s * s + c * c, unit<rational>()));
    CHECK(same(derivative(s), derivative(f) * c));
    const auto t = tangent(f, zero);
    CHECK(same(t, s / c));
    CHECK(same(derivative(t), derivative(f) * (unit<rational>() + t * t)));
    CHECK(same(arctangent(t, zero), f));
    CHECK(same(tangent(arctangent(f, zero), zero), f));
    const auto e = exponential(f + f, one);
    CHECK(same(hyperbolic_tangent(f, zero), (e - unit<rational>()) / (e + unit<rational>())));
    // From an angle with sine 3/5 and cosine 4/5, which is no fraction itself.
    const auto [s2, c2] = sine_cosine(f, rational(rational(3) / 5), rational(rational(4) / 5));
    CHECK(same(s2 * s2 + c2 * c2, unit<rational>()));
    CHECK(same(tangent(f, rational(rational(3) / 4)), s2 / c2));
}

TEST_CASE("over fractions hyperbolic functions and the arcsine obey their laws exactly", "[series][kernel]") {
    const auto f = fractions(zero, 3);
    const auto slope = slope_of(f);
    auto s = power_series<rational>::zero(order);
    auto c = s;
    auto a = s;
    auto root = s;
    auto slope_a = s;
    c[0] = 1;
    root[0] = 1;
    for (int n = 0; n <= order; ++n) {
        hyperbolic_sine_cosine_kernel(slope.data(), s.data(), c.data(), n);
        arcsine_kernel(f.data(), slope.data(), root.data(), slope_a.data(), a.data(), n);
    }
    CHECK(same(c * c - s * s, unit<rational>()));
    CHECK(same(s + c, exponential(f, one)));
    CHECK(same(sine_cosine(a, zero, one).first, f));
    CHECK(same(root * root + f * f, unit<rational>()));
}

TEST_CASE("a progression leaves out zeros and nothing else", "[series][kernel]") {
    // Every third coefficient, from the second on; its square stands in degrees 2 * 2 + 3k.
    auto f = power_series<rational>::zero(order);
    for (int n = 2; n <= order; n += 3) {
        f[n] = rational(n + 1) / (n + 4);
    }
    const progression thirds(3, 2);
    const auto g = fractions(one, 4);
    for (int n = 0; n <= order; ++n) {
        CHECK(product_coefficient(f, g, n, thirds) == product_coefficient(f, g, n));
        CHECK(square_coefficient(f, n, thirds) == square_coefficient(f, n));
        CHECK(thirds.from(n) == (n + (2 - n % 3)));
        CHECK(thirds.holds(n) == (n % 3 == 2));
    }
    CHECK(degrees_of_slope(thirds).first == 1);
    CHECK(degrees_of_slope(progression(3, 0)).first == 2);
    CHECK(progression(parity::odd).first == 1);
}

TEST_CASE("kernels solve an equation one coefficient at a time", "[series][kernel]") {
    // y' = exp(-y), y(0) = 0: y = log(1 + x).
    std::vector<rational> y(order + 2);
    std::vector<rational> minus(order + 2);
    std::vector<rational> slope(order + 2);
    std::vector<rational> e(order + 2);
    e[0] = 1;
    for (int n = 0; n <= order; ++n) {
        const auto i = static_cast<std::size_t>(n);
        minus[i] = -y[i];
        slope_kernel(minus.data(), slope.data(), n);
        exponential_kernel(slope.data(), e.data(), n);
        y[i + 1] = e[i] / (n + 1);
        CHECK(y[i + 1] == rational(n % 2 == 0 ? 1 : -1) / (n + 1));
    }
    // t' = 1 + t^2, t(0) = 0, is the tangent of x.
    std::vector<rational> t(order + 2);
    std::vector<rational> square(order + 1);
    for (int n = 0; n <= order; ++n) {
        const auto i = static_cast<std::size_t>(n);
        square_kernel(t.data(), square.data(), n);
        t[i + 1] = (square[i] + (n == 0 ? 1 : 0)) / (n + 1);
    }
    auto x = power_series<rational>::zero(order);
    x[1] = 1;
    const auto tan_x = tangent(x, zero);
    for (int n = 0; n <= order; ++n) {
        CHECK(tan_x[n] == t[static_cast<std::size_t>(n)]);
    }
    CHECK(tan_x[5] == rational(2) / 15);
}

TEMPLATE_LIST_TEST_CASE("over complex numbers exp(if) is cos f + i sin f", "[series][kernel]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    auto f = power_series<T>::zero(order);
    auto turned = power_series<complex_number<T>>::zero(order);
    auto magnitude = f;
    for (int n = 0; n <= order; ++n) {
        f[n] = T((n * 5) % 7 - 3) / (1 << n);
        turned[n] = {T(0), f[n]};
        magnitude[n] = f[n] < 0 ? T(-f[n]) : f[n];
    }
    const auto e = exponential(turned);
    const auto [s, c] = sine_cosine(f);
    const auto majorant = exponential(magnitude);
    for (int n = 0; n <= order; ++n) {
        INFO("degree " << n);
        // As in exponential_test.cpp, twice: both sides walk.
        CHECK_THAT(e[n].re, near<T>(c[n], 4, majorant[n]));
        CHECK_THAT(e[n].im, near<T>(s[n], 4, majorant[n]));
    }
}

TEST_CASE("over complex balls the functions of series undo each other", "[series][kernel][ball]") {
    const precision_scope scope(40);
    auto f = power_series<complex_number<ball>>::zero(order);
    for (int n = 0; n <= order; ++n) {
        f[n] = {ball((n * 5) % 7 + 1) / (8 << n), ball((n * 3) % 5 - 2) / (32 << n)};
    }
    const auto check = [](const power_series<complex_number<ball>>& a, const power_series<complex_number<ball>>& b) {
        for (int n = 0; n <= b.order(); ++n) {
            INFO("degree " << n);
            CHECK(overlaps(a[n].re, b[n].re));
            CHECK(overlaps(a[n].im, b[n].im));
            // 20 of 40 digits are left: f_0^-14, which log and powers have, takes 13.
            CHECK(certainly_less(radius_of(a[n].re) + radius_of(a[n].im), ldexp(ball(1), -66)));
        }
    };
    check(logarithm(exponential(f)), f);
    check(exponential(logarithm(f)), f);
    check(arctangent(tangent(f)), f);
    check(power(power(f, complex_number<ball>(3)), complex_number<ball>(ball(1) / 3)), f);
    const auto [s, c] = sine_cosine(f);
    check(tangent(f), s / c);
    check(s * s + c * c, unit<complex_number<ball>>());
    const auto e = exponential(f + f);
    check(hyperbolic_tangent(f), (e - unit<complex_number<ball>>()) / (e + unit<complex_number<ball>>()));
}

}  // namespace series_kernel_test
