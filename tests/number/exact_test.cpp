#include "libration/number/exact.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/scalar/error.hpp"
#include "scalars.hpp"

namespace number_exact_test {

using namespace libration;
using Catch::Contains;
using libration::tests::all_scalars;

namespace {

rational fraction(long numerator, long denominator = 1) { return rational(numerator) / denominator; }

}  // namespace

TEST_CASE("a typed number means exactly what was typed", "[scalar][exact]") {
    const auto means = [](const std::string& text, const rational& coefficient, unit measure) {
        const exact number = read_exact(text);
        INFO(text);
        CHECK(number.coefficient == coefficient);
        CHECK(number.measure == measure);
        CHECK(number.text == text);
    };
    SECTION("decimals and fractions") {
        means("1.71", fraction(171, 100), unit::one);
        means("171/100", fraction(171, 100), unit::one);
        means("1.5/2.5", fraction(3, 5), unit::one);
        means("-0.125", fraction(-1, 8), unit::one);
        means("+3", fraction(3), unit::one);
        means(".5", fraction(1, 2), unit::one);
        means("5.", fraction(5), unit::one);
        means("007", fraction(7), unit::one);
        means("-0", fraction(0), unit::one);
    }
    SECTION("exponents, which leave the range of every fixed scalar") {
        means("25e2", fraction(2500), unit::one);
        means("2.5E+2", fraction(250), unit::one);
        means("1e3/1e-2", fraction(100'000), unit::one);
        const integer thirty_zeros("1000000000000000000000000000000");
        means("1e-30", rational(1) / thirty_zeros, unit::one);
        means("1e30", rational(thirty_zeros), unit::one);
        CHECK(read_exact("1e-100000").coefficient * read_exact("1e100000").coefficient == 1);
        CHECK(read_exact("0e100000").is_zero());
    }
    SECTION("angles") {
        means("pi", fraction(1), unit::pi);
        means("3pi/4", fraction(3, 4), unit::pi);
        means("-pi/2", fraction(-1, 2), unit::pi);
        means("0.5pi", fraction(1, 2), unit::pi);
        means("150deg", fraction(150), unit::degree);
        means("-22.5deg", fraction(-45, 2), unit::degree);
        CHECK(read_exact("150deg").in_pi() == fraction(5, 6));
        CHECK(read_exact("5pi/6").in_pi() == fraction(5, 6));
    }
    SECTION("times in periods") {
        means("T/4", fraction(1, 4), unit::period);
        means("-3T/4", fraction(-3, 4), unit::period);
        means("2T", fraction(2), unit::period);
        means("T", fraction(1), unit::period);
    }
}

TEST_CASE("what is not a number is refused with what is wrong", "[scalar][exact]") {
    for (const auto* text :
         {"abc", "nan", "inf",  "-inf", "1..2", "1e",  "1e+",  "--1", "+-1", "1 2",  " 1",  "1 ",    ".", "-",
          "/2",  "1/",  "1/-2", "deg",  "3 pi", "3Pi", "pipi", "pi2", "e5",  "0x10", "1,5", "1e1.5", "2t"}) {
        INFO(text);
        CHECK_THROWS_WITH(read_exact(text), "number '" + std::string(text) + "' is not a number");
    }
    CHECK_THROWS_WITH(read_exact(""), "number is empty");
    CHECK_THROWS_WITH(read_exact("1/2pi"), Contains("is ambiguous"));
    for (const auto* text : {"1/0", "pi/0", "T/0.0", "0/0e5"}) {
        INFO(text);
        CHECK_THROWS_WITH(read_exact(text), Contains("divides by zero"));
    }
    for (const auto* text :
         {"1e999999999999", "1e-999999999999", "1e99999999999999999999999", "1e100001", "1e-100001", "2/1e200001"}) {
        INFO(text);
        CHECK_THROWS_WITH(read_exact(text), Contains("beyond the range"));
    }
    CHECK_THROWS_WITH(read_exact(std::string(200'001, '1')), Contains("beyond the range"));
    CHECK_THROWS_AS(read_exact("abc"), libration::error);
}

TEMPLATE_LIST_TEST_CASE("an exact number is rounded once when it meets a precision", "[scalar][exact]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // Twice the error is within one unit in the last place, epsilon times the power of two below the value; the
    // additional 2^-64 permitted to from_exact would be visible once in as many cases.
    const auto rounded_to = [](const std::string& text, const tests::expected_value& expected) {
        INFO(text);
        const T value = from_exact<T>(read_exact(text));
        const T doubled_error = narrow<T>(mpfr((widen(value) - expected.value) * 2));
        const mpfr power_below = ldexp(mpfr(1), static_cast<int>(binary_exponent(value)) - 1);
        CHECK_THAT(doubled_error, tests::near<T>(tests::expected_value{mpfr(0), expected.uncertainty}, 1, power_below));
    };
    const auto rounded_once = [&](const std::string& text, const std::string& value) {
        rounded_to(text, tests::decimal(value));
    };
    const std::string threes(120, '3');
    const std::string sixes(120, '6');
    rounded_once("1.71", "1.71" + std::string(120, '0'));
    rounded_once("-1/3", "-0." + threes);
    rounded_once("2e-30/3", "0." + sixes + "e-30");
    rounded_once("1e30", "1" + std::string(120, '0') + "e-90");
    // OEIS A000796.
    const std::string pi_text =
        "3."
        "1415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679821480865"
        "1";
    rounded_once("pi", pi_text);
    rounded_once("180deg", pi_text);
    rounded_once("-1e-20pi", "-" + pi_text + "e-20");
    rounded_once("1.8e22deg", pi_text + "e20");
    for (int divisor = 3; divisor < 30; ++divisor) {
        tests::expected_value part = tests::decimal(pi_text);
        {
            const precision_scope scope(200);
            part.value /= divisor;
        }
        rounded_to("pi/" + std::to_string(divisor), part);
    }
}

TEMPLATE_LIST_TEST_CASE("small dyadic numbers are exact in every scalar", "[scalar][exact]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK(from_exact<T>(read_exact("-1.375")) == T(-11) / 8);
    CHECK(from_exact<T>(read_exact("0")) == 0);
    CHECK(from_exact<T>(read_exact("0pi")) == 0);
    CHECK(from_exact<T>(exactly(fraction(3, 4))) == T(3) / 4);
    CHECK(exactly(fraction(3, 4)).text == "3/4");
}

TEST_CASE("a multiple of the period is no number without a motion", "[scalar][exact]") {
    CHECK_THROWS_AS(from_exact<double>(read_exact("T/4")), libration::error);
    CHECK_THROWS_WITH(from_exact<mpfr>(read_exact("-3T/4")), Contains("-3T/4"));
}

}  // namespace number_exact_test
