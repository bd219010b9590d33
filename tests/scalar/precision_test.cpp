#include "libration/scalar/precision.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "scalars.hpp"

namespace scalar_precision_test {

using namespace libration;
using libration::tests::all_scalars;

TEST_CASE("scopes nest and restore, also when left by an exception", "[scalar][precision]") {
    const int before = digits<mpfr>();
    {
        const precision_scope outer(40);
        const int forty = digits<mpfr>();
        {
            const precision_scope inner(1000);
            CHECK(digits<mpfr>() > 24 * forty);
        }
        CHECK(digits<mpfr>() == forty);
        try {
            const precision_scope inner(200);
            throw std::runtime_error("leaves the scope");
        } catch (const std::runtime_error&) {
            CHECK(digits<mpfr>() == forty);
        }
    }
    CHECK(digits<mpfr>() == before);
}

TEST_CASE("a scope holds the digits it was asked for, and few bits more", "[scalar][precision]") {
    for (const long asked : {1, 2, 15, 16, 40, 50, 100, 999, 12345}) {
        const precision_scope scope(asked);
        const double needed = static_cast<double>(asked) * std::log2(10);
        INFO(asked);
        CHECK(digits<mpfr>() >= needed);
        // Boost uses 1000/301 bits per digit, 1.0000998 of log2(10), and 2 more.
        CHECK(digits<mpfr>() <= needed * 1.0001 + 3);
    }
}

TEST_CASE("a precision that cannot be is refused with its value", "[scalar][precision]") {
    const int before = digits<mpfr>();
    for (const long asked : {0L, -5L, 100'000'001L}) {
        CHECK_THROWS_AS(precision_scope(asked), libration::error);
        CHECK_THROWS_WITH(precision_scope(asked), Catch::Contains(std::to_string(asked)));
    }
    CHECK(digits<mpfr>() == before);
}

TEST_CASE("a thread starts from the global default and keeps its scopes to itself", "[scalar][precision]") {
    const auto in_a_thread = [](auto work) { std::thread(work).join(); };
    int global = 0;
    in_a_thread([&] { global = digits<mpfr>(); });
    const precision_scope scope(300);
    const int here = digits<mpfr>();
    int at_start = 0;
    int in_scope = 0;
    in_a_thread([&] {
        at_start = digits<mpfr>();
        const precision_scope own(40);
        in_scope = digits<mpfr>();
        mpfr_free_cache();
    });
    CHECK(at_start == global);  // and not 300: every worker opens a separate scope
    CHECK(at_start < here);
    CHECK(in_scope < here);
    CHECK(digits<mpfr>() == here);
}

TEST_CASE("decimal digits hold their bits and are hardly more than needed", "[scalar][precision]") {
    STATIC_REQUIRE(decimal_digits(53) == 16);
    STATIC_REQUIRE(decimal_digits(64) == 20);
    STATIC_REQUIRE(decimal_digits(113) == 35);
    STATIC_REQUIRE(decimal_digits(0) == 1);
    for (long bits = 1; bits < 20'000; ++bits) {
        const double needed = static_cast<double>(bits) * std::log10(2);
        const auto held = static_cast<double>(decimal_digits(bits));
        REQUIRE(held >= needed);
        REQUIRE(held < needed + 1 + static_cast<double>(bits) / 1e8);  // log10(2) is taken as 0.30103, 4e-9 too large
    }
}

TEMPLATE_LIST_TEST_CASE("epsilon is the unit in the last place of 1", "[scalar][precision]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T one(1);
    CHECK(one + epsilon<T>() > one);
    CHECK(one + epsilon<T>() / 2 == one);  // the tie goes to the even neighbour
    CHECK(one - epsilon<T>() / 2 < one);   // below 1 the unit is half as large
    CHECK((one + epsilon<T>()) - one == epsilon<T>());
}

TEMPLATE_LIST_TEST_CASE("what was made with fewer digits refuses to be used with more", "[scalar][precision]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const born_precision<T> born;
    CHECK_NOTHROW(born.require());
    {
        const precision_scope fewer(20);
        CHECK_NOTHROW(born.require());
    }
    const precision_scope more(200);
    if (std::is_same_v<T, mpfr>) {
        CHECK_THROWS_AS(born.require(), std::logic_error);
    } else {
        CHECK_NOTHROW(born.require());
    }
}

TEMPLATE_TEST_CASE("a fixed scalar holds the exponents of its normal numbers", "[scalar][precision]", double,
                   long double, quad) {
    using T = TestType;
    using std::ldexp;
    constexpr int least = std::numeric_limits<T>::min_exponent;
    constexpr int largest = std::numeric_limits<T>::max_exponent;
    CHECK(holds_exponent<T>(least));
    CHECK_FALSE(holds_exponent<T>(least - 1));
    CHECK(holds_exponent<T>(largest));
    CHECK_FALSE(holds_exponent<T>(largest + 1));
    // 2^(e-1) <= |x|: the least has all of its bits, the next exponent up is infinite.
    const T tiny = ldexp(1 + epsilon<T>(), least - 1);
    CHECK(ldexp(tiny, 1 - least) == 1 + epsilon<T>());
    CHECK(ldexp(T(1), largest) > ldexp(1 - epsilon<T>(), largest));
    CHECK(ldexp(T(1), largest) == ldexp(T(2), largest));
}

TEST_CASE("the exponents of mpfr do not end, and its digits are told", "[scalar][precision]") {
    CHECK(holds_exponent<mpfr>(-100'000'000));
    CHECK(holds_exponent<mpfr>(100'000'000));
    const precision_scope scope(77);
    CHECK(working_digits() == 77);
}

TEST_CASE("fixed scalars have the bits of their formats", "[scalar][precision]") {
    CHECK(digits<double>() == 53);
    CHECK(digits<long double>() == std::numeric_limits<long double>::digits);
    CHECK(digits<quad>() == 113);
    CHECK(epsilon<double>() == std::numeric_limits<double>::epsilon());
}

}  // namespace scalar_precision_test
