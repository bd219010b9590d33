#include "libration/scalar/convert.hpp"

#include <catch2/catch.hpp>

#include "scalar/random_value.hpp"
#include "scalars.hpp"

namespace scalar_convert_test {

using namespace libration;
using libration::tests::all_scalars;

namespace {

// More bits than any value here needs, so that sums of these are exact.
constexpr long plenty = 1000;

mpfr power_of_two(long exponent) { return ldexp(mpfr(1), static_cast<int>(exponent)); }

// |x - q| <= (1/2 + 2^-63) ulp(x), with the ulp of subnormals in fixed scalars.
template <class T>
bool within_half_unit(const T& x, const rational& q) {
    const long exponent_of_ulp = std::max(binary_exponent(x) - digits<T>(), tests::exponent_range<T>().least - 1);
    const precision_scope scope(plenty);
    const mpfr error = abs(widen(x) - from_rational<mpfr>(q));
    return error <= power_of_two(exponent_of_ulp) * (mpfr(1) / 2 + power_of_two(-63));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("every value comes back from its wide form", "[scalar][convert]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_value<T> random;
    for (int i = 0; i < 500; ++i) {
        const T x = random();
        CHECK(narrow<T>(widen(x)) == x);
    }
    CHECK(narrow<T>(widen(T(0))) == 0);
}

TEMPLATE_LIST_TEST_CASE("the wide form is the value itself", "[scalar][convert]", all_scalars) {
    using T = typename TestType::type;
    using std::ldexp;
    const typename TestType::precision precision;
    const int bits = digits<T>();
    const T all_bits = (ldexp(T(1), bits - 1) - 1) * 2 + 1;  // 2^bits - 1: every bit of the significand
    const auto range = tests::exponent_range<T>();
    const T largest = ldexp(all_bits, static_cast<int>(range.largest - bits));
    const T tiniest = ldexp(T(1), static_cast<int>(range.least - 1));
    const precision_scope scope(plenty);
    CHECK(widen(all_bits) == power_of_two(bits) - 1);
    CHECK(widen(T(-all_bits)) == 1 - power_of_two(bits));
    CHECK(widen(largest) == (power_of_two(bits) - 1) * power_of_two(range.largest - bits));
    CHECK(widen(tiniest) == power_of_two(range.least - 1));
    CHECK(narrow<double>(widen(T(1) / 4)) == 1.0 / 4);
}

TEMPLATE_LIST_TEST_CASE("a widened value computes in the precision in force", "[scalar][convert]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T one(1);
    const precision_scope scope(plenty);
    // widen() returns a temporary, in whose precision Boost computes.
    CHECK(widen(one) / 3 == mpfr(1) / 3);
    CHECK(widen(one) - pi<mpfr>() == 1 - pi<mpfr>());
}

TEMPLATE_LIST_TEST_CASE("narrowing goes to the nearest, ties to even", "[scalar][convert]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const int bits = digits<T>();
    const T one(1);
    const T above = 1 + epsilon<T>();
    const auto narrowed = [&](const mpfr& x) { return narrow<T>(x); };
    mpfr half_above, more, less, tie_to_even, negative;
    {
        const precision_scope scope(plenty);
        half_above = 1 + power_of_two(-bits);
        more = half_above + power_of_two(-4 * bits);
        less = half_above - power_of_two(-4 * bits);
        tie_to_even = half_above + power_of_two(1 - bits);
        negative = -more;
    }
    CHECK(narrowed(half_above) == one);
    CHECK(narrowed(more) == above);
    CHECK(narrowed(less) == one);
    CHECK(narrowed(tie_to_even) == above + epsilon<T>());
    CHECK(narrowed(negative) == -above);
}

TEMPLATE_LIST_TEST_CASE("a fraction is rounded to half a unit in the last place", "[scalar][convert]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const rational third = rational(1) / 3;
    const integer ten_300 = boost::multiprecision::pow(integer(10), 300);
    for (const rational& q : {third, rational(-third), rational(rational(2) / 7), rational(rational(171) / 100),
                              rational(third * ten_300), rational(third / ten_300), rational(-1) / ten_300}) {
        INFO(q);
        CHECK(within_half_unit(from_rational<T>(q), q));
    }
    CHECK(from_rational<T>(rational(0)) == 0);
    CHECK(from_rational<T>(rational(-3) / 8) == T(-3) / 8);
}

TEMPLATE_TEST_CASE("a fraction among the subnormal numbers is rounded to half their unit", "[scalar][convert]", double,
                   long double, quad) {
    using T = TestType;
    if (!tests::exponent_range<T>::has_subnormal) {
        return;  // Boost's quad in software
    }
    const long least = tests::exponent_range<T>().least;
    for (int size = 0; size < 70; size += 3) {
        const rational q = rational(integer(1) << size) / (rational(integer(3)) * (integer(1) << (1 - least)));
        INFO(size);
        CHECK(within_half_unit(from_rational<T>(q), q));
    }
}

TEMPLATE_LIST_TEST_CASE("infinities and nan survive", "[scalar][convert]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T infinity = narrow<T>(mpfr(std::numeric_limits<double>::infinity()));
    CHECK(mpfr_inf_p(handle(widen(infinity))) != 0);
    CHECK(mpfr_sgn(handle(widen(T(-infinity)))) < 0);
    const T nan = narrow<T>(mpfr(std::numeric_limits<double>::quiet_NaN()));
    CHECK(nan != nan);
    CHECK(mpfr_nan_p(handle(widen(nan))) != 0);
}

TEST_CASE("between scalars a value is rounded once", "[scalar][convert]") {
    const precision_scope scope(40);
    const auto third = from_rational<quad>(rational(1) / 3);
    CHECK(convert<double>(third) == 1.0 / 3);
    CHECK(convert<long double>(third) == 1.0L / 3);
    CHECK(convert<quad>(convert<mpfr>(third)) == third);
    CHECK(convert<quad>(1.0 / 3) != third);
    CHECK(convert<double>(convert<quad>(1.0 / 3)) == 1.0 / 3);
    CHECK(digits<mpfr>() == mpfr_get_prec(handle(convert<mpfr>(third))));
}

TEST_CASE("the nearest integer, ties to even, of numbers of any size", "[scalar][convert]") {
    const precision_scope scope(50);
    const auto nearest = [](const rational& q) { return nearest_integer(from_rational<mpfr>(q)); };
    const rational half = rational(1) / 2;
    CHECK(nearest(half) == 0);
    CHECK(nearest(rational(3 * half)) == 2);
    CHECK(nearest(rational(-5 * half)) == -2);
    CHECK(nearest(rational(-8) / 3) == -3);
    const integer huge("1234567890123456789012345678901234567890");
    CHECK(nearest(rational(huge) + rational(1) / 4) == huge);
}

}  // namespace scalar_convert_test
