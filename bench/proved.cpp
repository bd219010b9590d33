// Proved trajectories of any equation compared with the same digits unproved, by two integrations in mpfr that agree;
// and other proved results: periodic orbits, an unknown at infinity.
#include <benchmark/benchmark.h>

#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/fast_product.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/known/blasius.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"
#include "libration/query/states.hpp"
#include "libration/query/trajectory.hpp"

namespace {

using namespace libration;

const std::string swing = "x'' = -sin(x); x(0) = 5/2; x'(0) = -3/10";

std::string text_of(const std::string& problem) {
    return problem.find('=') == std::string::npos ? std::string(problem_text(problem)) : problem;
}

void proved(benchmark::State& state, const std::string& problem, int time, long digits) {
    const ode::explicit_system system(ode::parse(text_of(problem)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(ode::proved_trajectory(system, {ode::number(rational(time))}, digits));
    }
}

void two_marches(benchmark::State& state, const std::string& problem, int time, long digits) {
    const ode::explicit_system system(ode::parse(text_of(problem)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            ode::trajectory(system, {ode::number(rational(time))}, digits, ode::fast_product<mpfr>()));
    }
}

// The cost of one enclosure at this many bits, for comparison with other programs.
void march_in_bits(benchmark::State& state, const std::string& problem, int time, long bits) {
    const ode::explicit_system system(ode::parse(text_of(problem)));
    for (auto _ : state) {
        ode::proved_march march(system, bits);
        benchmark::DoNotOptimize(march.at(ode::number(rational(time))));
    }
}

void periodic_orbit(benchmark::State& state, const std::string& problem, long digits) {
    const ode::explicit_system system(ode::parse(text_of(problem)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(ode::proved_periodic_orbit(system, digits));
    }
}

void blasius_at_infinity(benchmark::State& state) {
    const precision_scope scope(state.range(0));
    for (auto _ : state) {
        benchmark::DoNotOptimize(ode::blasius_shear(ball(1)));
    }
}

#define PROVED_AND_NOT(name, problem, time, digits)         \
    BENCHMARK_CAPTURE(proved, name, problem, time, digits); \
    BENCHMARK_CAPTURE(two_marches, name, problem, time, digits)

BENCHMARK_CAPTURE(march_in_bits, lorenz_to_2_in_220_bits, "lorenz", 2, 220);
PROVED_AND_NOT(lorenz_to_2_40_digits, "lorenz", 2, 40);
PROVED_AND_NOT(lorenz_to_20_40_digits, "lorenz", 20, 40);
PROVED_AND_NOT(pendulum_to_100_50_digits, swing, 100, 50);
PROVED_AND_NOT(pendulum_to_10_1000_digits, swing, 10, 1000);
PROVED_AND_NOT(kepler_to_20_50_digits, "kepler", 20, 50);
PROVED_AND_NOT(van_der_pol_to_20_50_digits, "van_der_pol", 20, 50);
BENCHMARK_CAPTURE(periodic_orbit, van_der_pol_100_digits, "van_der_pol", 100);
BENCHMARK(blasius_at_infinity)->Arg(50)->Arg(100);

}  // namespace

BENCHMARK_MAIN();
