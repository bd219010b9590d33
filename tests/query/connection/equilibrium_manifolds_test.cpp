// Solutions on the manifolds of equilibria compared with conserved quantities and closed forms.
#include "libration/query/connection/equilibrium_manifolds.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"

namespace query_equilibrium_manifolds_test {

using namespace libration;
using namespace libration::ode;

namespace {

equilibrium_manifolds portrait(const std::string& equations, const std::string& name, const std::string& value,
                               bool stable = true, bool unstable = true) {
    return manifolds_of(parse(equations), {{name, parse_constant(value)}}, stable, unstable);
}

}  // namespace

// E = x'^2/2 - cos x = 1, and the whole loop is followed.
TEST_CASE("the separatrices of the pendulum have the energy of the saddle", "[ode]") {
    const auto found = portrait("x'' = -sin(x)", "x", "pi");
    REQUIRE(found.branches.size() == 4);
    CHECK(found.stable_dimension == 1);
    CHECK(found.equilibrium[0] == Approx(3.14159265358979));
    for (const auto& branch : found.branches) {
        double farthest = 0;
        for (std::size_t k = 0; k < branch.states.size(); ++k) {
            const auto& state = branch.states[k];
            CHECK(std::fabs(state[1] * state[1] / 2 - std::cos(state[0]) - 1) < 1e-10);
            CHECK((k == 0 || branch.times[k] > branch.times[k - 1]));
            farthest = std::max(farthest, std::fabs(state[0] - found.equilibrium[0]));
        }
        CHECK(farthest > 6.2);
        CHECK_FALSE(branch.leaves);
        const auto& beside = branch.stable ? branch.states.back() : branch.states.front();
        CHECK(std::hypot(beside[0] - found.equilibrium[0], beside[1]) < 1e-3);
    }
}

// y = -x^2/3 is the stable manifold of x' = -x, y' = y + x^2, and x = 0 the unstable one, which leaves.
TEST_CASE("manifolds in closed form are cut where they leave", "[ode]") {
    const auto found =
        manifolds_of(parse("x' = -x; y' = y + x^2"), {{"x", expression(0)}, {"y", expression(0)}}, true, true);
    REQUIRE(found.branches.size() == 4);
    for (const auto& branch : found.branches) {
        CHECK(branch.leaves);
        double farthest = 0;
        for (const auto& state : branch.states) {
            CHECK(std::fabs(branch.stable ? state[1] + state[0] * state[0] / 3 : state[0]) < 1e-9);
            farthest = std::max({farthest, std::fabs(state[0]), std::fabs(state[1])});
        }
        CHECK(farthest > 2);
        CHECK(farthest <= 3);
    }
}

TEST_CASE("what has no manifolds is refused", "[ode]") {
    CHECK_THROWS_AS(portrait("x'' = -sin(x)", "x", "0"), error);
    CHECK_THROWS_AS(portrait("x'' = -sin(x)", "x", "1"), error);
    CHECK_THROWS_AS(portrait("x'' = -sin(x)", "y", "0"), error);
    CHECK_THROWS_AS(portrait("x'' = -sin(x) + cos(t)", "x", "pi"), error);
    CHECK_THROWS_AS(portrait("x'' = (1-x^2)*x' - x", "x", "0", true, false), error);
}

}  // namespace query_equilibrium_manifolds_test
