// `libration radius` of several unknowns: to which unknown the verdict belongs, and its notes on psi series and
// logarithms.
#include <catch2/catch.hpp>
#include <string>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_radius_unknowns_test {

using namespace libration;
using namespace libration::tests;

TEST_CASE("the text says whose radius the verdict is and which unknowns agree", "[command][radius]") {
    // x = 1/(1 - t), y = -log(1 - t), z = 1/(2 - t).
    const std::string text =
        output_of({"radius", "--problem", "x' = x^2; y' = x; z' = z^2; x(0) = 1; y(0) = 0; z(0) = 1/2", "--order", "30",
                   "--scalar", "mpfr:30"});
    INFO(text);
    const bool of_x = text.find("unknown       x; the radius of y agrees with it; that of z is another") != text.npos;
    const bool of_y = text.find("unknown       y; the radius of x agrees with it; that of z is another") != text.npos;
    CHECK((of_x || of_y));
    CHECK(text.find("\nunknown  method") != std::string::npos);
    for (const char* const row : {"\nx        verdict", "\ny        verdict", "\nz        verdict"}) {
        CHECK(text.find(row) != std::string::npos);
    }
}

TEST_CASE("a psi series has an exponent and no kind", "[command][radius]") {
    const words blasius{"radius", "--problem", "blasius", "--order", "100"};
    const auto verdict = rows_of(blasius).at(0);
    CHECK(verdict.at("kind").empty());
    if (!verdict.at("exponent").empty()) {
        CHECK(abs(number_of(verdict.at("exponent")) + 1) <= number_of(verdict.at("exponent_uncertainty")));
    }
    CHECK_THAT(output_of(blasius), Catch::Contains("3 singularities at") && Catch::Contains("of undetermined kind"));
}

// x = -+sqrt(2) i/(t - t*) + ... with logarithms from the fourth term on unless c = 0.
TEST_CASE("the damped Duffing oscillator has no poles, the undamped one has", "[command][radius]") {
    for (const std::string start : {"x(0) = 1; x'(0) = 0", "x(0) = 1/2; x'(0) = 2"}) {
        for (const std::string c : {"0", "0.01", "0.4"}) {
            for (const std::string order : {"40", "70"}) {
                INFO(c << ", " << start << ", " << order);
                const auto rows = rows_of(
                    {"radius", "--problem", "x'' = -c*x' - x - x^3; " + start + "; c = " + c, "--order", order});
                CHECK((rows[0].at("kind") == "pole") == (c == "0"));
            }
        }
    }
}

}  // namespace command_radius_unknowns_test
