// The tape of any equation compared with hand-written recurrences, 100 coefficients in mpfr of 50 digits; then
// solutions to an end time compared with Boost.odeint, GSL and mpmath. Each of the others gets the largest tolerance
// 10^-k with which it attains the requested error, 1e-25 in mpfr of 50 digits and 1e-13 in double, relative to the
// largest component at the end, against a value with more digits from two integrations that agree; Libration the least
// step accuracy, 2^-k, that does. The attained errors are printed next to the times. GSL, which may not be linked here,
// and mpmath time themselves in separate programs. Exits with status 1 if a side does not attain its error. Libration
// uses the tape, in double with several equal operations in vector lanes if a right-hand side repeats them often
// enough.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "equation_peers.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/fast_product.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/pendulum/pendulum.hpp"
#include "libration/query/trajectory.hpp"
#include "peer_integration.hpp"
#include "ratio_table.hpp"
#include "rounds.hpp"

namespace {

using namespace libration;
using bench::ask_peer;
using bench::least_tolerance;
using bench::value_of;
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

constexpr int digits_of_truth = 60;

// A problem with its solution at the end.
struct solved_problem {
    bench::initial_value_problem problem;
    ode::explicit_system system;
    std::vector<std::size_t> places;  // of the state x, x', y, ... in the order of the system
    std::vector<mpfr> truth;          // in the order of the state
    mpfr largest;

    // In the order of the state.
    template <class T>
    std::vector<T> flat(const ode::solution_state<T>& state) const {
        std::vector<T> values(places.size());
        std::size_t next = 0;
        for (const auto& of_unknown : state) {
            for (const T& value : of_unknown) {
                values[places[next++]] = value;
            }
        }
        return values;
    }

    template <class T>
    mpfr error_of(const std::vector<T>& values) const {
        const precision_scope scope(digits_of_truth);
        mpfr worst(0);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            worst = std::max(worst, mpfr(abs(mpfr(widen(values[i]) - truth[i])) / largest));
        }
        return worst;
    }
};

solved_problem solve(const bench::initial_value_problem& problem) {
    const precision_scope scope(digits_of_truth);
    solved_problem result{problem, ode::explicit_system(ode::parse(problem.text())), {}, {}, mpfr(0)};
    const auto derivatives = static_cast<std::size_t>(problem.order);
    for (const auto& each : result.system.unknowns()) {
        const auto found = std::find(problem.unknowns.begin(), problem.unknowns.end(), each.name);
        for (std::size_t j = 0; j < derivatives; ++j) {
            result.places.push_back(static_cast<std::size_t>(found - problem.unknowns.begin()) * derivatives + j);
        }
    }
    const ode::number end = as_exact_real(read_exact(problem.end));
    result.truth = result.flat(ode::trajectory(result.system, {end}, digits_of_truth).front());
    for (const mpfr& each : result.truth) {
        result.largest = std::max(result.largest, mpfr(abs(each)));
    }
    return result;
}

// Adds a method of integration to the end time, whose error must be at most the requested one.
void add(std::vector<bench::contender>& all, const std::string& name, std::function<double()> pass, const mpfr& error,
         const mpfr& asked) {
    if (!(error <= asked)) {
        throw std::runtime_error(name + " is off by " + to_decimal(error, 3));
    }
    all.push_back({name, std::move(pass), to_decimal(error, 2)});
}

// In steps of accuracy 2^-bits. The tape and the arrays are constructed once, and each pass starts over; with `anew` a
// pass constructs them too.
template <class T>
void add_ours(std::vector<bench::contender>& all, const std::string& name, const solved_problem& of, const mpfr& asked,
              int first, int last, bool anew) {
    const T end = value_of<T>(of.problem.end);
    const auto marching = [&of](int bits) {
        return std::make_shared<ode::taylor_march<T>>(of.system, ode::step_accuracy::of<T>(bits));
    };
    const auto error = [&](int bits) { return of.error_of(of.flat(marching(bits)->advance_to(end))); };
    const int bits = least_tolerance(first, last, asked, error);
    auto pass = bench::timed(1, [march = marching(bits), marching, bits, end, anew] {
        if (anew) {
            benchmark::DoNotOptimize(marching(bits)->advance_to(end));
        } else {
            march->advance_to(T(0));
            benchmark::DoNotOptimize(march->advance_to(end));
        }
    });
    add(all, fmt::format("{}, 2^-{}", name, bits), std::move(pass), error(bits), asked);
}

template <class T>
void add_odeint(std::vector<bench::contender>& all, const solved_problem& of, const mpfr& asked, int first, int last) {
    const auto tolerance = [](int k) { return value_of<T>("1e-" + std::to_string(k)); };
    const auto solved = [&of](const T& at) {
        std::vector<T> x;
        for (const std::string& each : of.problem.start) {
            x.push_back(value_of<T>(each));
        }
        return bench::by_odeint<T>(of.problem, x, at);
    };
    const int k = least_tolerance(first, last, asked, [&](int i) { return of.error_of(solved(tolerance(i))); });
    const mpfr error = of.error_of(solved(tolerance(k)));
    auto pass = bench::timed(1, [solved, at = tolerance(k)] { benchmark::DoNotOptimize(solved(at)); });
    add(all, fmt::format("Boost.odeint RKF78, tolerance 1e-{}", k), std::move(pass), error, asked);
}

#ifdef LIBRATION_GSL_EQUATIONS
void add_gsl(std::vector<bench::contender>& all, const solved_problem& of, const mpfr& asked, int first, int last) {
    const auto ask = [&of](int k, int passes) {
        std::string input =
            fmt::format("{} 1e-{} {} {} {} 1\n", of.problem.name, k, passes, of.problem.end, of.problem.start.size());
        for (const std::string& each : of.problem.start) {
            input += each + "\n";
        }
        return ask_peer<double>(LIBRATION_GSL_EQUATIONS, input, of.problem.start.size());
    };
    const int k = least_tolerance(first, last, asked, [&](int i) { return of.error_of(ask(i, 1).values); });
    add(
        all, fmt::format("GSL rk8pd, tolerance 1e-{}", k), [ask, k] { return ask(k, 20).nanoseconds; },
        of.error_of(ask(k, 1).values), asked);
}
#endif

// Skipped if Python or mpmath is missing.
void add_mpmath(std::vector<bench::contender>& all, const solved_problem& of, const mpfr& asked) {
    constexpr int digits = 27;
    std::string input = fmt::format("{} {} {} {}\n", of.problem.name, digits, of.problem.end, of.problem.start.size());
    for (const std::string& each : of.problem.start) {
        input += each + "\n";
    }
    try {
        const auto found = ask_peer<mpfr>(LIBRATION_MPMATH_EQUATIONS, input, of.problem.start.size());
        add(
            all, fmt::format("mpmath odefun, {} digits, once", digits), [ns = found.nanoseconds] { return ns; },
            of.error_of(found.values), asked);
    } catch (const std::runtime_error& problem) {
        fmt::print("(mpmath: {})\n", problem.what());
    }
}

void compare_in_mpfr(const solved_problem& of) {
    const precision_scope scope(50);
    const mpfr asked = pow(mpfr(10), -25);
    std::vector<bench::contender> all;
    add_ours<mpfr>(all, "libration taylor_march<mpfr>", of, asked, 82, 120, false);
    add_odeint<mpfr>(all, of, asked, 24, 32);
    add_mpmath(all, of, asked);
    bench::run_rounds(all, 3);
    bench::print_ratios(
        fmt::format("{} to t = {}, mpfr of 50 digits, error at most 1e-25", of.problem.name, of.problem.end), "error",
        all);
}

void compare_in_double(const solved_problem& of) {
    const mpfr asked = pow(mpfr(10), -13);
    std::vector<bench::contender> all;
    add_ours<double>(all, "libration taylor_march<double>", of, asked, 42, 53, false);
    add_ours<double>(all, "the same with its tape", of, asked, 42, 53, true);
    add_odeint<double>(all, of, asked, 11, 18);
#ifdef LIBRATION_GSL_EQUATIONS
    add_gsl(all, of, asked, 11, 18);
#else
    fmt::print("(GSL was not found when this was configured)\n");
#endif
    bench::run_rounds(all, 15);
    bench::print_ratios(fmt::format("{} to t = {}, double, error at most 1e-13", of.problem.name, of.problem.end),
                        "error", all);
}

}  // namespace

int main(int count, char** words) {
    return libration::bench::exit_code_of("equations", [&] {
        benchmark::Initialize(&count, words);
        if (benchmark::ReportUnrecognizedArguments(count, words)) {
            return 2;
        }
        benchmark::RunSpecifiedBenchmarks();
        for (const auto& each : libration::bench::problems_with_peers()) {
            const solved_problem solved = solve(each);
            compare_in_double(solved);
            compare_in_mpfr(solved);
        }
        return 0;
    });
}
