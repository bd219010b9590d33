#include "libration/scalar/complex_number.hpp"

#include <catch2/catch.hpp>

#include "libration/scalar/complex_functions.hpp"
#include "scalars.hpp"

namespace scalar_complex_number_test {

using namespace libration;
using libration::tests::all_scalars;
using libration::tests::near;

TEMPLATE_LIST_TEST_CASE("complex numbers obey the rules of arithmetic", "[scalar][complex_number]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const complex_number<T> a{T(3), T(-4)};
    const complex_number<T> b{T(-1), T(2)};
    CHECK(modulus_of(a) == 5);
    const auto product = a * b;  // -3 + 6i + 4i + 8
    CHECK(product.re == 5);
    CHECK(product.im == 10);
    const auto back = product / b;
    CHECK(back.re == a.re);
    CHECK(back.im == a.im);
    const auto sum = a + b * T(2);
    CHECK(sum.re == 1);
    CHECK(sum.im == 0);
    CHECK((a - a).re == 0);
}

TEMPLATE_LIST_TEST_CASE("a complex square root squares back, in the right half plane", "[scalar][complex_number]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const int re : {-7, 0, 3, 1000}) {
        for (const int im : {-5, 0, 2, 4000}) {
            const complex_number<T> z{T(re), T(im)};
            const auto root = square_root(z);
            const auto square = root * root;
            INFO(re << " + " << im << " i");
            CHECK(root.re >= 0);
            // Two roundings of the root and two of the square, relative to |z|.
            CHECK_THAT(square.re, near(z.re, 8, modulus_of(z)));
            CHECK_THAT(square.im, near(z.im, 8, modulus_of(z)));
        }
    }
    const auto root = square_root(complex_number<T>{T(-9), T(0)});
    CHECK(root.re == 0);
    CHECK(root.im == 3);
}

TEST_CASE("the small part of a square root keeps its digits", "[scalar][complex_number]") {
    const auto root = square_root(complex_number<double>{-4, 1e-30});
    CHECK(root.im == 2);
    CHECK(std::abs(root.re - 2.5e-31) <= 1e-46);  // im/(2 sqrt 4), which 1e-30 below -4 does not cancel
}

TEMPLATE_LIST_TEST_CASE("sums, products and quotients by a real are those of 3 + 4i", "[scalar]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const complex_number<T> z{T(3), T(4)};
    const complex_number<T> square = z * z;
    CHECK(square.re == -7);
    CHECK(square.im == 24);
    CHECK(modulus_of(z) == 5);
    CHECK((z - z * T(2) + z).im == 0);
    CHECK((-z / T(2)).re == T(-3) / 2);
}

TEMPLATE_LIST_TEST_CASE("hyperbolic functions and the arcsine of complex numbers fulfil their identities", "[scalar]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const complex_number<T> z{T(T(3) / 7), T(T(-5) / 8)};
    const complex_number<T> turned{T(-z.im), z.re};
    // sinh(iz) = i sin z, cosh(iz) = cos z, sin(asin z) = z: a few functions and products of numbers below 2.
    const auto close = [](const complex_number<T>& a, const complex_number<T>& b) {
        CHECK_THAT(a.re, near(b.re, 16, T(1)));
        CHECK_THAT(a.im, near(b.im, 16, T(1)));
    };
    const complex_number<T> sine = sin(z);
    close(sinh(turned), {T(-sine.im), sine.re});
    close(cosh(turned), cos(z));
    close(sin(asin(z)), z);
    close(asin(complex_number<T>{T(T(1) / 2), T(0)}), {T(pi<T>() / 6), T(0)});
}

}  // namespace scalar_complex_number_test
