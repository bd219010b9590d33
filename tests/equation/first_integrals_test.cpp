// Integrals, symmetries and skew forms of systems for which they are known.
#include "libration/equation/first_integrals.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/linear_invariance.hpp"
#include "libration/equation/power_sum.hpp"
#include "libration/equation/text/parse.hpp"

namespace equation_first_integrals_test {

using namespace libration;
using namespace libration::ode;

namespace {

std::vector<first_integral> integrals_of(const std::string& text) {
    const explicit_system system(parse(text));
    return first_integrals_of(first_order_form(system), system.invariants());
}

bool has(const std::vector<first_integral>& all, const std::string& text) {
    return std::ranges::any_of(all, [&](const first_integral& each) { return each.text == text; });
}

bool is_zero(const std::string& text) {
    const explicit_system system(parse("x' = " + text + "; y' = 0; x(0) = 2; y(0) = 3"));
    power_sums sums;
    return !sums.relations(std::vector<power_sum>{sums.of(system.right()[0])}).empty();
}

const char* const kepler =
    "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2); x(0) = 1; y(0) = 0; x'(0) = 0; y'(0) = 1";

}  // namespace

TEST_CASE("integrals of mechanics are found", "[ode]") {
    const auto of_kepler = integrals_of(kepler);
    CHECK(has(of_kepler, "-x*y' + x'*y"));
    CHECK(of_kepler.size() >= 4);  // also the energy, and the vector of Laplace, Runge and Lenz
    CHECK(has(integrals_of("x' = 2*x - x*y; y' = x*y - y; x(0) = 1; y(0) = 1"),
              "-1/2*x - 1/2*y + 1/2*log |x| + log |y|"));
    CHECK(has(integrals_of("x'' = -x; x(0) = 1; x'(0) = 0"), "x^2 + x'^2"));
    CHECK(integrals_of("x'' = (1 - x^2)*x' - x; x(0) = 2; x'(0) = 0").empty());
    CHECK(integrals_of("x'' = -sin(x) - x'/100; x(0) = 1; x'(0) = 0").empty());
    // The angular field is closed, and has no potential: a particle gains 2 pi with each turn.
    CHECK(integrals_of("x'' = -y/(x^2 + y^2); y'' = x/(x^2 + y^2); x(0) = 1; y(0) = 0; x'(0) = 0; y'(0) = 0").empty());
}

TEST_CASE("a declared invariant is an integral only if it is conserved", "[ode]") {
    CHECK(integrals_of("x'' = (1 - x^2)*x' - x; x(0) = 2; x'(0) = 0; invariant x + x'").empty());
}

TEST_CASE("sums of powers are compared where they have values", "[ode]") {
    CHECK(is_zero("1/sqrt(x^2 + y^2)^3 - (x^2 + y^2)^(-3/2)"));
    CHECK(is_zero("sqrt(x^2 + y^2) - (x^2 + y^2)/sqrt(y^2 + x^2)"));
    CHECK(is_zero("1/(x - y) - (x + y)/((x - y)*(x + y))"));
    CHECK_FALSE(is_zero("sqrt(x^2) - x"));  // |x|
    CHECK_FALSE(is_zero("1/(x - y) + 1/(x + y)"));
    CHECK_FALSE(is_zero("(x^2 + y^2)^(1/2) - (x^2 + y^2)^(1/3)"));
}

TEST_CASE("symmetries and symplectic flows", "[ode]") {
    const explicit_system system{parse(kepler)};
    const first_order_form form(system);
    CHECK(affine_symmetries_of(form).size() == 1);  // the rotation
    CHECK(is_symplectic(form));
    const explicit_system magnetic(
        parse("x'' = 2*y' + 3*x; y'' = -2*x' - y; x(0) = 1; y(0) = 0; x'(0) = 0; y'(0) = 0"));
    CHECK(is_symplectic(first_order_form(magnetic)));
    const explicit_system damped(parse("x'' = -x - x'/9; x(0) = 1; x'(0) = 0"));
    CHECK_FALSE(is_symplectic(first_order_form(damped)));
}

}  // namespace equation_first_integrals_test
