#include "libration/scalar/decimal.hpp"

#include <catch2/catch.hpp>

#include "scalar/random_value.hpp"
#include "scalars.hpp"

namespace scalar_decimal_test {

using namespace libration;
using libration::tests::all_scalars;

TEMPLATE_LIST_TEST_CASE("a printed value reads back as itself", "[scalar][decimal]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_value<T> random;
    // Reading costs a greatest common divisor with a power of ten as long as the exponent.
    for (int i = 0; i < 100; ++i) {
        const T x = random();
        INFO(to_round_trip(x));
        CHECK(from_exact<T>(read_exact(to_round_trip(x))) == x);
    }
}

TEMPLATE_LIST_TEST_CASE("a value that ends prints its digits in every scalar", "[scalar][decimal]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK(to_decimal(T(0), 5) == "0");
    CHECK(to_decimal(T(-T(0)), 5) == "0");
    CHECK(to_decimal(T(1) / 2, 3) == "0.500");
    CHECK(to_decimal(T(-1) / 8, 3) == "-0.125");
    CHECK(to_decimal(T(3), 1) == "3");
    CHECK(to_decimal(T(123), 3) == "123");
    CHECK(to_decimal(T(123), 5) == "123.00");
    CHECK(to_decimal(T(123), 2) == "1.2e2");
    CHECK(to_decimal(T(-5'000'000), 1) == "-5e6");
    CHECK(to_decimal(T(999), 2) == "1.0e3");
    CHECK(to_decimal(T(1) / 1024, 4) == "0.0009766");
    CHECK(to_decimal(T(1) / 65536, 4) == "0.00001526");
    CHECK(to_decimal(T(1) / 131072, 4) == "7.629e-6");
    CHECK(to_decimal(T(5) / 2, 1) == "2");  // a tie goes to even, as mpfr rounds
    CHECK_THROWS_AS(to_decimal(T(1), 0), libration::error);
    CHECK_THROWS_WITH(to_decimal(T(1), -3), Catch::Contains("-3"));
}

TEMPLATE_LIST_TEST_CASE("what is not finite prints as a word", "[scalar][decimal]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T infinity = narrow<T>(mpfr(std::numeric_limits<double>::infinity()));
    CHECK(to_decimal(infinity, 3) == "inf");
    CHECK(to_decimal(T(-infinity), 3) == "-inf");
    CHECK(to_decimal(T(infinity - infinity), 3) == "nan");
}

TEST_CASE("digits beyond a type's precision are those of the binary value", "[scalar][decimal]") {
    // The double next to 1/10 is 3602879701896397 / 2^55, which ends after 55 places [IEEE 754].
    CHECK(to_decimal(1.0 / 10, 55) == "0.1000000000000000055511151231257827021181583404541015625");
}

TEST_CASE("the point has its place", "[scalar][decimal]") {
    CHECK(place_point(false, "12345", 5) == "12345");
    CHECK(place_point(false, "12345", 6) == "1.2345e5");
    CHECK(place_point(false, "12345", 1) == "1.2345");
    CHECK(place_point(true, "12345", 0) == "-0.12345");
    CHECK(place_point(false, "12345", -4) == "0.000012345");
    CHECK(place_point(false, "12345", -5) == "1.2345e-6");
    CHECK(place_point(true, "7", 31) == "-7e30");
}

TEST_CASE("a fraction whose decimals end is printed in full", "[scalar][decimal]") {
    const auto printed = [](const std::string& text) { return to_finite_decimal(read_exact(text).coefficient); };
    CHECK(printed("171/100") == "1.71");
    CHECK(printed("-5/2") == "-2.5");
    CHECK(printed("1/8") == "0.125");
    CHECK(printed("1/1024") == "0.0009765625");
    CHECK(printed("0") == "0");
    CHECK(printed("1200") == "1200");
    CHECK(printed("1e20") == "100000000000000000000");
    CHECK(printed("1e21") == "1e21");
    CHECK(printed("1e-30") == "1e-30");
    CHECK(printed("1e-4") == "0.0001");
    CHECK(printed("1/3") == std::nullopt);
    CHECK(printed("1/7e5") == std::nullopt);
    CHECK(to_finite_decimal(rational(1) / 1024, 7) == "0.0009765625");  // 7 significant digits
    CHECK(to_finite_decimal(rational(1) / 1024, 6) == std::nullopt);
}

TEST_CASE("printing in full and reading are inverse on fractions that end", "[scalar][decimal]") {
    std::mt19937 bits(7);
    for (int i = 0; i < 200; ++i) {
        const auto numerator = static_cast<int>(bits() % 2'000'000) - 1'000'000;
        const auto twos = boost::multiprecision::pow(integer(2), static_cast<unsigned>(bits() % 30));
        const auto fives = boost::multiprecision::pow(integer(5), static_cast<unsigned>(bits() % 30));
        const rational value =
            bits() % 2 == 0 ? rational(numerator) * fives / twos : rational(numerator) * twos / fives;
        const auto text = to_finite_decimal(value);
        REQUIRE(text.has_value());
        CHECK(read_exact(*text).coefficient == value);
    }
}

TEST_CASE("the logarithm of a number of any size is text that a drawing can hold", "[scalar][decimal]") {
    const precision_scope scope(60);
    CHECK(log10_text(from_exact<mpfr>(read_exact("1e-400"))) == "-400.000000000");
    CHECK(log10_text(from_exact<mpfr>(read_exact("-2e4000"))) == "4000.30103000");  // log10 2 = 0.30103000 to 8 places
    CHECK(log10_text(mpfr(1)) == "0");
    CHECK(log10_text(mpfr(0)) == "-inf");
    CHECK(log10_text(100.0) == "2.00000000000");
}

TEST_CASE("a complex number has one sign between its parts", "[scalar][decimal]") {
    CHECK(complex_text("1.5", "0") == "1.5");
    CHECK(complex_text("1.5", "2") == "1.5 + 2i");
    CHECK(complex_text("0", "-2e-9") == "0 - 2e-9i");
    CHECK(complex_text("-1.570796327", "-1.000000000", " i") == "-1.570796327 - 1.000000000 i");
}

}  // namespace scalar_decimal_test
