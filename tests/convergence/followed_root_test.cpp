#include "libration/convergence/followed_root.hpp"

#include <catch2/catch.hpp>
#include <functional>

#include "scalars.hpp"

namespace convergence_followed_root_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::series;
using namespace libration::tests;

namespace {

// What is thought to be left of an error e(K) at K = 80 coefficients.
fitting::leftover left_of(const std::function<mpfr(int)>& error) {
    const auto fewer = fitting::fewer_coefficients(80, 10);
    std::vector<complex_number<mpfr>> values;
    for (const int without : fewer) {
        values.push_back({mpfr(1 + error(80 - without))});
    }
    return fitting::left_after(values, fewer[4]);
}

}  // namespace

TEST_CASE("what is left of an error follows from its decrease", "[convergence][followed_root]") {
    const precision_scope scope(200);
    for (const int base : {2, 3, 10}) {
        const auto geometric = [base](int k) { return mpfr(pow(mpfr(base), -k)); };
        const auto left = left_of(geometric);
        INFO(base);
        // The rate is taken from 10 and 20 coefficients less, where it is rho to a factor (1 + rho^10)^(1/10).
        CHECK(left.likely > geometric(80) * 99 / 100);
        CHECK(left.likely < geometric(80) * 101 / 100);
        CHECK(left.safe >= left.likely);
    }
    for (int p = 1; p <= 3; ++p) {
        const auto algebraic = [p](int k) { return mpfr(pow(mpfr(k), -p)); };
        const auto left = left_of(algebraic);
        INFO(p);
        CHECK(left.likely > algebraic(80));
        CHECK(left.likely < algebraic(80) * 8 * p * 2);  // 8 |x_0 - x_s| is about p e for s = K/8, (8/7)^p - 1 of it
    }
    // Noise alone: nothing is concluded from steps that do not shrink.
    const auto noise = left_of([](int k) { return mpfr(mpfr((k * 7) % 5 - 2) / 1000); });
    CHECK(noise.likely >= mpfr(1) / 1000);
}

TEST_CASE("fewer coefficients are an eighth and a quarter, or what can be spared", "[convergence][followed_root]") {
    CHECK(fitting::fewer_coefficients(80, 10) == std::vector<int>{0, 1, 2, 3, 10, 20});
    CHECK(fitting::fewer_coefficients(20, 16) == std::vector<int>{0, 1, 2, 3, 2, 4});
    CHECK(fitting::fewer_coefficients(20, 10) == std::vector<int>{0, 1, 2, 3, 2, 4});
}

TEST_CASE("starts are found where long double parts the roots, and beyond", "[convergence][followed_root]") {
    const precision_scope scope(60);
    // (x - 1)(x^2 + 2x + 5): roots 1, -1 +- 2i.
    const auto easy = fitting::starting_roots(power_series<mpfr>({-5, 3, 1, 1}));
    REQUIRE(easy.size() == 2);
    CHECK(modulus_of(easy[0] - complex_number<mpfr>{mpfr(1)}) < mpfr(1) / 1000000);
    CHECK(modulus_of(easy[1] - complex_number<mpfr>{mpfr(-1), mpfr(2)}) < mpfr(1) / 1000000);
    // Wilkinson's polynomial of degree 20, roots 1 .. 20: ill-conditioned to 1e13.
    power_series<mpfr> wilkinson({mpfr(1)});
    for (int root = 1; root <= 20; ++root) {
        auto next = power_series<mpfr>::zero(root);
        for (int n = 0; n < root; ++n) {
            next[n] -= wilkinson[n] * root;
            next[n + 1] += wilkinson[n];
        }
        wilkinson = next;
    }
    const auto hard = fitting::starting_roots(wilkinson);
    REQUIRE(hard.size() == 20);
    for (int root = 1; root <= 20; ++root) {
        const auto polished = fitting::polished(wilkinson, hard[static_cast<std::size_t>(root - 1)]);
        REQUIRE(polished);
        CHECK_THAT(polished->re, near(mpfr(root), 1L << 60));
        CHECK(polished->im == 0);
    }
}

TEST_CASE("roots are polished to all digits", "[convergence][followed_root]") {
    // (x - 3)(x^2 - 2x + 5)(x^2 + x/3 + 7/9): 3, 1 +- 2i, -1/6 +- i sqrt(27)/6.
    for (const long digits : {37, 61, 160, 1000}) {
        const precision_scope scope(digits);
        const mpfr third = mpfr(1) / 3;
        power_series<mpfr> p({mpfr(1)});
        for (const power_series<mpfr>& factor :
             {power_series<mpfr>({-3, 1}), power_series<mpfr>({5, -2, 1}),
              power_series<mpfr>(std::vector<mpfr>{third * 7 * third, third, mpfr(1)})}) {
            auto next = power_series<mpfr>::zero(p.order() + factor.order());
            for (int i = 0; i <= p.order(); ++i) {
                for (int j = 0; j <= factor.order(); ++j) {
                    next[i + j] += p[i] * factor[j];
                }
            }
            p = next;
        }
        const std::vector<complex_number<mpfr>> roots{
            {mpfr(3), mpfr(0)}, {mpfr(1), mpfr(2)}, {mpfr(mpfr(-1) / 6), mpfr(sqrt(mpfr(27)) / 6)}};
        for (const auto& root : roots) {
            const mpfr off = root.im == 0 ? mpfr(0) : ldexp(mpfr(1), -40);
            const auto found = fitting::polished(p, {mpfr(root.re + ldexp(mpfr(1), -40)), mpfr(root.im - off)});
            REQUIRE(found);
            // The values of a polynomial with 6 terms of size about 100 are rounded where its slope is about 10.
            CHECK_THAT(found->re, near(root.re, 1000, mpfr(1)));
            CHECK_THAT(found->im, near(root.im, 1000, mpfr(1)));
            CHECK((found->im == 0) == (root.im == 0));
        }
    }
    const precision_scope scope(100);
    // (x - 3)(x + 5): of the way alone twelve digits are asked for, and one of a step or two is known to all.
    for (const int off : {3, 10, 40, 200}) {
        const mpfr way = ldexp(mpfr(1), -off);
        const auto found = fitting::polished(power_series<mpfr>({-15, 2, 1}), {mpfr(3 + way)}, true);
        REQUIRE(found);
        CHECK(abs(mpfr(found->re - 3)) * 1'000'000'000'000 <= way);
    }
    // No slope, no step; and no real root for a real start.
    CHECK_FALSE(fitting::polished(power_series<mpfr>({1, 0, 1}), {mpfr(0)}));
    CHECK_FALSE(fitting::polished(power_series<mpfr>({1, 0, 1}), {mpfr(mpfr(7) / 5)}));
}

TEST_CASE("values and slopes beside the real axis are those of the definition", "[convergence][followed_root]") {
    const precision_scope scope(50);
    const power_series<mpfr> p({7, -3, 0, 2, -5, 1});
    const fitting::polynomial_values values(p);
    for (const complex_number<mpfr>& z :
         {complex_number<mpfr>{mpfr(2), mpfr(1)}, complex_number<mpfr>{mpfr(0), mpfr(3)},
          complex_number<mpfr>{mpfr(-1), mpfr(0)}}) {
        complex_number<mpfr> value{mpfr(0)};
        complex_number<mpfr> slope{mpfr(0)};
        complex_number<mpfr> power{mpfr(1)};
        for (int n = 0; n <= p.order(); ++n) {
            value = value + power * p[n];
            slope = n < p.order() ? slope + power * mpfr(p[n + 1] * (n + 1)) : slope;
            power = power * z;
        }
        const auto found = values.at(z);  // all in integers
        CHECK(found.value == value);
        CHECK(found.slope == slope);
    }
    const power_series<mpfr> four({4});
    const fitting::polynomial_values constant(four);
    CHECK(constant.at({mpfr(2), mpfr(1)}).value == complex_number<mpfr>{mpfr(4)});
    CHECK(constant.at({mpfr(2), mpfr(1)}).slope == complex_number<mpfr>{mpfr(0)});
}

}  // namespace convergence_followed_root_test
