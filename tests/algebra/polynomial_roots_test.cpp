#include "libration/algebra/polynomial_roots.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "libration/series/arithmetic.hpp"
#include "scalars.hpp"

namespace series_polynomial_roots_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;

namespace {

// (x - r_1) ... (x - r_n).
template <class T>
power_series<T> with_roots(const std::vector<T>& roots) {
    std::vector<T> p{T(1)};
    for (const T& r : roots) {
        p.insert(p.begin(), T(0));
        for (std::size_t i = 0; i + 1 < p.size(); ++i) {
            p[i] -= r * p[i + 1];
        }
    }
    return power_series<T>(p);
}

// By real part, then by imaginary part.
template <class T>
std::vector<polynomial_root<T>> sorted(polynomial_roots<T> found) {
    std::sort(found.all.begin(), found.all.end(), [](const auto& a, const auto& b) {
        return a.at.re < b.at.re || (a.at.re == b.at.re && a.at.im < b.at.im);
    });
    return found.all;
}

// The distance of z from the nearest root.
template <class T>
T distance(const polynomial_roots<T>& found, const complex_number<T>& z) {
    T least = modulus_of(found.all.front().at - z);
    for (const auto& root : found.all) {
        least = std::min(least, T(modulus_of(root.at - z)));
    }
    return least;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the roots of (x-1)...(x-10) are found within their error bounds", "[series][roots]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    std::vector<T> exact;
    for (int r = 1; r <= 10; ++r) {
        exact.push_back(T(r));
    }
    const auto found = roots_of(with_roots(exact));
    REQUIRE(found.converged);
    REQUIRE(found.all.size() == 10);
    const auto roots = sorted(found);
    for (std::size_t i = 0; i < 10; ++i) {
        const auto off = modulus_of(roots[i].at - complex_number<T>{exact[i]});
        CHECK(off <= roots[i].error_bound);
        // n (|p| + rounding) <= 2 n 4 n eps sum |a_i| x^i, and sum |a_i| x^i = (x+1)...(x+10).
        T allowed = epsilon<T>() * 801;
        for (int r = 1; r <= 10; ++r) {
            const int apart = static_cast<int>(i) + 1 - r;
            allowed *= (exact[i] + r) / (apart == 0 ? 1 : apart < 0 ? -apart : apart);
        }
        CHECK(roots[i].error_bound <= allowed);
    }
}

TEMPLATE_LIST_TEST_CASE("the roots of x^n = 1 lie on the circle", "[series][roots]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::cos;
    using std::sin;
    for (const int n : {1, 2, 3, 8, 30}) {
        auto p = power_series<T>::zero(n);
        p[0] = T(-1);
        p[n] = T(1);
        const auto found = roots_of(p);
        INFO("n = " << n);
        REQUIRE(found.converged);
        for (int j = 0; j < n; ++j) {
            const T angle = pi<T>() * (2 * j) / n;
            // |p| <= 4 n eps (1 + 1) settles a root, |p'| = n.
            CHECK(distance(found, complex_number<T>{cos(angle), sin(angle)}) <= epsilon<T>() * 12);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("roots of very different sizes are all found", "[series][roots]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const std::vector<T> exact{T(1) / 1048576, T(-1) / 1024, T(3), T(4096), T(-4194304)};
    const auto found = roots_of(with_roots(exact));
    REQUIRE(found.converged);
    CHECK(found.steps < 20);  // the polygon starts next to each
    for (const T& r : exact) {
        using std::abs;
        CHECK(distance(found, complex_number<T>{r}) <= abs(r) * epsilon<T>() * 200);  // 5 * 4 * 5 twice
    }
}

TEMPLATE_LIST_TEST_CASE("a multiple root is found as well as the digits allow, and says so", "[series][roots]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::pow;
    // (x - 1)^4 (x + 2)
    const auto found = roots_of(with_roots<T>({T(1), T(1), T(1), T(1), T(-2)}));
    REQUIRE(found.converged);
    int near_one = 0;
    for (const auto& root : found.all) {
        const auto off = modulus_of(root.at - complex_number<T>{T(1)});
        if (off < T(1)) {
            ++near_one;
            // Settled means |x-1|^4 * 3 <= 4 n eps sum |a_i| = 20 * 48 eps, so |x - 1| <= (320 eps)^(1/4).
            CHECK(off <= pow(T(epsilon<T>() * 400), T(T(1) / 4)));
            CHECK(off <= root.error_bound);
        }
    }
    CHECK(near_one == 4);
    CHECK(distance(found, complex_number<T>{T(-2)}) <= epsilon<T>() * 100);
}

TEST_CASE("a cluster closer than the digits resolve is no exact root", "[series][roots]") {
    // 1 and 1 + 2^-40: in double the two are known to about sqrt(eps) = 1.5e-8 only, in 60 digits to the last.
    const auto gap = [](const auto& found) {
        const auto roots = sorted(found);
        return modulus_of(roots[1].at - roots[0].at);
    };
    const double apart = std::ldexp(1.0, -40);
    const auto rounded = roots_of(with_roots<double>({1, 1 + apart}));
    CHECK(rounded.all[0].error_bound > apart);
    const precision_scope scope(60);
    const mpfr exact = ldexp(mpfr(1), -40);
    const auto found = roots_of(with_roots<mpfr>({mpfr(1), mpfr(1 + exact)}));
    CHECK(found.converged);
    CHECK(abs(gap(found) - exact) <= mpfr("1e-45"));  // 1e-60 over |p'| = 1e-12, with its constants
}

TEST_CASE("zeros of random real polynomials come in conjugate pairs and multiply to the constant term",
          "[series][roots]") {
    const precision_scope scope(50);
    std::mt19937 random(7);
    std::uniform_int_distribution<int> coefficient(-1000, 1000);
    for (int n = 1; n <= 25; ++n) {
        auto p = power_series<mpfr>::zero(n);
        for (int i = 0; i <= n; ++i) {
            p[i] = mpfr(coefficient(random));
        }
        p[n] = mpfr(17);
        const auto found = roots_of(p);
        INFO("degree " << n);
        REQUIRE(found.converged);
        complex_number<mpfr> product{mpfr(n % 2 == 0 ? 17 : -17)};
        for (const auto& root : found.all) {
            product = product * root.at;
            CHECK(distance(found, complex_number<mpfr>{root.at.re, mpfr(-root.at.im)}) <= root.error_bound * 2);
        }
        CHECK(abs(product.re - p[0]) <= mpfr("1e-40") * (abs(p[0]) + 1));
        CHECK(abs(product.im) <= mpfr("1e-40") * (abs(p[0]) + 1));
    }
}

TEST_CASE("roots 0 are exact, constants have none, and the steps end", "[series][roots]") {
    const auto found = roots_of(power_series<double>({0, 0, -2, 1}));
    REQUIRE(found.all.size() == 3);
    CHECK(distance(found, complex_number<double>{2}) <= 1e-15);
    CHECK(std::count_if(found.all.begin(), found.all.end(), [](const auto& r) { return r.at.re == 0; }) == 2);
    CHECK(roots_of(power_series<double>({3})).all.empty());
    CHECK(roots_of(power_series<double>({3})).converged);
    const auto cut = roots_of(power_series<double>({1, 2, 3, 4, 5}), 1);
    CHECK_FALSE(cut.converged);
    CHECK(cut.steps == 1);
    CHECK_THROWS_AS(roots_of(power_series<double>({1, 0})), libration::error);
}

}  // namespace series_polynomial_roots_test
