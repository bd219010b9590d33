// The tape of any equation beside recurrences written by hand for one, 100 coefficients in mpfr of 50 digits.
#include <benchmark/benchmark.h>

#include <string>

#include "libration/ode/ball/fast_product.hpp"
#include "libration/ode/ball/taylor_expansion.hpp"
#include "libration/ode/parse.hpp"
#include "libration/pendulum/pendulum.hpp"

namespace {

using namespace libration;
using series::power_series;

constexpr int order = 100;

const std::string blasius_text = "f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 1/3";
const std::string moved_text = "f''' + f*f''/2 = 0; f(0) = 1/5; f'(0) = 1/4; f''(0) = 1/3";
const std::string pendulum_text = "x'' = -sin(x); x(0) = 5/2; x'(0) = -3/10";
const std::string top_text = "x'' = -sin(x); x(0) = 5/2; x'(0) = 0";
const std::string lorenz_text = "x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z; x(0) = 1; y(0) = 0; z(0) = 0";

template <field R>
void by_tape(benchmark::State& state, const std::string& text, int to_order) {
    const precision_scope scope(50);
    const ode::explicit_system system(ode::parse(text));
    const ode::tape tape = ode::tape::about_start(system);
    ode::taylor_expansion<R> expansion(tape, to_order);
    for (auto _ : state) {
        expansion.about_start();
        benchmark::DoNotOptimize(expansion.coefficients(0));
    }
}

// c_k of f = sum c_k t^(3k+2): 2 (3k+2)(3k+1) 3k c_k = -sum (3i+2)(3i+1) c_i c_{k-1-i}.
void blasius_by_hand(benchmark::State& state) {
    const precision_scope scope(50);
    for (auto _ : state) {
        power_series<mpfr> c(std::vector<mpfr>{mpfr(mpfr(1) / 6)});
        power_series<mpfr> second(std::vector<mpfr>{mpfr(c[0] * 2)});
        for (int k = 1; 3 * k + 2 <= order; ++k) {
            const int n = 3 * k + 2;
            c.push_back(-product_coefficient(second, c, k - 1) / 2 / n / (n - 1) / (n - 2));
            second.push_back(c[k] * n * (n - 1));
        }
        benchmark::DoNotOptimize(c.data());
    }
}

// (n+3)(n+2)(n+1) f_{n+3} = -(1/2) sum_k f_k (n-k+2)(n-k+1) f_{n-k+2}.
void moved_blasius_by_hand(benchmark::State& state) {
    const precision_scope scope(50);
    for (auto _ : state) {
        power_series<mpfr> f(std::vector<mpfr>{mpfr(mpfr(1) / 5), mpfr(mpfr(1) / 4), mpfr(mpfr(1) / 6)});
        power_series<mpfr> second(std::vector<mpfr>{mpfr(mpfr(1) / 3)});
        for (int n = 0; n + 3 <= order; ++n) {
            const mpfr third = -product_coefficient(f, second, n) / 2;
            second.push_back(third / (n + 1));
            f.push_back(second[n + 1] / ((n + 3) * (n + 2)));
        }
        benchmark::DoNotOptimize(f.data());
    }
}

void pendulum_by_hand(benchmark::State& state, series::parity of_theta) {
    const precision_scope scope(50);
    const mpfr theta = mpfr(5) / 2;
    const mpfr omega = of_theta == series::parity::even ? mpfr(0) : mpfr(mpfr(-3) / 10);
    const mpfr s = sin(mpfr(theta / 2));
    const mpfr c = cos(mpfr(theta / 2));
    const mpfr kinetic = omega * omega / 2;
    for (auto _ : state) {
        const auto a = pendulum::taylor_by_sine_cosine<mpfr>(
            {{theta, omega, s, c}, {mpfr(s * s * 2 + kinetic), mpfr(c * c * 2 - kinetic)}, of_theta}, order, mpfr(1));
        benchmark::DoNotOptimize(a.data());
    }
}

// At 1000 digits, term by term and by fast products of whole sequences.
template <field R>
void long_series(benchmark::State& state, const std::string& text, const series::block_product<R>* fast) {
    const precision_scope scope(1000);
    const ode::explicit_system system(ode::parse(text));
    const ode::tape tape = ode::tape::about_start(system);
    ode::taylor_expansion<R> expansion(tape, static_cast<int>(state.range(0)), fast);
    for (auto _ : state) {
        expansion.about_start();
        benchmark::DoNotOptimize(expansion.coefficients(0));
    }
}

void terms_in_balls(benchmark::State& state, const std::string& text) { long_series<ball>(state, text, nullptr); }
void blocks_in_balls(benchmark::State& state, const std::string& text) {
    long_series<ball>(state, text, ode::fast_product<ball>());
}
void terms_in_mpfr(benchmark::State& state, const std::string& text) { long_series<mpfr>(state, text, nullptr); }
void blocks_in_mpfr(benchmark::State& state, const std::string& text) {
    long_series<mpfr>(state, text, ode::fast_product<mpfr>());
}

void tape_in_mpfr(benchmark::State& state, const std::string& text, int to) { by_tape<mpfr>(state, text, to); }
void tape_in_balls(benchmark::State& state, const std::string& text, int to) { by_tape<ball>(state, text, to); }
void tape_in_double(benchmark::State& state, const std::string& text, int to) { by_tape<double>(state, text, to); }

BENCHMARK_CAPTURE(tape_in_mpfr, blasius_from_the_wall, blasius_text, order);
BENCHMARK(blasius_by_hand);
BENCHMARK_CAPTURE(tape_in_mpfr, blasius_elsewhere, moved_text, order);
BENCHMARK(moved_blasius_by_hand);
BENCHMARK_CAPTURE(tape_in_mpfr, pendulum, pendulum_text, order);
BENCHMARK_CAPTURE(pendulum_by_hand, any, series::parity::any);
BENCHMARK_CAPTURE(tape_in_mpfr, pendulum_from_the_top, top_text, order);
BENCHMARK_CAPTURE(pendulum_by_hand, even, series::parity::even);
BENCHMARK_CAPTURE(tape_in_balls, lorenz_1000_balls, lorenz_text, 1000);
BENCHMARK_CAPTURE(tape_in_mpfr, lorenz_1000, lorenz_text, 1000);
BENCHMARK_CAPTURE(tape_in_double, lorenz_30_double, lorenz_text, 30);
BENCHMARK_CAPTURE(terms_in_balls, lorenz_1000_digits, lorenz_text)->Arg(1000)->Arg(4000);
BENCHMARK_CAPTURE(blocks_in_balls, lorenz_1000_digits, lorenz_text)->Arg(1000)->Arg(4000);
BENCHMARK_CAPTURE(terms_in_balls, blasius_1000_digits, moved_text)->Arg(4000);
BENCHMARK_CAPTURE(blocks_in_balls, blasius_1000_digits, moved_text)->Arg(4000);
BENCHMARK_CAPTURE(terms_in_balls, blasius_from_the_wall_1000_digits, blasius_text)->Arg(4000);
BENCHMARK_CAPTURE(blocks_in_balls, blasius_from_the_wall_1000_digits, blasius_text)->Arg(4000);
BENCHMARK_CAPTURE(terms_in_mpfr, lorenz_1000_digits, lorenz_text)->Arg(1000)->Arg(4000);
BENCHMARK_CAPTURE(blocks_in_mpfr, lorenz_1000_digits, lorenz_text)->Arg(1000)->Arg(4000);

}  // namespace

BENCHMARK_MAIN();
