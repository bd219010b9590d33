// The lines of ratios and the radii that laws prove, against closed forms.
#include "libration/asymptotics/ratio_line.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace asymptotics_ratio_line_test {

using namespace libration;
using namespace libration::ode;

namespace {

coefficient_law law_of_text(const std::string& text, const law_request& asked = {}) {
    return coefficient_law::of(explicit_system(parse(text)), asked);
}

// The limit, and the exponent times 6, which is a whole number here.
void check_line(const std::string& text, const rational& limit, int exponent_times_six, const law_request& asked = {}) {
    INFO(text);
    const precision_scope scope(40);
    const auto line = line_of_ratios(law_of_text(text, asked));
    REQUIRE(line);
    CHECK(overlaps(line->limit, from_rational<ball>(limit)));
    CHECK(certainly_less(radius_of(line->limit), ball(pow(ball(10), -15L))));
    CHECK(overlaps(ball(line->exponent * 6), ball(exponent_times_six)));
    CHECK(certainly_less(radius_of(line->exponent), ball(pow(ball(10), -15L))));
}

}  // namespace

TEST_CASE("the line has the limit and the exponent of closed forms", "[asymptotics][proved]") {
    check_line("y' = y^2; y(0) = 3/7", rational(3, 7), -6);           // 1/(7/3 - t)
    check_line("y' = y^3; y(0) = 1", 2, -3);                          // (1 - 2t)^(-1/2)
    check_line("y' = y^4; y(0) = 1", 3, -2);                          // (1 - 3t)^(-1/3)
    check_line("y' = -1/(2*y); y(0) = 1", 1, 3);                      // sqrt(1 - t)
    check_line("y' = -1/(y - 1); y(0) = 2", 2, 3);                    // 1 + sqrt(1 - 2t)
    check_line("y' = exp(y); y(0) = 0", 1, 0);                        // -log(1 - t)
    check_line("y' = -2*t*y^2; y(0) = 1", -1, -6);                    // 1/(1 + t^2), in t^2
    check_line("y'' = 6*y^2; y(0) = 1; y'(0) = 2", 1, -12);           // (1 - t)^-2
    check_line("y' = y^3; y(0) = 1", 2, -9, {.derivative = 1});       // (1 - 2t)^(-3/2)
    check_line("(1-t)*y'' - y' = 0; y(0) = 0; y'(0) = 1", 1, 0);      // -log(1 - t)
    check_line("y' = 1/(2*(t - 2))*y; y(0) = 3", rational(1, 2), 3);  // 3 sqrt(1 - t/2)
}

TEST_CASE("a pair, two singularities at one distance and entire solutions have no line", "[asymptotics][proved]") {
    const precision_scope scope(40);
    // 1/(1 + (t - 1/2)^2), poles at 1/2 +- i
    const auto pair = law_of_text("y' = -2*(t - 1/2)*y^2; y(0) = 4/5");
    CHECK_FALSE(line_of_ratios(pair));
    REQUIRE(radius_of_law(pair));
    CHECK(overlaps(*radius_of_law(pair), ball(sqrt(ball(5)) / 2)));
    // logarithms at 1 and -1 with different coefficients
    const auto legendre = law_of_text("(1-t^2)*y'' - 2*t*y' + 4/9*y = 0; y(0) = 1; y'(0) = 1/2");
    CHECK_FALSE(line_of_ratios(legendre));
    REQUIRE(radius_of_law(legendre));
    CHECK(overlaps(*radius_of_law(legendre), ball(1)));
    // t, whose singular terms at 1 and -1 have coefficients 0 that only balls show
    const auto line_of_legendre = law_of_text("(1-t^2)*y'' - 2*t*y' + 2*y = 0; y(0) = 0; y'(0) = 1");
    CHECK_FALSE(line_of_ratios(line_of_legendre));
    CHECK_FALSE(radius_of_law(line_of_legendre));
    const auto entire = law_of_text("y'' = -y; y(0) = 0; y'(0) = 1", {.within = 3});
    CHECK_FALSE(line_of_ratios(entire));
    CHECK_FALSE(radius_of_law(entire));
}

}  // namespace asymptotics_ratio_line_test
