#include "libration/pendulum/condition.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pendulum_condition_test {

using namespace libration;
using namespace libration::pendulum;

namespace {

typed_motion by_state(const char* theta0, const char* omega0) {
    typed_motion typed;
    typed.theta0 = read_exact(theta0);
    typed.omega0 = read_exact(omega0);
    return typed;
}

typed_motion by_energy(const char* energy) {
    typed_motion typed;
    typed.energy = read_exact(energy);
    return typed;
}

std::optional<mpfr> condition_of(const typed_motion& typed, const char* time) {
    const precision_scope scope(80);
    const conditioned_motion motion(typed, typed.motion());
    return motion.at(read_exact(time), motion.of().at(read_exact(time)));
}

// |change of theta| for a relative change of 10^-40 in one typed number, in units of that change.
mpfr felt(const typed_motion& typed, std::optional<exact> typed_motion::*number, const char* time) {
    const precision_scope scope(150);
    typed_motion moved = typed;
    (moved.*number)->coefficient *= 1 + power_of(10, -40);
    const exact instant = read_exact(time);
    const ball change =
        proved_motion(moved.motion()).at(instant).theta - proved_motion(typed.motion()).at(instant).theta;
    return abs(mpfr(midpoint_of(change) * pow(mpfr(10), 40)));
}

// The rest of the condition's definition; three digits are guaranteed.
bool agrees(const typed_motion& typed, const char* time, const mpfr& of_numbers) {
    const precision_scope scope(80);
    const exact instant = read_exact(time);
    const enclosed_state state = proved_motion(typed.motion()).at(instant);
    const mpfr elapsed = dimensionless_time<mpfr>(typed.motion(), instant);
    const mpfr sum = abs(mpfr(elapsed * midpoint_of(state.omega))) + of_numbers;
    const mpfr size = abs(midpoint_of(state.theta));
    const mpfr expected = sum / (size > 1 ? size : mpfr(1));
    return abs(mpfr(condition_of(typed, time).value() - expected)) <= expected / 1000;
}

}  // namespace

TEST_CASE("the condition is what neighbouring motions say", "[pendulum][condition]") {
    for (const char* time : {"0.7", "-17", "3T/4", "1e5"}) {
        for (const char* energy : {"1.71", "3", "0.01", "1.99999999", "1e15"}) {
            INFO("E " << energy << " at " << time);
            const typed_motion typed = by_energy(energy);
            CHECK(agrees(typed, time, felt(typed, &typed_motion::energy, time)));
        }
        for (const auto& [theta0, omega0] :
             std::vector<std::pair<const char*, const char*>>{{"2.5", "-0.3"}, {"100", "3"}, {"-1", "-2"}}) {
            INFO(theta0 << ", " << omega0 << " at " << time);
            const typed_motion typed = by_state(theta0, omega0);
            const mpfr both = felt(typed, &typed_motion::theta0, time) + felt(typed, &typed_motion::omega0, time);
            CHECK(agrees(typed, time, both));
        }
    }
}

TEST_CASE("the condition on the separatrix and at rest is that of the linear pendulum", "[pendulum][condition]") {
    const precision_scope scope(40);
    // theta0 pi at rest: pi cosh t, over max(1, pi). The number 0 is exact.
    CHECK(abs(mpfr(condition_of(by_state("pi", "0"), "5").value() / cosh(mpfr(5)) - 1)) < mpfr("1e-20"));
    CHECK(condition_of(by_state("0", "0"), "5").value() == 0);
    CHECK(abs(mpfr(condition_of(by_state("2pi", "0"), "1").value() / cos(mpfr(1)) - 1)) < mpfr("1e-20"));
    CHECK_FALSE(condition_of(by_state("pi", "0"), "2000").has_value());
    const typed_motion separatrix = by_state("120deg", "1");
    CHECK(agrees(separatrix, "3",
                 mpfr(felt(separatrix, &typed_motion::theta0, "3") + felt(separatrix, &typed_motion::omega0, "3"))));
    CHECK_FALSE(condition_of(by_energy("2"), "1").has_value());
    typed_motion resting = by_energy("2");
    resting.theta0 = read_exact("pi");
    CHECK_FALSE(condition_of(resting, "1").has_value());
}

}  // namespace pendulum_condition_test
