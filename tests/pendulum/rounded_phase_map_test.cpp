#include "libration/pendulum/rounded_phase_map.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_rounded_clock_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {
using fixed_scalars = std::tuple<scalar_tag<double>, scalar_tag<long double>, scalar_tag<quad>>;
}

TEMPLATE_LIST_TEST_CASE("early times have the phase of the timeline", "[rounded_clock]", fixed_scalars) {
    using T = typename TestType::type;
    const precision_scope precision(60);
    for (const std::string energy : {"1.71", "2.02"}) {
        const motion m = with_energy(energy);
        const rounded_phase_map<T> rounded(m);
        const phase_map<T> exact_phase_map(m);
        for (const std::string time : {"0", "0.3", "-1.1", "2", "5/2"}) {
            INFO("E = " << energy << " at " << time);
            const phase<T> found = rounded.at(read_exact(time));
            const phase<T> expected = exact_phase_map.at(read_exact(time));
            CHECK(found.quarter == expected.quarter);
            CHECK(found.side == expected.side);
            CHECK_THAT(found.offset, near<T>(expected.offset, 4, T(4)));  // t, T and the offset round
        }
    }
}

TEMPLATE_LIST_TEST_CASE("late times lose what their size times epsilon is", "[rounded_clock]", fixed_scalars) {
    using T = typename TestType::type;
    const precision_scope precision(80);
    for (const std::string energy : {"1.71", "2.02"}) {
        const motion m = with_energy(energy);
        const integer periods = 1'000'000;
        const mpfr naive =
            phase_map_error<T>(libration::exactly(fraction(energy)), rounded_phase_map<T>(m), periods, 16);
        const mpfr exactly_reduced =
            phase_map_error<T>(libration::exactly(fraction(energy)), phase_map<T>(m), periods, 16);
        const mpfr bound = rounded_phase_map_bound<T>(libration::exactly(fraction(energy)), periods);
        CHECK(naive <= bound);
        CHECK(naive > bound / 100);
        CHECK(exactly_reduced < 20 * widen(epsilon<T>()));
    }
    CHECK_THROWS_AS(rounded_phase_map<T>(with_energy("2")), libration::error);
    CHECK_THROWS_AS(rounded_phase_map<T>(with_state("1", "1/2")), libration::error);
}

TEST_CASE("phases lose whole periods, and angles of rotation whole turns", "[rounded_clock]") {
    const precision_scope precision(40);
    const auto quarter_of = [](int quarter, regime r) {
        return within_period(phase<double>{quarter, 0, 0}, r).quarter;
    };
    CHECK(quarter_of(9, regime::libration) == 1);
    CHECK(quarter_of(-1, regime::libration) == 3);
    CHECK(quarter_of(9, regime::rotation) == 1);
    CHECK(quarter_of(-4, regime::rotation) == 0);
    const mpfr turn = pi<mpfr>() * 2;
    CHECK_THAT(angle_between(mpfr(turn * 3 + 1), mpfr(-1), regime::rotation), near<mpfr>(mpfr(2), 30));
    CHECK(angle_between(mpfr(3), mpfr(-3), regime::libration) == 6);
}

}  // namespace pendulum_rounded_clock_test
