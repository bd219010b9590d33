#include "libration/pendulum/regime.hpp"

#include <catch2/catch.hpp>

namespace pendulum_regime_test {

using namespace libration;
using namespace libration::pendulum;

TEST_CASE("regimes have the names of the command", "[regime]") {
    CHECK(name_of(regime::libration) == "libration");
    CHECK(name_of(regime::rotation) == "rotation");
    CHECK(name_of(regime::separatrix) == "separatrix");
    CHECK(name_of(regime::stable_equilibrium) == "stable-equilibrium");
    CHECK(name_of(regime::unstable_equilibrium) == "unstable-equilibrium");
}

TEST_CASE("the separatrix and the unstable equilibrium are at E = 2, nothing else", "[regime]") {
    CHECK(at_critical_energy(regime::separatrix));
    CHECK(at_critical_energy(regime::unstable_equilibrium));
    CHECK_FALSE(at_critical_energy(regime::libration));
    CHECK_FALSE(at_critical_energy(regime::rotation));
    CHECK_FALSE(at_critical_energy(regime::stable_equilibrium));
}

}  // namespace pendulum_regime_test
