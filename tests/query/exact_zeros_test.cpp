// Values of harmonic oscillations that are exactly 0, and others next to them that are not.
#include <catch2/catch.hpp>
#include <string>

#include "libration/problem/solution.hpp"
#include "libration/scalar/mpfr.hpp"

namespace query_exact_zeros_test {

using namespace libration;

namespace {

answer states(const std::string& text, const std::string& time) {
    return solve(problem(text))->states(time, proved_digits(20));
}

}  // namespace

TEST_CASE("multiples of a quarter period have exact zeros", "[query][exact_zeros]") {
    for (const auto& [text, time, name] :
         {std::tuple<std::string, std::string, std::string>{"x'' = -x; x(0) = 0; x'(0) = 1", "2*pi", "x"},
          {"x'' = -x; x(0) = 1; x'(0) = 0", "pi/2", "x"},
          {"x'' = -x; x(0) = 1; x'(0) = 0", "2*pi", "x'"},
          {"x'' = -x; x(0) = 1; x'(0) = 0", "1e6*pi", "x'"},  // in closed form: by steps it takes half a minute
          {"x' = 2*v; v' = -2*x; x(1) = 0; v(1) = 3", "1 + pi", "x"},
          {"x' = x + 2*v; v' = -x - v; x(0) = 0; v(0) = 3", "pi", "x"},
          {"x'' = -x; y' = if(x > 1/2, 1, 0); x(0) = 0; x'(0) = 1; y(0) = 0", "2*pi", "x"}}) {
        INFO(text << " at " << time);
        const answer found = states(text, time);
        CHECK_FALSE(found.missing);
        CHECK(found.at(0, name) == "0");
    }
}

TEST_CASE("a value next to an exact zero has its digits", "[query][exact_zeros]") {
    const precision_scope scope(60);
    // With steps, so that it is integrated: the first run does not distinguish these values from 0.
    const std::string stepped = "; y' = if(t > 1, 1, 0); y(0) = 0";
    const answer near = states("x'' = -x; x(0) = 1e-45; x'(0) = 1" + stepped, "2*pi");
    CHECK(mpfr(near.at(0, "x")) == mpfr("1e-45"));
    CHECK(states("x'' = -x; x(0) = 0; x'(0) = 1" + stepped, "2*pi + 1e-45").at(0, "x") == "1.0000000000000000000e-45");
    // Damped, forced, and with another rate.
    for (const std::string text :
         {"x'' = -x - x'/10^45; x(0) = 1; x'(0) = 0", "x'' = -x + 1/10^45; x(0) = 1; x'(0) = 0",
          "x'' = -(1 + 1/10^45)*x; x(0) = 1; x'(0) = 0"}) {
        INFO(text);
        CHECK(states(text + stepped, "pi/2").at(0, "x") != "0");
    }
    // The force depends on a step.
    const std::string forced = "x'' = -x + if(t > 1, 1, 0); x(0) = 0; x'(0) = 1";
    CHECK(states(forced, "2*pi").at(0, "x") != "0");
}

}  // namespace query_exact_zeros_test
