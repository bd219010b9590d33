// Coordinates in which poles are zeros, compared with the equations themselves, and cases without any.
#include "libration/plane/regular_coordinates.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/first_order_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/mpfr.hpp"

namespace plane_regular_coordinates_test {

using namespace libration;
using namespace libration::ode;

namespace {

std::optional<regular_coordinates> of(const std::string& text) {
    return regular_coordinates::of(explicit_system(parse(text)));
}

}  // namespace

// The chain rule by a central difference of order 2 in 60 digits with the step 10^-20: its error is 10^-40 times a
// third derivative, here below 10^6.
TEST_CASE("regular coordinates move as the equation says", "[ode][singularity]") {
    const std::string f = GENERATE(
        "y' = 1 + t*y - exp(t)*y^2; y(0) = 1/3", "y'' = 6*y^2 + t; y(0) = 1/3; y'(0) = 2",
        "y'' = -3*y^2/7 + 2*y + 5 - 3*t; y(0) = 1/3; y'(0) = 2", "y'' = 2*y^3 + t*y + 3/4; y(0) = 1/3; y'(0) = 2",
        "y'' = -y - y^3/5; y(0) = 1/3; y'(0) = 2", "y'' = 2*y^3 - y^2 + 5*y + 1; y(0) = 1/3; y'(0) = 2");
    CAPTURE(f);
    const precision_scope scope(60);
    const explicit_system system(parse(f));
    const auto regular = regular_coordinates::of(system);
    REQUIRE(regular);
    const first_order_form form(system);
    const mpfr t = mpfr(1) / 7;
    std::vector<mpfr> state{mpfr(3) / 5};
    if (form.leaves.size() == 2) {
        state.push_back(mpfr(-7) / 4);
    }
    const mpfr h = pow(mpfr(10), -20);
    // Along the solution to second order, on both sides.
    const auto slopes = form.slopes_at(state, t);
    const auto beside = [&](const mpfr& by) {
        std::vector<mpfr> half, moved;
        for (std::size_t i = 0; i < state.size(); ++i) {
            half.push_back(state[i] + by / 2 * slopes[i]);
        }
        const auto middle = form.slopes_at(half, mpfr(t + by / 2));
        for (std::size_t i = 0; i < state.size(); ++i) {
            moved.push_back(state[i] + by * middle[i]);
        }
        return regular->from(mpfr(t + by), moved);
    };
    const auto behind = beside(-h);
    const auto before = beside(h);
    const auto expected = regular->slopes(t, regular->from(t, state));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i);
        const mpfr slope = (before[i] - behind[i]) / (2 * h);
        CHECK(abs(mpfr(slope - expected[i])) < mpfr("1e-34"));
    }
}

// p^2 = v factor, for poles of order 2.
TEST_CASE("the slope of the inverse vanishes with it at double poles", "[ode][singularity]") {
    const precision_scope scope(50);
    const auto regular = of("y'' = -3*y^2/7 + 2*y + 5 - 3*t; y(0) = 1/3; y'(0) = 2");
    REQUIRE(regular);
    CHECK(regular->order() == 2);
    const mpfr t = mpfr(2) / 3;
    const auto at = regular->from(t, {mpfr(5) / 3, mpfr(-2)});
    CHECK(abs(mpfr(at[1] * at[1] - at[0] * regular->factor(t, at))) < 100 * epsilon<mpfr>());
}

TEST_CASE("equations whose poles are none by their form have no regular coordinates", "[ode][singularity]") {
    for (const std::string text :
         {"y' = y^3; y(0) = 1", "y' = y + t; y(0) = 1", "y' = exp(y); y(0) = 1",
          "y'' = 6*y^2 + t^2; y(0) = 1; y'(0) = 0", "y'' = 6*y^2 + t*y; y(0) = 1; y'(0) = 0",
          "y'' = t*y^2; y(0) = 1; y'(0) = 0", "y'' = t*y^3; y(0) = 1; y'(0) = 0", "y'' = y; y(0) = 1; y'(0) = 0",
          "y'' = 2*y^3 + t; y(0) = 1; y'(0) = 0", "y'' = 2*y^3 + y^2 + t*y; y(0) = 1; y'(0) = 0",
          "y'' = 2*y^3 + t^2*y; y(0) = 1; y'(0) = 0", "y'' = y^4; y(0) = 1; y'(0) = 0",
          "y'' = y^2 - y'; y(0) = 1; y'(0) = 0", "y'' = -sin(y); y(0) = 1; y'(0) = 0",
          "x' = x*y; y' = -x^2; x(0) = 1; y(0) = 0", "y''' = y^2; y(0) = 1; y'(0) = 0; y''(0) = 0",
          "t*y'' + 2*y' + t*y^3 = 0; y(0) = 1; y'(0) = 0", "y' = t*y^2 + 1/y; y(0) = 1"}) {
        INFO(text);
        CHECK_FALSE(of(text));
    }
}

}  // namespace plane_regular_coordinates_test
