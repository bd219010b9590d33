// The route in fixed point and the choice of routes, compared with the route in balls at twice the precision.
#include "libration/pendulum/proved_canonical.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace pendulum_proved_canonical_test {

using namespace libration;
using namespace libration::pendulum;

namespace {

struct asked_case {
    rational energy;
    rational time;
};

class cases {
public:
    asked_case operator()() {
        asked_case at{rational(1 + below(1'999'998), 1'000'000), rational(below(20'000), 1000)};
        if (below(8) == 0) {
            at.time *= 10'000;
        }
        return at;
    }

private:
    long below(long n) { return static_cast<long>(engine_() % static_cast<unsigned long>(n)); }

    std::mt19937_64 engine_{11};
};

// log2 of the radius in units of 2^-bits.
long lost_bits(const ball& x, long bits) { return binary_exponent(radius_of(x)) + bits; }

}  // namespace

TEST_CASE("the libration in fixed point encloses what twice the precision encloses", "[pendulum][proved_canonical]") {
    cases next;
    int served = 0;
    for (const long bits : {60L, 120L, 340L, 1200L}) {
        for (int i = 0; i < (bits > 1000 ? 50 : 150); ++i) {
            const auto [energy, time] = next();
            const rational gap = 2 - energy;
            if (!proved_libration::serves(energy, gap, bits)) {
                continue;
            }
            INFO("E " << energy << " at " << time << ", " << bits << " bits");
            const proved_libration rough(energy, gap, bits);
            const ball z = times(rough.mean(), time, rough.bits());
            const auto state = rough.state_at(z);
            const auto angle = rough.theta_at(z);
            const precision_scope scope(decimal_digits(2 * rough.bits()));
            const landen_motion fine(energy, gap);
            const auto truth = fine.state_at(fine.phase_at(time));
            CHECK(contains(rough.mean(), fine.mean()));
            REQUIRE(state.has_value() == angle.has_value());
            if (state) {
                ++served;
                CHECK(contains(state->theta, truth.theta));
                CHECK(contains(state->omega, truth.omega));
                CHECK(contains(*angle, truth.theta));
                // Some 2^8 units of each step, 2^4 for 1/cos z, and theta moves with z and the mean's 2^8 units times
                // t.
                const long of_time = std::max(0L, binary_exponent(from_rational<ball>(rational(time + 1))));
                CHECK(lost_bits(*angle, rough.bits()) <= 10 + of_time);
                CHECK(lost_bits(state->omega, rough.bits()) <= 20 + of_time);
            }
        }
    }
    CHECK(served > 400);
}

TEST_CASE("both routes serve every energy and time", "[pendulum][proved_canonical]") {
    // cos z = 0 exactly never happens at a rational time; T/4 to 20 digits is near it. The others are computed by
    // balls.
    for (const char* energy : {"1", "1.71", "0.001", "1.9999999", "2.5", "1.00000000000000000000000001"}) {
        for (const char* time : {"0", "0.7", "1.8540746773013719184", "-3", "1e20", "1e60"}) {
            INFO("E " << energy << " at " << time);
            const rational e = read_exact(energy).coefficient;
            const rational t = read_exact(time).coefficient;
            const precision_scope scope(100);
            const proved_canonical chosen(e, rational(2 - e));
            const landen_motion balls(e, rational(2 - e));
            const auto state = chosen.state_at(chosen.phase_at(t));
            const auto other = balls.state_at(balls.phase_at(t));
            CHECK(overlaps(chosen.mean(), balls.mean()));
            CHECK(overlaps(state.theta, other.theta));
            CHECK(overlaps(state.omega, other.omega));
            CHECK(overlaps(chosen.theta_at(chosen.phase_at(t)), state.theta));
            CHECK(certainly_less(radius_of(state.theta), pow(ball(10), -25)));
        }
    }
}

TEST_CASE("a canonical motion refuses energies without a period", "[pendulum][proved_canonical]") {
    CHECK_THROWS_AS(proved_canonical(0, 2), libration::error);
    CHECK_THROWS_AS(proved_canonical(2, 0), libration::error);
    CHECK_THROWS_AS(proved_canonical(-1, 3), libration::error);
    CHECK_THROWS_AS(proved_canonical(1, rational(1, 2)), libration::error);
    CHECK_THROWS_AS(proved_canonical(rational(1, 2), rational(4, 3)), libration::error);
}

}  // namespace pendulum_proved_canonical_test
