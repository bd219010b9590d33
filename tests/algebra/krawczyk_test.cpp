// Krawczyk's test compared with closed forms, and for maps with no zero or two near each other.
#include "libration/algebra/krawczyk.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace algebra_krawczyk_test {

using namespace libration;
using namespace libration::ode;

namespace {

bool within_a_unit(const proved_decimal& printed, const ball& number, long digits) {
    const precision_scope scope(digits + 30);
    mpfr value;
    mpfr_set_str(handle(value), printed.text.c_str(), 10, MPFR_RNDN);
    return certainly_less(abs(ball(value) - number), abs(number) * pow(ball(10), 1 - digits));
}

// x^2 = c by balls.
map_of_unknowns square_is(int c) {
    return [c](const std::vector<ball>& x, long, long) {
        return std::optional(enclosed_map{{x[0] * x[0] - c}, {{x[0] * 2}}});
    };
}

}  // namespace

TEST_CASE("a square root is proved, and none of a negative number", "[ode][proved]") {
    const auto root = proved_root(square_is(2), {ball(3) / 2}, 200);
    const precision_scope scope(240);
    CHECK(within_a_unit(root[0], sqrt(ball(2)), 200));
    CHECK_THROWS_AS(proved_root(square_is(-2), {ball(3) / 2}, 20), error);
    CHECK_THROWS_AS(proved_root(square_is(0), {ball(3) / 2}, 20), error);  // a double zero
}

// A derivative that may vanish in every box proves nothing, however well Newton's method converges.
TEST_CASE("no root is proved where the derivative over its box is not known", "[ode][proved]") {
    const map_of_unknowns open = [](const std::vector<ball>& x, long, long) {
        const ball slope = is_exact(x[0]) ? x[0] * 2 : widened(ball(0), magnitude(10U));
        return std::optional(enclosed_map{{x[0] * x[0] - 2}, {{slope}}});
    };
    CHECK_THROWS_AS(proved_root(open, {ball(3) / 2}, 20), error);
}

// x^2 = 2 with values over boxes narrower than 2^-bits alone: those of 160 bits are wider than 2^-200.
TEST_CASE("a root is proved as soon as the conditions have values over its box", "[ode][proved]") {
    const auto narrower_than = [](long bits) {
        return [bits](const std::vector<ball>& x, long, long) {
            const bool has_values = magnitude::radius_of(x[0]) < magnitude::of(1, -bits);
            return has_values ? std::optional(enclosed_map{{x[0] * x[0] - 2}, {{x[0] * 2}}}) : std::nullopt;
        };
    };
    const auto root = proved_root(narrower_than(200), {ball(3) / 2}, 20);
    CHECK(root[0].text == "1.4142135623730950488");
    CHECK_THROWS_WITH(proved_root(narrower_than(1'000'000), {ball(3) / 2}, 20),
                      Catch::Contains("is not proved at any precision"));
}

// x = 0 within 2^(-bits/8): proved in wide boxes first.
TEST_CASE("a root that is not distinguished from 0 has a bound below its digits", "[ode][proved]") {
    const map_of_unknowns wide = [](const std::vector<ball>& x, long bits, long) {
        return std::optional(enclosed_map{{widened(x[0], magnitude::of(1, -bits / 8))}, {{ball(1)}}});
    };
    const auto root = proved_part_of_root(wide, {ball(0)}, 20);
    CHECK_FALSE(root[0].decimal);
    const precision_scope scope(40);
    CHECK(mpfr(root[0].bound) < mpfr("1e-20"));
}

TEST_CASE("conditions without a finite value are named in the message", "[ode][proved]") {
    const map_of_unknowns infinite = [](const std::vector<ball>& x, long, long) {
        return std::optional(enclosed_map{{ball(1) / (x[0] - x[0])}, {{ball(1)}}});
    };
    CHECK_THROWS_WITH(proved_root(infinite, {ball(1)}, 20), Catch::Contains("with residual not finite"));
}

// x + y = 1 and 2 x + 2 y = 3.
TEST_CASE("conditions that contradict each other are named with the last iterate", "[ode][proved]") {
    const map_of_unknowns parallel = [](const std::vector<ball>& x, long, long) {
        const ball sum = x[0] + x[1];
        return std::optional(enclosed_map{{sum - 1, sum * 2 - 3}, {{ball(1), ball(1)}, {ball(2), ball(2)}}});
    };
    const std::vector<ball> guess{ball(1), ball(2)};
    const std::string rest = ", with residual 2.00, 3.00: try a better initial guess";
    CHECK_THROWS_WITH(proved_root(parallel, guess, 20),
                      Catch::Contains("the derivative of the conditions is singular; the last iterate is "
                                      "x1 = 1.000000000, x2 = 2.000000000" +
                                      rest));
    CHECK_THROWS_WITH(proved_root(parallel, guess, 20, {"a", "b"}),
                      Catch::Contains("the last iterate is a = 1.000000000, b = 2.000000000" + rest));
}

}  // namespace algebra_krawczyk_test
