// Runs of many unknowns of which each distinguishes only a few more from 0, against bounds of the solution.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/query/states.hpp"

namespace query_proving_runs_test {

using namespace libration;
using namespace libration::ode;

// x1' = 1, x_(i+1)' = x_i^2 from 0: x_i = c_i t^(2^i - 1), c_1 = 1, c_(i+1) = c_i^2/(2^(i+1) - 1), at t = 1/1000. Of 16
// unknowns the last is 1e-225000, for which 750000 bits would be necessary.
TEST_CASE("runs end where each distinguishes only a few more unknowns from 0", "[ode][proved]") {
    const int count = 16;
    std::string text = "x1' = 1; x1(0) = 0";
    for (int i = 2; i <= count; ++i) {
        text += "; x" + std::to_string(i) + "' = x" + std::to_string(i - 1) + "^2; x" + std::to_string(i) + "(0) = 0";
    }
    const auto found = proved_part_of_trajectory(explicit_system(parse(text)), {number(rational(1, 1000))}, 10);
    REQUIRE(found.missing);
    const std::string reason = found.missing->what();
    CHECK(reason.find(" bits do not distinguish from 0: |x") != std::string::npos);
    CHECK(reason.find("more such values") != std::string::npos);
    CHECK(reason.find("more --digits begin with more bits") != std::string::npos);
    double log10_of_c = 0;
    std::size_t known = 0;
    for (int i = 1; i <= count; ++i) {
        const double power = std::ldexp(1, i) - 1;
        log10_of_c = i == 1 ? 0 : 2 * log10_of_c - std::log10(power);
        const double log10_of_truth = log10_of_c - 3 * power;
        const known_value& value = found.states.front()[static_cast<std::size_t>(i - 1)];
        const std::string& number = value.decimal ? value.decimal->text : value.bound;
        REQUIRE(!number.empty());
        known += value.decimal ? 1 : 0;
        const std::size_t e = number.find('e');
        const double log10_of_number =
            std::log10(std::stod(number.substr(0, e))) + (e == std::string::npos ? 0 : std::stod(number.substr(e + 1)));
        INFO("x" << i << " " << number);
        if (value.decimal) {
            CHECK(std::abs(log10_of_number - log10_of_truth) < 1e-8);
        } else {
            CHECK(log10_of_number > log10_of_truth);
        }
    }
    CHECK(known >= 6);
    CHECK(known < static_cast<std::size_t>(count));
}

}  // namespace query_proving_runs_test
