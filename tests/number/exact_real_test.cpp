// Formulas of numbers compared with values computed without this library, their grammar, and rejected ones.
#include "libration/number/exact_real_text.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "corner_numbers.hpp"
#include "libration/number/exact.hpp"
#include "libration/number/number_lexer.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"
#include "reference_table.hpp"
#include "scalars.hpp"

namespace number_exact_real_test {

using namespace libration;
using Catch::Contains;
using Catch::Equals;

namespace {

constexpr long reference_digits = 60;

// The error message of a reader; "accepted" if there is none.
std::string refusal(const std::string& text, error_kind kind = error_kind::argument) {
    try {
        read_exact(text);
    } catch (const error& problem) {
        CHECK(problem.kind() == kind);
        CHECK(problem.value() == text);
        return problem.reason();
    }
    return "accepted";
}

void means(const std::string& text, const rational& coefficient, unit measure = unit::one) {
    INFO(text);
    const exact number = read_exact(text);
    CHECK(number.text == text);
    CHECK(number.measure == measure);
    CHECK(number.coefficient == coefficient);
    CHECK_FALSE(number.formula);
}

rational fraction(long numerator, long denominator = 1) { return rational(numerator) / denominator; }

}  // namespace

TEST_CASE("formulas have the values that other arithmetic gives", "[scalar][expression]") {
    for (const auto& row : tests::reference_table("expressions.csv")) {
        const std::string& text = row.at("expression");
        INFO(text);
        const exact number = read_exact(text);
        CHECK(number.measure == unit::expression);
        const rational expected = read_exact(row.at("value")).coefficient;
        const auto near = [&](const rational& value) {
            return abs(rational(value / expected - 1)) < rational(1) / boost::multiprecision::pow(integer(10), 59U);
        };
        for (const long digits : {reference_digits + 5, 4 * reference_digits}) {
            const precision_scope scope(digits);
            const auto value = from_exact<mpfr>(number);
            rational as_fraction;
            mpfr_get_q(as_fraction.backend().data(), handle(value));
            CHECK(near(as_fraction));
        }
        const number_bounds within = number.formula->narrowed(300);
        CHECK(within.lower < within.upper);
        CHECK(from_exact<double>(number) == from_rational<double>(expected));
    }
}

TEST_CASE("balls hold the value of a formula", "[scalar][expression]") {
    for (const auto& row : tests::reference_table("expressions.csv")) {
        INFO(row.at("expression"));
        const exact number = read_exact(row.at("expression"));
        for (const long digits : {10, 30, 55}) {
            const precision_scope scope(digits);
            const auto narrow_ball = from_exact<ball>(number);
            const precision_scope wide(reference_digits + 40);
            CHECK(overlaps(narrow_ball, from_exact<ball>(number)));
            CHECK(certainly_less(radius_of(narrow_ball), abs(ball(narrow_ball)) * pow(ball(10), -digits)));
        }
    }
}

TEST_CASE("what folds is a fraction of 1, pi, degrees or T", "[scalar][expression]") {
    means("2-1e-10", fraction(2) - fraction(1, 10'000'000'000));
    means("1+1/3", fraction(4, 3));
    means("3/4*pi", fraction(3, 4), unit::pi);
    means("pi/2+pi/4", fraction(3, 4), unit::pi);
    means("2*90deg", fraction(180), unit::degree);
    means("90deg+pi/2", fraction(1), unit::pi);
    means("T/4+T/2", fraction(3, 4), unit::period);
    means("(T+T)/4", fraction(1, 2), unit::period);
    means("pi - 1e-10 - pi", fraction(-1, 10'000'000'000));
    means("sqrt(2)-sqrt(2)", fraction(0));
    means("3*sqrt(2)/sqrt(2)", fraction(3));
    means("sqrt(9/16)", fraction(3, 4));
    means("8^(2/3)", fraction(4));
    means("(-8)^3", fraction(-512));
    means("(2/3)^-2", fraction(9, 4));
    means("2+sin(pi)", fraction(2));
    means("cos(60deg)", fraction(1, 2));
    means("sin(-7pi/6)", fraction(1, 2));
    means("tan(3pi/4)", fraction(-1));
    means("acos(1/2)", fraction(1, 3), unit::pi);
    means("asin(-1)", fraction(-1, 2), unit::pi);
    means("atan(1)", fraction(1, 4), unit::pi);
    means("exp(0)+log(1)+cosh(0)+sinh(0)+tanh(0)", fraction(2));
    means("pi/pi", fraction(1));
}

TEST_CASE("operators bind as in mathematics", "[scalar][expression]") {
    means("-3^2", fraction(-9));
    means("2^3^2", fraction(512));
    means("2**3**2", fraction(512));
    means("2^-1", fraction(1, 2));
    means("1-2-3", fraction(-4));
    means("1/2/4", fraction(1, 8));
    means("8/3*2", fraction(16, 3));
    means("2+3*4", fraction(14));
    means("(2+3)*4", fraction(20));
    means("-(1+2)", fraction(-3));
    means("(1 + 2) * 3", fraction(9));
    means("1e-5-1", fraction(-99'999, 100'000));
    means("1/2*3pi", fraction(3, 2), unit::pi);
    CHECK(same_form(read_expression("2pi^2"), read_expression("2*pi^2")));
    CHECK_FALSE(same_form(read_expression("2pi^2"), read_expression("(2pi)^2")));
}

TEST_CASE("a time is a multiple of T and a number", "[scalar][expression]") {
    const exact time = read_exact("T/4+1e-3");
    CHECK(time.measure == unit::expression);
    CHECK(time.periods() == fraction(1, 4));
    CHECK(time.without_periods().coefficient == fraction(1, 1000));
    CHECK(time.has_periods());
    CHECK_FALSE(time.only_periods());
    CHECK(read_exact("T+pi").without_periods().measure == unit::pi);
    CHECK_THROWS_AS(from_exact<mpfr>(time), libration::error);
    for (const auto* text : {"T*T", "sin(T)", "T^2", "1/T", "sqrt(2)*T", "(T+1)*pi", "2T^2", "0^T"}) {
        INFO(text);
        CHECK_THAT(refusal(text), Contains("T "));
    }
}

TEST_CASE("a wrong formula is refused with what is wrong and where", "[scalar][expression]") {
    CHECK_THAT(refusal("1+2*foo"), Equals("has an unknown name \"foo\" at column 5"));
    CHECK_THAT(refusal("2*(1+3"), Equals("does not end: a ) is missing"));
    CHECK_THAT(refusal("2*("), Equals("does not end: a number is missing"));
    CHECK_THAT(refusal("1+2)"), Equals("has an unmatched ) at column 4"));
    CHECK_THAT(refusal("(1,2)"), Equals("has an unexpected , at column 3"));
    CHECK_THAT(refusal("2*\x01"), Equals("has an unexpected character at column 3"));
    CHECK_THAT(refusal("sin*2"), Equals("has sin without a ( after it at column 1"));
    for (const std::string sign : {"+-", " +- ", "-+", "\u00b1", " \u2213"}) {
        CHECK_THAT(refusal("1" + sign + "0.1"), Contains("denotes an interval, which is not supported"));
    }
    CHECK_THAT(refusal("2*3x"), Contains("directly after a number"));
    CHECK_THAT(refusal("2sqrt(2)"), Contains("directly after a number"));
    CHECK_THAT(refusal("1/2pi"), Equals("is ambiguous at column 3: write parentheses, as 1/(2*pi) or (1/2)*pi"));
    CHECK_THAT(refusal("5"), Equals("accepted"));
    for (const auto* text :
         {"",       "(",     ")",      "()",      "2^",  "2**",   "*2",   "2*-3",   "1 2",   "2 pi",    "sqrt()",
          "sqrt 2", "pi(2)", "(2)(3)", "2.5.1*3", "deg", "3*deg", "Pi*2", "1/0x10", "0x1+1", "inf-inf", "1e400000"}) {
        INFO(text);
        CHECK(refusal(text) != "accepted");
    }
}

TEST_CASE("what has no value is refused", "[scalar][expression]") {
    CHECK_THAT(refusal("1/(1-1)"), Equals("divides by zero"));
    CHECK_THAT(refusal("1/sin(pi)"), Equals("divides by zero"));
    CHECK_THAT(refusal("0^-1"), Equals("divides by zero"));
    CHECK_THAT(refusal("0^0"), Contains("0^0"));
    CHECK_THAT(refusal("sqrt(-1)"), Equals("takes the root of a negative number"));
    CHECK_THAT(refusal("sqrt(1-sqrt(2))"), Equals("takes the root of a negative number"));
    CHECK_THAT(refusal("0*log(1-sqrt(2))"), Contains("not positive"));
    CHECK_THAT(refusal("log(0)"), Contains("not positive"));
    CHECK_THAT(refusal("acos(1+1e-300)"), Contains("beyond 1"));
    CHECK_THAT(refusal("asin(sqrt(2))"), Contains("beyond 1"));
    CHECK_THAT(refusal("tan(90deg)"), Contains("pole"));
    CHECK_THAT(refusal("(-2)^0.5"), Contains("non-integer"));
    CHECK_THAT(refusal("(1-sqrt(2))^sqrt(2)"), Contains("non-integer"));
    CHECK_THAT(refusal("9^9^9^9"), Contains("beyond the range"));
    CHECK_THAT(refusal("exp(1e100000)"), Contains("beyond the range"));
    CHECK_THAT(refusal("1e100000^1000"), Contains("beyond the range"));
    CHECK(refusal("acos(1-1e-300)") == "accepted");
}

TEST_CASE("what no precision decides is said so", "[scalar][expression]") {
    CHECK_THAT(refusal("1/(sin(1)^2+cos(1)^2-1)", error_kind::undecided), Contains("no precision"));
    CHECK_THAT(refusal("sqrt(sin(1)^2+cos(1)^2-1)", error_kind::undecided), Contains("no precision"));
    const exact hidden = read_exact("sin(1)^2+cos(1)^2-1");
    CHECK_FALSE(hidden.is_zero());
    try {
        sign_of_exact(hidden);
        FAIL("decided");
    } catch (const error& problem) {
        CHECK(problem.kind() == error_kind::undecided);
    }
    CHECK(sign_of_exact(read_exact("sin(1)^2+cos(1)^2-1+1e-3000")) == 1);
    CHECK(sign_of_exact(read_exact("1e-3000-sqrt(2)^2+2")) == 1);
    CHECK(sign_of_exact(read_exact("exp(pi)-pi-20")) == -1);
}

// Whether the bounds of a typed number contain the true value, in bits whose last place is decided by the true value.
bool within_bounds(const std::string& text, long bits, const ball& truth) {
    const exact number = read_exact(text);
    if (!number.formula) {
        return overlaps(from_exact<ball>(number), truth);
    }
    const number_bounds bounds = number.formula->narrowed(bits);
    return !certainly_less(truth, ball(bounds.lower)) && !certainly_less(ball(bounds.upper), truth);
}

TEST_CASE("quotients and powers of typed numbers enclose those of balls in corner cases", "[scalar][expression]") {
    tests::corner_numbers next(1024);
    for (int run = 0; run < 200; ++run) {
        const integer a = next.positive(next.length(500));
        const integer b = next.positive(next.length(500));
        const std::string eighths = std::to_string(next.between(1, 60)) + "/8";
        const std::string sevenths = std::to_string(next.between(1, 99)) + "/7";
        const long bits = next.length(600);
        const precision_scope wide(600);
        const ball x = from_rational<ball>(rational(a));
        const ball y = from_rational<ball>(rational(b));
        const auto power = [&](const std::string& exponent) {
            return exp(log(x) * from_exact<ball>(read_exact(exponent)));
        };
        INFO(a << " " << b << " " << eighths << " " << sevenths);
        CHECK(within_bounds("sqrt(" + a.str() + ")/(" + b.str() + "+pi)", bits, sqrt(x) / (y + pi<ball>())));
        CHECK(within_bounds("pi*" + a.str() + "^(" + eighths + ")", bits, pi<ball>() * power(eighths)));
        CHECK(within_bounds(a.str() + "^(" + sevenths + ")*" + b.str(), bits, y * power(sevenths)));
    }
}

TEST_CASE("no text is too long or too deep for the reader", "[scalar][expression]") {
    const auto repeated = [](const std::string& text, int count) {
        std::string all;
        for (int i = 0; i < count; ++i) {
            all += text;
        }
        return all;
    };
    CHECK_THAT(refusal(repeated("(", 5000)), Contains("nested"));
    CHECK_THAT(refusal(repeated("sqrt(", 1900)), Contains("nested"));
    CHECK_THAT(refusal("2" + repeated("^2", 4000)), Contains("nested"));
    CHECK_THAT(refusal("2" + repeated("*sqrt(2)", 1000)), Contains("nests more than 200"));
    CHECK_THAT(refusal("pi" + repeated("+1", 60'000)), Contains("longer"));
    CHECK(refusal("pi" + repeated("+1", 4000)) == "accepted");
    CHECK(refusal("1" + repeated("+sqrt(2)", 1000)) == "accepted");
    CHECK_THAT(refusal("1+" + repeated("x", 5000)), Contains("xxx...\""));
}

TEST_CASE("the lexer of numbers takes what is one and leaves the rest", "[scalar][expression]") {
    const auto taken = [](std::string_view text, radix base = radix::decimal) {
        std::string_view rest = text;
        const auto number = take_number(rest, base);
        return std::pair(number ? number->value() : rational(-1), std::string(rest));
    };
    CHECK(taken("1.50e2pi") == std::pair(fraction(150), std::string("pi")));
    CHECK(taken("2e") == std::pair(fraction(2), std::string("e")));
    CHECK(taken("2exp") == std::pair(fraction(2), std::string("exp")));
    CHECK(taken(".e1") == std::pair(fraction(-1), std::string(".e1")));
    CHECK(taken("1.8p-3", radix::hexadecimal) == std::pair(fraction(3, 16), std::string()));
    std::string_view rest = "1.250";
    CHECK(take_number(rest)->last_place() == fraction(1, 1000));
}

// W(x) = r where x = r exp(r), r >= -1.
TEST_CASE("lambertw of r exp(r) is r", "[scalar][expression]") {
    for (const std::string least : {"-exp(-1)", "-1/exp(1)", "-(1/exp(1))", "exp(-1) - 2*exp(-1)",
                                    "-exp(1/2)*exp(-3/2)", "-1/sqrt(exp(2))", "-exp(2)^(-1/2)", "-1/cbrt(exp(3))",
                                    "-(1 + expm1(-1))", "sinh(1) - cosh(1)", "-exp(1)^2/exp(3)", "(0-3)*exp(-1)/3"}) {
        means("lambertw(" + least + ")", -1);
    }
    means("lambertw(exp(1))", 1);
    means("lambertw(2*exp(2))", 2);
    means("lambertw(-exp(-1/2)/2)", rational(-1, 2));
    // Here r < -1, of another branch, or the argument is beside it.
    CHECK_FALSE(read_exact("lambertw(-2*exp(-2))").coefficient == -2);
    CHECK_THAT(refusal("lambertw(-exp(-1)*(1 + 1e-30))"), Contains("takes lambertw of a number below -1/e"));
    CHECK_THAT(refusal("lambertw(-0.36787944117145)"), Contains("takes lambertw of a number below -1/e"));
}

TEST_CASE("a hundred parentheses are read", "[scalar][expression]") {
    const std::string open(100, '(');
    const std::string close(100, ')');
    CHECK(read_exact(open + "3" + close).coefficient == 3);
    CHECK_THAT(refusal("(" + open + "3" + close + ")"), Contains("is nested more than 100 deep"));
}

}  // namespace number_exact_real_test
