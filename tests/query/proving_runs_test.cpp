// Runs of many unknowns of which each distinguishes only a few more from 0, against bounds of the solution.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/query/states.hpp"

namespace query_proving_runs_test {

using namespace libration;
using namespace libration::ode;

// u = 1/(1 + t), w_i = t^i/i! + u, and v_i' = w_(i-1) - u: v_i = t^i/i!, which is a difference in balls. At t = 1/40
// the last is 1e-318, for which 1060 bits would be necessary.
TEST_CASE("runs end where each distinguishes only a few more unknowns from 0", "[ode][proved]") {
    const int count = 100;
    std::string text = "u' = -u^2; u(0) = 1; w1' = 1 - u^2; w1(0) = 1";
    for (int i = 2; i <= count; ++i) {
        const std::string driver = "' = w" + std::to_string(i - 1) + " - u";
        text += "; w" + std::to_string(i) + driver + " - u^2; w" + std::to_string(i) + "(0) = 1";
        text += "; v" + std::to_string(i) + driver + "; v" + std::to_string(i) + "(0) = 0";
    }
    const auto found = proved_part_of_trajectory(explicit_system(parse(text)), {number(rational(1, 40))}, 10);
    REQUIRE(found.missing);
    const std::string reason = found.missing->what();
    INFO(reason);
    CHECK(reason.find(" bits do not distinguish from 0: |v") != std::string::npos);
    CHECK(reason.find("more such values (more --digits begin with more bits)") != std::string::npos);
    std::size_t known = 0;
    for (int i = 2; i <= count; ++i) {
        const double truth = -i * std::log10(40.) - std::lgamma(i + 1) / std::log(10);  // log10
        const known_value& value = found.states.front()[static_cast<std::size_t>(2 * i - 1)];
        const std::string& text_of_value = value.decimal ? value.decimal->text : value.bound;
        REQUIRE(!text_of_value.empty());
        const std::size_t e = text_of_value.find('e');
        const double decimal = std::log10(std::abs(std::stod(text_of_value.substr(0, e)))) +
                               (e == std::string::npos ? 0 : std::stod(text_of_value.substr(e + 1)));
        INFO("v" << i << " " << text_of_value);
        known += value.decimal ? 1 : 0;
        CHECK(decimal > truth - 1e-9);
        CHECK((!value.decimal || decimal < truth + 1e-9));
    }
    CHECK(known >= 20);
    CHECK(known < static_cast<std::size_t>(count));
}

}  // namespace query_proving_runs_test
