// Boundary layers with a condition at infinity against digits in print.
#include "libration/problem/known/proved/falkner_skan.hpp"
#include "libration/problem/known/proved/sakiadis.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/ode/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/known/proved/thomas_fermi.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace problem_known_conditions_at_infinity_test {

using namespace libration;
using namespace libration::ode;

namespace {

std::string shear(const std::string& problem, const std::vector<std::string>& changes, long digits) {
    auto system = parse(problem_text(problem));
    for (const std::string& each : changes) {
        system = changed(system, each);
    }
    return proved_value(digits,
                        [&] { return problem == "sakiadis" ? sakiadis_shear(system) : falkner_skan_shear(system); })
        .text;
}

}  // namespace

// s(1/2) = 0.927680039836653 [Belden et al. 2020], s(1) = 1.2325876568202810 by two computations that agree [PROBLEMS],
// f''(0) of Sakiadis -0.443748313368861 [Barlow et al. 2017].
TEST_CASE("shooting from two sides proves printed digits", "[ode][proved]") {
    CHECK(shear("falkner_skan", {}, 15) == "0.927680039836651");  // the printed last digits are off by 2 units
    CHECK(shear("falkner_skan", {"b = 1", "s = 1.23"}, 17) == "1.2325876568202810");
    CHECK(shear("sakiadis", {}, 14) == "-0.44374831336886");
}

// [Boyd2013], who prints 22 digits, the last one cut off: the next ones are 684...
TEST_CASE("the slope of the neutral atom is that of Boyd", "[ode][proved]") {
    CHECK(proved_value(22, [] { return thomas_fermi_slope(); }).text == "-1.588071022611375312719");
}

TEST_CASE("a guess that leads nowhere is refused", "[ode][proved]") {
    CHECK_THROWS_AS(shear("falkner_skan", {"s = -40"}, 5), error);
}

}  // namespace problem_known_conditions_at_infinity_test
