#include "libration/pendulum/decision.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"

namespace pendulum_decision_test {

using namespace libration;
using namespace libration::pendulum;
using libration::tests::fraction;

namespace {

winding wound(const std::string& angle) { return wind(read_exact(angle)); }

}  // namespace

TEST_CASE("the cosine is rational exactly at multiples of 60 and 90 degrees", "[decision]") {
    const precision_scope precision(60);
    for (int below = 1; below <= 12; ++below) {
        for (int above = -40; above <= 40; ++above) {
            const exact angle{rational(above, below), unit::pi, ""};
            INFO(above << " pi / " << below);
            // Niven: cos(q pi) is rational only if 2 cos(q pi) is an integer.
            const mpfr twice = cos(pi<mpfr>() * above / below) * 2;
            const mpfr off = abs(twice - round(twice));
            const auto cosine = rational_cosine(angle);
            REQUIRE(cosine.has_value() == (off < mpfr("1e-50")));
            if (cosine) {
                CHECK(abs(from_rational<mpfr>(*cosine) - twice / 2) < mpfr("1e-50"));
            }
        }
    }
}

TEST_CASE("degrees, zero and huge multiples have their rational cosine, numbers have none", "[decision]") {
    CHECK(rational_cosine(read_exact("0")) == rational(1));
    CHECK(rational_cosine(read_exact("0deg")) == rational(1));
    CHECK(rational_cosine(read_exact("120deg")) == rational(-1, 2));
    CHECK(rational_cosine(read_exact("-240deg")) == rational(-1, 2));
    CHECK(rational_cosine(read_exact("90deg")) == rational(0));
    CHECK(rational_cosine(read_exact("1e30pi")) == rational(1));
    CHECK(rational_cosine(read_exact("1000000000000000000000001pi")) == rational(-1));
    CHECK_FALSE(rational_cosine(read_exact("45deg")));
    CHECK_FALSE(rational_cosine(read_exact("60.000000000000000000001deg")));
    CHECK_FALSE(rational_cosine(read_exact("3.14")));
    CHECK_FALSE(rational_cosine(read_exact("1")));
}

TEST_CASE("the nearest integer of a fraction is within one half, and even at a tie", "[decision]") {
    for (int below = 1; below <= 8; ++below) {
        for (int above = -40; above <= 40; ++above) {
            const rational q(above, below);
            const integer nearest = nearest_integer(q);
            const rational distance = abs(rational(q - rational(nearest)));
            INFO(q);
            CHECK(distance <= rational(1, 2));
            CHECK((distance < rational(1, 2) || nearest % 2 == 0));
        }
    }
}

TEST_CASE("a sum with a cosine is zero only where it is exactly zero", "[decision]") {
    CHECK(sign_of_sum_with_cosine(rational(1, 2), read_exact("120deg"), "").sign == 0);
    CHECK(sign_of_sum_with_cosine(rational(rational(1, 2) + fraction("1e-300")), read_exact("120deg"), "").sign == 1);
    CHECK(sign_of_sum_with_cosine(rational(rational(1, 2) - fraction("1e-300")), read_exact("120deg"), "").sign == -1);
}

TEST_CASE("the sign and the size of a difference of forty equal digits are proved", "[decision]") {
    // cos 1 = 0.54030230586813971740093660744297660373231042... [any table]
    const auto above =
        sign_of_sum_with_cosine(rational(-fraction("0.5403023058681397174009366074429766037323")), read_exact("1"), "");
    CHECK(above.sign == 1);  // 1.042e-41 = 2^-136.1
    CHECK(above.exponent == -136);
    const auto below =
        sign_of_sum_with_cosine(rational(-fraction("0.5403023058681397174009366074429766037324")), read_exact("1"), "");
    CHECK(below.sign == -1);  // -8.958e-41 = -2^-133.0
    CHECK((below.exponent == -132 || below.exponent == -133));
}

TEST_CASE("what is zero is never decided by precision", "[decision]") {
    const auto nothing = [] { return bounded_value{mpfr(0), epsilon<mpfr>()}; };
    CHECK_THROWS_AS(decide_sign(nothing, "nothing"), libration::error);
}

TEST_CASE("a sign is believed when the value exceeds its error, not before", "[decision]") {
    // While the precision is low, a rounding error hides the true value -1e-100 behind a positive one.
    const auto truth_behind_rounding = [] {
        const mpfr rounding = epsilon<mpfr>() * 1000;
        return bounded_value{mpfr("-1e-100") + rounding, rounding};
    };
    CHECK(decide_sign(truth_behind_rounding, "it").sign == -1);
    CHECK(decide_sign(truth_behind_rounding, "it").exponent == -332);  // 1e-100 = 2^-332.2
}

TEST_CASE("angles are taken apart into turns and a rest", "[decision]") {
    const precision_scope precision(120);
    for (const std::string text : {"9.0", "100", "-50", "1e30", "-1e30", "3", "-3", "6.3", "1e-30", "123456789.125"}) {
        INFO(text);
        const winding w = wound(text);
        const mpfr rest = from_exact<mpfr>(read_exact(text)) - from_rational<mpfr>(rational(w.turns * 2)) * pi<mpfr>();
        CHECK(abs(rest) < pi<mpfr>());
        CHECK(w.rest.sign == mpfr_sgn(handle(rest)));
        CHECK(w.rest.exponent == binary_exponent(rest));
    }
    CHECK(wound("9.0").turns == 1);
    CHECK(wound("100").turns == 16);
    CHECK(wound("-50").turns == -8);
}

TEST_CASE("odd multiples of pi have half a turn left over, even ones nothing", "[decision]") {
    for (int multiple = -9; multiple <= 9; ++multiple) {
        const winding w = wind(exact{rational(multiple), unit::pi, ""});
        const integer rest = multiple - w.turns * 2;
        INFO(multiple << " pi");
        CHECK(rest == integer(multiple % 2 == 0 ? 0 : w.rest.sign));
        CHECK((w.rest.sign == 0) == (multiple % 2 == 0));
    }
    CHECK(wound("540deg").turns == wound("3pi").turns);
    CHECK(wound("1e30pi").turns == integer(rational(fraction("5e29"))));
}

TEST_CASE("forty digits of pi are told from pi", "[decision]") {
    // pi = 3.141592653589793238462643383279502884197169...
    const winding below = wound("3.141592653589793238462643383279502884197");
    CHECK(below.turns == 0);
    CHECK(below.rest.sign == 1);
    const winding above = wound("3.141592653589793238462643383279502884198");
    CHECK(above.turns == 1);
    CHECK(above.rest.sign == -1);
}

}  // namespace pendulum_decision_test
