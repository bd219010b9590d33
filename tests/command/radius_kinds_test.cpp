// `libration radius --prove` where the law of the coefficients says what the nearest singularities are.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"

namespace command_radius_kinds_test {

using namespace libration;
using namespace libration::tests;

// The roots of t^3 = 2 are the singular points; (1 - t)^2 is a solution without one at 1.
TEST_CASE("the radius of linear equations is a zero of the leading coefficient", "[command][radius]") {
    const auto cubic = rows_of(
        {"radius", "--prove", "--digits", "20", "--problem", "(t^3-2)*y'' + t*y' + y = 0; y(0) = 1; y'(0) = 1"});
    REQUIRE(cubic.size() == 1);
    CHECK(cubic[0].at("lower") == "1.2599210498948731647");
    CHECK(cubic[0].at("upper") == "1.2599210498948731648");
    CHECK(cubic[0].at("rigour") == "proved");
    const std::string text =
        output_of({"radius", "--prove", "--digits", "12", "--problem", "y' = 1/(1+t^2); y(0) = 0"});
    CHECK(text.find("lower  1  proved: no solution") != std::string::npos);
    CHECK(text.find("nearest  proved: logarithm at t - t0 = (0) + (1.00000000000)i; logarithm at") !=
          std::string::npos);
}

TEST_CASE("the kinds of the nearest singularities", "[command][radius]") {
    const std::string pole =
        output_of({"radius", "--prove", "--digits", "8", "--problem", "y' = 1 + t - y + 2*y^2; y(0) = 1/2"});
    CHECK(pole.find("nearest  proved: simple pole, exponent -1 at t - t0 = 0.8369") != std::string::npos);
}

}  // namespace command_radius_kinds_test
