// Boundary layers with a condition at infinity against digits in print.
#include "libration/problem/known/falkner_skan.hpp"
#include "libration/problem/known/sakiadis_shear.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/known/shooting.hpp"
#include "libration/problem/known/thomas_fermi.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/scalar/ball/predicates.hpp"
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

TEST_CASE("the lemma of accelerated flow is for b > 0", "[ode][proved]") {
    const auto values = [](const equation_system& system) {
        return known_facts_of("falkner_skan")->condition->values(system, "1", 5).front().text;
    };
    const auto with = [](const std::string& b) { return changed(parse(problem_text("falkner_skan")), "b = " + b); };
    CHECK(values(with("1/2")) == "0.92768");
    CHECK(values(parse("f''' + f*f'' + 1 - f'^2 = 0; f(0) = 0; f'(0) = 0; f''(0) = s; s = 1.23")) == "1.2326");
    for (const char* b : {"0", "-0.12"}) {
        CHECK_THROWS_WITH(values(with(b)), Catch::Contains("only for b > 0"));
    }
}

// f' = s at all times, and f' = 1/(1/s - t).
TEST_CASE("a number is between two others whose sides are decided, and differ", "[ode][proved]") {
    const precision_scope scope(20);
    using sides = std::optional<side>;
    const equation_system line = parse("f'' = 0; f(0) = 0; f'(0) = s; s = 1");
    const equation_system pole = parse("f'' = f'^2; f(0) = 0; f'(0) = s; s = 1");
    const auto found = [](const equation_system& system, const ball& least, const state_test& decided) {
        return between(system, "s", mpfr(1), decided, least);
    };
    const auto is_below = [](const std::vector<ball>& f) { return certainly_less(f[1], ball(1)); };
    const ball both = found(line, ball(-2), [&](const auto& f) { return is_below(f) ? side::below : side::above; });
    CHECK(contains_zero(both - 1));
    CHECK(certainly_less(radius_of(both), pow(ball(10), -15)));
    const auto undecided = [](const auto& /*f*/) { return sides(); };
    CHECK_THROWS_AS(found(line, ball(-2), undecided), precision_exhausted);
    CHECK_THROWS_AS(found(line, ball(2), undecided), precision_exhausted);
    CHECK_THROWS_AS(found(pole, ball(-2), undecided), precision_exhausted);
    CHECK_THROWS_AS(found(line, ball(-2), [](const auto& /*f*/) { return side::above; }), precision_exhausted);
    CHECK_THROWS_AS(found(line, ball(-2), [&](const auto& f) { return is_below(f) ? sides(side::below) : sides(); }),
                    precision_exhausted);
}

TEST_CASE("a guess that leads nowhere is refused", "[ode][proved]") {
    CHECK_THROWS_AS(shear("falkner_skan", {"s = -40"}, 5), error);
}

}  // namespace problem_known_conditions_at_infinity_test
