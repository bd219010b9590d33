// The closed form of the variation of the solution compared with neighbouring motions, and with closed forms.
#include "libration/pendulum/variation.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/pendulum/exact_solution.hpp"
#include "scalars.hpp"

namespace pendulum_variation_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

exact typed(const std::string& text) { return read_exact(text); }

mpfr theta_of(const motion& m, const exact& time) { return exact_solution<mpfr>(m)(time).theta; }

// The solutions at a time of a motion.
variation_pair<mpfr> pair_of(const motion& m, const variation<mpfr>& v, const exact& time) {
    const auto state = exact_solution<mpfr>(m)(time);
    return v.at(dimensionless_time<mpfr>(m, time), state.theta, state.omega);
}

rational step() { return {integer(1), integer(1) << 200U}; }

// x plus a 2^-200 of it.
exact moved(const exact& x) { return {rational(x.coefficient * (1 + step())), x.measure, x.text}; }

// The difference quotient of so small a step is correct to 2^-200 times second derivatives, below 2^60 here, and to the
// bits that are left of 500 after 200.
mpfr quotient(const mpfr& after, const mpfr& before, const exact& x) {
    return (after - before) / (from_exact<mpfr>(moved(x)) - from_exact<mpfr>(x));
}

bool close(const mpfr& a, const mpfr& b) { return abs(mpfr(a - b)) <= ldexp(mpfr(abs(b) + 1), -100); }

}  // namespace

TEST_CASE("the derivatives by the start are those of neighbouring motions", "[pendulum][variation]") {
    const precision_scope scope(150);
    const std::vector<std::pair<std::string, std::string>> starts{
        {"2.5", "-0.3"}, {"-1", "2.1"}, {"7", "-1.1"}, {"100", "3"}, {"3", "0"}, {"120deg", "1"}, {"-60deg", "0.2"}};
    for (const auto& [angle, speed] : starts) {
        for (const char* instant : {"0", "0.7", "-5", "17", "1e3"}) {
            INFO("theta0 " << angle << ", omega0 " << speed << ", t = " << instant);
            const exact theta0 = typed(angle);
            const exact omega0 = typed(speed);
            const exact time = typed(instant);
            const motion m = motion::of_state(theta0, omega0);
            if (m.regime() == regime::separatrix && from_exact<double>(time) > 50) {
                continue;  // the neighbours diverge from it by e^t times the step
            }
            const variation<mpfr> v(m);
            const auto at = pair_of(m, v, time);
            const mpfr here = theta_of(m, time);
            CHECK(
                close(v.by_angle(at), quotient(theta_of(motion::of_state(moved(theta0), omega0), time), here, theta0)));
            if (!omega0.is_zero()) {
                CHECK(close(v.by_speed(at),
                            quotient(theta_of(motion::of_state(theta0, moved(omega0)), time), here, omega0)));
            }
        }
    }
}

TEST_CASE("the derivatives by the energy are those of neighbouring motions", "[pendulum][variation]") {
    const precision_scope scope(150);
    for (const char* text : {"1.71", "0.001", "1.9999999999", "2.0000001", "30"}) {
        for (const char* instant : {"0.7", "-5", "40", "T/8"}) {
            INFO("E " << text << ", t = " << instant);
            const exact energy = typed(text);
            const exact time = typed(instant);
            const motion m = motion::of_energy(energy.coefficient);
            const auto state = exact_solution<mpfr>(m)(time);
            const variation<mpfr> v(m);
            const auto at = time.measure == unit::period ? v.at_fraction(state.theta, state.omega)
                                                         : v.at(from_exact<mpfr>(time), state.theta, state.omega);
            CHECK(close(at.phi,
                        quotient(theta_of(motion::of_energy(moved(energy).coefficient), time), state.theta, energy)));
        }
    }
    // From theta0 = 1, upward and downward.
    for (const int direction : {1, -1}) {
        const exact theta0 = typed("1");
        const exact energy = typed("1.3");
        const exact time = typed("9");
        const motion m = motion::of_energy_from(energy.coefficient, theta0, direction);
        const variation<mpfr> v(m);
        const auto at = pair_of(m, v, time);
        const mpfr here = theta_of(m, time);
        const auto from = [&](const exact& e, const exact& angle) {
            return theta_of(motion::of_energy_from(e.coefficient, angle, direction), time);
        };
        CHECK(close(v.by_energy_from_angle(at), quotient(from(moved(energy), theta0), here, energy)));
        CHECK(close(v.by_angle_at_energy(at), quotient(from(energy, moved(theta0)), here, theta0)));
    }
}

TEST_CASE("a small swing varies as the harmonic one", "[pendulum][variation]") {
    const precision_scope scope(60);
    // theta = theta0 cos t + omega0 sin t + O(1e-30) at amplitudes of 1e-15.
    const motion m = motion::of_state(typed("1e-15"), typed("2e-15"));
    const variation<mpfr> v(m);
    const auto at = pair_of(m, v, typed("3"));
    CHECK(abs(mpfr(v.by_angle(at) - cos(mpfr(3)))) < mpfr("1e-29"));
    CHECK(abs(mpfr(v.by_speed(at) - sin(mpfr(3)))) < mpfr("1e-29"));
}

TEST_CASE("in double the variation has the digits that it promises", "[pendulum][variation]") {
    for (const char* text : {"1.71", "0.3", "1.99", "2.01", "8"}) {
        INFO("E " << text);
        const motion m = motion::of_energy(read_exact(text).coefficient);
        const auto state = exact_solution<double>(m)(typed("17"));
        const double phi = variation<double>(m).at(17, state.theta, state.omega).phi;
        const precision_scope scope(60);
        const auto expected = convert<double>(pair_of(m, variation<mpfr>(m), typed("17")).phi);
        // eps t^2/D, and 8 for the operations: D is above 0.0198.
        CHECK(std::abs(phi - expected) <= 8 * epsilon<double>() * 17 * 17 / 0.0198);
    }
}

TEST_CASE("motions at rest have no variation of this form", "[pendulum][variation]") {
    CHECK_THROWS_AS(variation<double>(motion::of_energy(0)), libration::error);
    CHECK_THROWS_AS(variation<double>(motion::of_state(typed("pi"), typed("0"))), libration::error);
}

}  // namespace pendulum_variation_test
