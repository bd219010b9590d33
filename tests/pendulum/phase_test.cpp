#include "libration/pendulum/phase.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_phase_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
phase<T> phase_at(const motion& m, const std::string& time) {
    return phase_map<T>(m).at(read_exact(time));
}

// A tabulated T* with its 60 digits.
expected_value tabulated_quarter(const std::string& energy) {
    for (const auto& row : reference_table("motions.csv")) {
        if (row.at("energy") == energy) {
            return decimal(row.at("tstar"));
        }
    }
    throw std::runtime_error("no motion of energy " + energy);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("multiples of T are reached exactly", "[phase]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    struct quarter_at {
        std::string energy;
        std::string time;
        int quarter;
    };
    const std::vector<quarter_at> cases{{"1.71", "0", 1},        {"1.71", "T/4", 2}, {"1.71", "-3T/4", -2},
                                        {"1.71", "1000T", 4001}, {"2.02", "T/2", 2}, {"2.02", "-1000.5T", -2000},
                                        {"0.5", "T", 5}};
    for (const auto& c : cases) {
        INFO("E = " << c.energy << " at " << c.time);
        const auto p = phase_at<T>(with_energy(c.energy), c.time);
        CHECK(p.quarter == c.quarter);
        CHECK(p.side == 0);
        CHECK(p.offset == 0);
    }
}

TEMPLATE_LIST_TEST_CASE("between the quarters the side is the sign of the offset", "[phase]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto after = phase_at<T>(with_energy("1.71"), "1e-30");
    CHECK(after.quarter == 1);
    CHECK(after.side == 1);
    CHECK_THAT(after.offset, near<T>(decimal("1.0000000000000000000000000000000000000000000000000000000000000000000000"
                                             "000000000000000000000000000000000000000000e-30"),
                                     1));
    CHECK(phase_at<T>(with_energy("1.71"), "-1e-30").side == -1);
    CHECK(phase_at<T>(with_energy("1.71"), "T/5").side == -1);
    CHECK(phase_at<T>(with_energy("1.71"), "T/9").side == 1);
}

TEMPLATE_LIST_TEST_CASE("a long time is reduced by a T* of as many more digits", "[phase]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"0.5", "1.71", "2.02", "4"}) {
        for (const std::string time : {"7.3", "-13.5", "1e6", "1e12", "1e20", "-1e20"}) {
            INFO("E = " << energy << " at " << time);
            const auto p = phase_at<T>(with_energy(energy), time);
            expected_value expected;
            mpfr quarter;
            {
                // From the top, quarter 1: offset = time - (quarter - 1) T*, T* known to 60 digits.
                const precision_scope wide(220);
                const expected_value effective = tabulated_quarter(energy);
                quarter = effective.value;
                const mpfr quarters = from_rational<mpfr>(rational(p.quarter - 1));
                expected = {from_exact<mpfr>(read_exact(time)) - quarters * effective.value,
                            abs(quarters) * effective.uncertainty};
            }
            CHECK_THAT(p.offset, near<T>(expected, 1));  // rounded once
            CHECK(abs(widen(p.offset)) <= quarter * mpfr("0.5000001"));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("a start between the symmetric points is that far from the bottom", "[phase]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // E = 1 from 90 degrees takes T* to the bottom: the phase of (theta, falling) is 2 T* less that of (theta, rising).
    const motion rising = motion::of_energy_from(1, read_exact("1"), 1);
    const motion falling = motion::of_energy_from(1, read_exact("1"), -1);
    const auto up = phase_at<T>(rising, "0");
    const auto down = phase_at<T>(falling, "0");
    CHECK(up.quarter + down.quarter == 2);
    CHECK_THAT(T(-down.offset), near<T>(up.offset, 1, T(2)));
    // On the separatrix: sinh of the time since the bottom is tan(theta/2), here sqrt 3.
    using std::log;
    using std::sqrt;
    const auto critical = phase_at<T>(with_state("120deg", "1"), "0");
    CHECK(critical.quarter == 0);
    CHECK_THAT(critical.offset, near<T>(T(log(2 + sqrt(T(3)))), 2));
    CHECK(phase_at<T>(with_state("120deg", "-1"), "0").offset == -critical.offset);
}

TEMPLATE_LIST_TEST_CASE("where the motion has no period the offset is the whole time", "[phase]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const motion& m : {with_energy("2"), with_state("pi", "0")}) {
        const auto p = phase_at<T>(m, "1e20");
        CHECK(p.offset == from_exact<T>(read_exact("1e20")));
        CHECK_THROWS_AS(phase_at<T>(m, "T/4"), libration::error);
    }
    CHECK_NOTHROW(phase_at<T>(with_energy("0"), "T/4"));
}

TEMPLATE_LIST_TEST_CASE("seconds are sqrt(gravity/length) units of time", "[phase]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const motion m = with_state("2.5", "-0.3");
    const auto plain = phase_at<T>(m, "21.9");
    const auto seconds = phase_at<T>(m.with_squared_frequency(9), "7.3");
    CHECK(seconds.quarter == plain.quarter);
    CHECK(seconds.offset == plain.offset);
    const auto fraction_of_period = phase_at<T>(m.with_squared_frequency(rational(981, 25)), "5T/16");
    CHECK(fraction_of_period.quarter == phase_at<T>(m, "5T/16").quarter);
    CHECK(fraction_of_period.offset == phase_at<T>(m, "5T/16").offset);
}

}  // namespace pendulum_phase_test
