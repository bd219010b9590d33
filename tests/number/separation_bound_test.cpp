// Zeros of numbers that are built from fractions by roots: identities of algebra, and numbers that are nearly 0.
#include <catch2/catch.hpp>

#include "libration/number/exact_real.hpp"
#include "libration/scalar/error.hpp"

namespace number_separation_bound_test {

using namespace libration;

namespace {

exact_real of(const rational& q) { return exact_real(q); }
exact_real root(const exact_real& x, int k) { return power(x, of(rational(1, k))); }
exact_real square_root(const rational& q) { return apply(function_kind::sqrt, of(q)); }

}  // namespace

TEST_CASE("identities of roots are exactly 0", "[scalar][expression]") {
    const exact_real two = square_root(2);
    CHECK((two * two - of(2)).sign() == 0);
    CHECK((of(1) / (two - of(1)) - two - of(1)).sign() == 0);
    CHECK((apply(function_kind::sqrt, of(3) + of(2) * two) - of(1) - two).sign() == 0);
    CHECK((power(apply(function_kind::cbrt, of(5)), of(3)) - of(5)).sign() == 0);
    CHECK((power(root(of(7), 5), of(-10)) - of(rational(1, 49))).sign() == 0);
    CHECK((square_root(2) * square_root(3) - square_root(6)).sign() == 0);
    // Ramanujan: cbrt(cbrt 2 - 1) = cbrt(1/9) - cbrt(2/9) + cbrt(4/9).
    const auto cube_root = [](const exact_real& x) { return apply(function_kind::cbrt, x); };
    CHECK((cube_root(cube_root(of(2)) - of(1)) - cube_root(of(rational(1, 9))) + cube_root(of(rational(2, 9))) -
           cube_root(of(rational(4, 9))))
              .sign() == 0);
    for (int a = 2; a < 30; a += 3) {
        for (int b = a + 1; b < 30; b += 7) {
            const exact_real sum = square_root(a) + square_root(b);
            const exact_real zero = sum * sum - of(a + b) - of(2) * square_root(a * b);
            INFO(a << " " << b);
            CHECK(zero.sign() == 0);
            // The next number of a denominator of 400 bits is none.
            CHECK((zero + of(rational(1) / rational(pow(integer(2), 400)))).sign() == 1);
        }
    }
}

// p - q sqrt 2 with p^2 - 2 q^2 = 1 and -1 in turn, of the size of 1/(2 p).
TEST_CASE("numbers that are nearly 0 keep their signs", "[scalar][expression]") {
    integer p = 1;
    integer q = 1;
    for (int k = 0; k < 200; ++k) {
        const exact_real near = of(rational(p)) - of(rational(q)) * square_root(2);
        INFO(k);
        CHECK(near.sign() == (k % 2 == 0 ? -1 : 1));
        const auto exponent = near.separation_exponent();
        REQUIRE(exponent);
        CHECK(*exponent >= static_cast<long>(msb(p)));  // 1/(p + q sqrt 2) < 1/(2 p)
        const integer sum = p + q;
        p += 2 * q;
        q = sum;
    }
    const exact_real small = power(square_root(2) - of(1), of(40));
    CHECK((small * (square_root(2) + of(1)) - power(square_root(2) - of(1), of(39))).sign() == 0);
    CHECK((small - power(square_root(2) - of(1), of(41))).sign() == 1);
    CHECK((square_root(2) + square_root(5) - square_root(3) - square_root(rational(370, 100))).sign() != 0);
}

TEST_CASE("other numbers have no such bound", "[scalar][expression]") {
    CHECK_FALSE(exact_real(1, unit::pi).separation_exponent());
    CHECK_FALSE(apply(function_kind::exp, of(1)).separation_exponent());
    CHECK_FALSE((square_root(2) + apply(function_kind::sin, of(1))).separation_exponent());
}

}  // namespace number_separation_bound_test
