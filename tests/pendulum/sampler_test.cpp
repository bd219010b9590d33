// The sampler compared with proved values, at times in any order, near and late.
#include "libration/pendulum/sampler.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "libration/number/written_number.hpp"
#include "libration/pendulum/proved_motion.hpp"
#include "libration/scalar/vector_instructions.hpp"
#include "pendulum/typed.hpp"
#include "proved.hpp"

namespace pendulum_sampler_test {

using namespace libration;
using namespace libration::series;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

using fixed_scalars = std::tuple<double, long double, quad>;

// Digits for times of 10^9 periods, and for the cancellation at E = 10^-20 or gaps of 10^-100.
constexpr long proof_digits = 160;

std::vector<named_motion> all_motions() {
    std::vector<named_motion> motions = periodic_motions();
    for (const std::string gap : {"1e-15", "-1e-15", "1e-100", "-1e-100", "1e-400", "1e-6", "-1e-3"}) {
        motions.push_back({"gap " + gap, with_gap(gap)});
    }
    for (const std::string energy : {"0", "2", "1e-20", "0.03", "1", "1.999", "2.5", "30", "1e300"}) {
        motions.push_back({"E = " + energy, with_energy(energy)});
    }
    motions.push_back({"separatrix, clockwise", with_energy("2", -1)});
    motions.push_back({"separatrix from 2 pi/3", with_state("120deg", "1")});
    motions.push_back({"separatrix, clockwise from 2 pi/3", with_state("120deg", "-1")});
    motions.push_back({"at rest on top, 3 turns", with_state("7pi", "0")});
    motions.push_back({"at rest, 2 turns", with_state("-4pi", "0")});
    motions.push_back({"falling from 3", with_state("3", "-1/5")});
    motions.push_back({"turning from 1e6", with_state("1000000", "7")});
    motions.push_back({"turning from 1e30", with_state("1e30", "7")});
    motions.push_back({"back through the top", with_state("5pi", "-0.2")});
    motions.push_back({"next to the top", with_state("3.14159265358979", "1e-16")});
    motions.push_back({"next to the bottom, 3 turns back", with_state("-18.8495559215387", "2")});
    motions.push_back({"given energy, falling", motion::of_energy_from(fraction("1.9999999"), read_exact("-3"), -1)});
    motions.push_back({"in seconds", with_state("2.5", "-0.3").with_squared_frequency(fraction("9.81/0.7"))});
    return motions;
}

mpfr period_of(const motion& m) {
    const bool periodic = m.regime() == regime::libration || m.regime() == regime::rotation;
    const mpfr quarters(periodic ? quarters_per_period(m.regime()) : 4);
    return (periodic ? effective_period(energy_level_of<mpfr>(m)) : mpfr(3)) * quarters * time_unit<mpfr>(m);
}

// 0, the symmetric points, and times of either sign up to 1, 1000 and 10^9 periods, not in order.
template <class T>
std::vector<T> shuffled_times(const motion& m, int count) {
    const mpfr period = period_of(m);
    std::mt19937_64 engine(17);
    std::vector<T> times{T(0)};
    for (const int eighths : {1, 2, -2, 4, 6, 7, 8, -16}) {
        times.push_back(narrow<T>(period * eighths / 8));
    }
    for (int i = 0; i < count; ++i) {
        const mpfr part = (mpfr(engine()) / mpfr(std::numeric_limits<std::uint64_t>::max()) * 2 - 1) * period;
        times.push_back(narrow<T>(part * (i % 3 == 0 ? 1 : i % 3 == 1 ? 1000 : 1'000'000'000)));
    }
    std::shuffle(times.begin(), times.end(), engine);
    return times;
}

template <class T>
exact exact_of(const T& x) {
    rational q;
    mpfr_get_q(q.backend().data(), handle(widen(x)));
    return exactly(q);
}

// |actual - truth| in units of the last place of max(1, |size|).
template <class T>
double units_off(const T& actual, const ball& truth, const mpfr& size) {
    const mpfr least = abs(size) < 1 ? mpfr(1) : mpfr(abs(size));
    const mpfr unit = ldexp(widen(epsilon<T>()), static_cast<int>(binary_exponent(least)) - 1);
    return static_cast<double>(mpfr((abs(widen(actual) - midpoint_of(truth)) + midpoint_of(radius_of(truth))) / unit));
}

template <class T>
struct named_arrays {
    std::string instructions;
    std::vector<T> theta;
    std::vector<T> omega;
};

// In double once with each available set of vector instructions.
template <class T>
std::vector<named_arrays<T>> sampled_arrays(const sampler<T>& sample, const std::vector<T>& times) {
    std::vector<named_arrays<T>> all;
    const auto add = [&](const std::string& instructions) {
        named_arrays<T>& of = all.emplace_back(named_arrays<T>{instructions, times, times});
        sample(times, of.theta, of.omega);
    };
    add("the best instructions");
    if constexpr (std::same_as<T, double>) {
        for (const std::string& instructions : vector_instructions()) {
            const vector_instructions_scope by(instructions);
            add(instructions);
        }
    }
    return all;
}

// sqrt(2E), in the units of the motion.
mpfr largest_speed(const motion& m) { return sqrt(mpfr(energies<mpfr>(m).energy * 2)) / time_unit<mpfr>(m); }

}  // namespace

TEMPLATE_LIST_TEST_CASE("the sampler is within 4 units of proved values at every energy", "[pendulum][sampler]",
                        fixed_scalars) {
    // The bound of the header. The worst of 4 10^6 values at random energies in double: theta 2.44, omega 1.48.
    using T = TestType;
    const precision_scope scope(proof_digits);
    for (const named_motion& named : all_motions()) {
        const motion& m = named.m;
        const std::vector<T> times = shuffled_times<T>(m, std::same_as<T, double> ? 150 : 12);
        const sampler<T> sample(m);
        const std::vector<named_arrays<T>> arrays = sampled_arrays(sample, times);
        const proved_motion proved(m);
        const mpfr speed = largest_speed(m);
        for (std::size_t i = 0; i < times.size(); ++i) {
            INFO(named.name << " at " << times[i]);
            const auto truth = proved.at(exact_of(times[i]));
            REQUIRE(certainly_less(radius_of(truth.theta), ldexp(abs(truth.theta) + 1, -150)));
            for (const named_arrays<T>& of : arrays) {
                INFO(of.instructions);
                CHECK(units_off(of.theta[i], truth.theta, midpoint_of(truth.theta)) <= 4);
                CHECK(units_off(of.omega[i], truth.omega, speed) <= 4);
            }
            const jet<T> alone = sample(times[i]);
            CHECK(units_off(alone.value, truth.theta, midpoint_of(truth.theta)) <= 4);
            CHECK(units_off(alone.slope, truth.omega, speed) <= 4);
        }
    }
}

TEST_CASE("the sampler is within 4 units of proved values at random energies", "[pendulum][sampler]") {
    std::mt19937_64 engine(5);
    const auto below = [&engine](long n) { return static_cast<long>(engine() % static_cast<unsigned long>(n)); };
    const precision_scope scope(proof_digits);
    for (int i = 0; i < 120; ++i) {
        const rational part(1 + below(99'999), 100'000);
        const rational size = part * power_of(10, -below(i % 4 == 0 ? 100 : 8));
        const rational energy = i % 4 == 1   ? part * 2
                                : i % 4 == 2 ? 2 + part * power_of(10, below(12))
                                             : 2 + size * (below(2) == 0 ? 1 : -1);
        const motion m = motion::of_energy(energy, below(2) == 0 ? 1 : -1);
        const std::vector<double> times = shuffled_times<double>(m, 50);
        std::vector<double> theta(times.size());
        std::vector<double> omega(times.size());
        sampler<double>{m}(times, theta, omega);
        const proved_motion proved(m);
        for (std::size_t k = 0; k < times.size(); ++k) {
            INFO("E - 2 = " << rational(energy - 2) << " at " << times[k]);
            const auto truth = proved.at(exact_of(times[k]));
            CHECK(units_off(theta[k], truth.theta, midpoint_of(truth.theta)) <= 4);
            CHECK(units_off(omega[k], truth.omega, largest_speed(m)) <= 4);
        }
    }
}

TEST_CASE("the sampler reduces times beyond its clock in mpfr", "[pendulum][sampler]") {
    const precision_scope scope(800);
    for (const named_motion& named : all_motions()) {
        std::vector<double> times{1e18, 0.5, -1e15};
        // Otherwise omega = e^-t would leave even the range of mpfr, or theta that of double.
        if (has_passages(named.m) && named.name != "E = 1e300") {
            times.insert(times.end(), {1e300, -1e200});
        }
        std::vector<double> theta(times.size());
        std::vector<double> omega(times.size());
        sampler<double>{named.m}(times, theta, omega);
        const proved_motion proved(named.m);
        for (std::size_t i = 0; i < times.size(); ++i) {
            INFO(named.name << " at " << times[i]);
            const auto truth = proved.at(exact_of(times[i]));
            CHECK(units_off(theta[i], truth.theta, midpoint_of(truth.theta)) <= 4);
            CHECK(units_off(omega[i], truth.omega, largest_speed(named.m)) <= 4);
        }
    }
}

TEST_CASE("every number of times is sampled, in place too", "[pendulum][sampler]") {
    const motion m = with_energy("1.71");
    const sampler<double> sample(m);
    std::vector<double> times;
    for (int count = 0; count <= 70; ++count) {
        INFO(count << " times");
        std::vector<double> theta(times.size() + 1, 99);
        std::vector<double> omega = times;
        omega.push_back(99);
        sample(std::span(omega).first(times.size()), std::span(theta).first(times.size()),
               std::span(omega).first(times.size()));
        CHECK(theta.back() == 99);
        CHECK(omega.back() == 99);
        for (std::size_t i = 0; i < times.size(); ++i) {
            // Another block of the same times may fuse other operations: 4 units on either side.
            const jet<double> alone = sample(times[i]);
            CHECK_THAT(theta[i], near(alone.value, 8, 2.0));
            CHECK_THAT(omega[i], near(alone.slope, 8, 2.0));
        }
        times.push_back(0.37 * count * (count % 2 == 0 ? 1 : -1));
    }
}

TEST_CASE("two threads may ask one sampler", "[pendulum][sampler]") {
    const motion m = with_state("2.5", "-0.3");
    const sampler<double> sample(m);
    const std::vector<double> times = [&] {
        const precision_scope scope(40);
        auto result = shuffled_times<double>(m, 1000);
        result.push_back(1e20);
        return result;
    }();
    std::vector<double> theta(times.size());
    std::vector<double> omega(times.size());
    sample(times, theta, omega);
    std::vector<std::thread> threads;
    threads.reserve(2);
    std::vector<int> same(2);
    for (std::size_t which = 0; which < 2; ++which) {
        threads.emplace_back([&, which] {
            std::vector<double> angle(times.size());
            std::vector<double> speed(times.size());
            sample(times, angle, speed);
            same[which] = angle == theta && speed == omega ? 1 : 0;
            mpfr_free_cache();
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    CHECK(same == std::vector<int>{1, 1});
}

TEST_CASE("the sampler refuses what it cannot sample", "[pendulum][sampler]") {
    const sampler<double> sample(with_energy("1.71"));
    std::vector<double> three(3);
    std::vector<double> two(2);
    CHECK_THROWS_AS(sample(three, two, three), libration::error);
    CHECK_THROWS_AS(sample(three, three, two), libration::error);
    CHECK_THROWS_AS(sample(two, three, three), libration::error);
    CHECK_NOTHROW(sample({}, {}, {}));
    for (const std::string energy : {"0", "1.71", "2", "3"}) {
        const sampler<double> other(with_energy(energy));
        CHECK_THROWS_AS(other(std::numeric_limits<double>::infinity()), libration::error);
        CHECK_THROWS_AS(other(std::numeric_limits<double>::quiet_NaN()), libration::error);
        std::vector<double> times(20);
        times[17] = -std::numeric_limits<double>::infinity();
        std::vector<double> theta(20);
        CHECK_THROWS_AS(other(times, theta, theta), libration::error);
    }
    CHECK_THROWS_AS(sampler<double>(with_energy("1e308")), libration::error);
    CHECK_THROWS_AS(sampler<double>(with_energy("1e300"))(1e300), libration::error);
    CHECK_THROWS_AS(sampler<double>(with_gap("1e-5000")), libration::error);
}

TEST_CASE("a motion has fewer than 110 panels", "[pendulum][sampler]") {
    const precision_scope scope(40);
    CHECK(half_cycle_panels<double>(with_gap("1e-300")).size() == half_cycle_panels<double>(with_energy("2")).size());
    CHECK(half_cycle_panels<double>(with_energy("2")).size() < 110);
    CHECK(half_cycle_panels<double>(with_energy("0")).size() == 1);
    for (const std::string energy : {"1e-300", "1e-10", "1", "3", "1e10", "1e100"}) {
        INFO("E = " << energy);
        // Far from E = 2 the path to the top takes at most 2 units of pi/2.
        CHECK(half_cycle_panels<double>(with_energy(energy)).size() <= 40);
    }
}

}  // namespace pendulum_sampler_test
