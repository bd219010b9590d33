// Many solutions of one system in double, from 1000 starts near that of the benchmark `equations` to its end time: in
// lock step in the lanes of SIMD vectors, on one thread and on all of them, compared with one after the other by
// taylor_march, with and without vector instructions, by Boost.odeint and by GSL.
//
//   ./run bench batch
//
// Each gets the largest tolerance 10^-k, Libration the least step accuracy 2^-k, with which 40 of the solutions attain an
// error of 1e-12 relative to their largest component at the end, against taylor_march in mpfr of 60 digits. Nanoseconds
// are of CPU time per solution; with several threads, of wall-clock time. GSL, which may not be linked here, times
// itself in a separate program. Exits with status 1 if a side does not attain the error, or if solutions in lock step
// differ in a bit from those one after the other.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "equation_peers.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/taylor/batch_march.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/vector_instructions.hpp"
#include "peer_integration.hpp"
#include "ratio_table.hpp"
#include "rounds.hpp"

namespace {

using namespace libration;
using bench::contender;
using bench::value_of;

constexpr std::size_t solutions = 1000;
constexpr std::size_t compared = 40;
constexpr int rounds = 11;
constexpr long digits_of_truth = 60;

// A problem with many starts, in the order of the system, and some of their ends.
struct many_starts {
    bench::initial_value_problem problem;
    ode::explicit_system system;
    std::vector<std::size_t> places;  // of the state x, x', y, ... in the order of the system
    std::vector<double> starts;
    std::vector<std::vector<mpfr>> truth;
    double end;

    std::size_t size() const { return places.size(); }

    // The start of a solution in the order of the peers, and back.
    std::vector<double> for_peers(std::size_t solution) const {
        std::vector<double> x(size());
        for (std::size_t i = 0; i < size(); ++i) {
            x[places[i]] = starts[solution * size() + i];
        }
        return x;
    }
    std::vector<double> from_peers(const double* x) const {
        std::vector<double> state;
        for (const std::size_t place : places) {
            state.push_back(x[place]);
        }
        return state;
    }

    // The state of a solution as a member of the system.
    template <class T>
    ode::solution_state<T> state_of(std::size_t solution) const {
        ode::solution_state<T> state;
        const double* from = starts.data() + solution * size();
        for (const ode::unknown_function& each : system.unknowns()) {
            state.emplace_back(from, from + each.order);
            from += each.order;
        }
        return state;
    }

    // Those that are compared.
    static std::size_t sample(std::size_t i) { return i * (solutions / compared); }

    // The largest error of the ends of all samples, one after the other.
    mpfr error_of(const std::vector<double>& ends) const {
        const precision_scope scope(digits_of_truth);
        mpfr worst(0);
        for (std::size_t k = 0; k < compared; ++k) {
            mpfr largest(0);
            mpfr error(0);
            for (std::size_t i = 0; i < size(); ++i) {
                largest = std::max(largest, mpfr(abs(truth[k][i])));
                error = std::max(error, mpfr(abs(mpfr(widen(ends[k * size() + i]) - truth[k][i]))));
            }
            worst = std::max(worst, mpfr(error / largest));
        }
        return worst;
    }
};

// The start with each component moved by up to 0.02.
many_starts with_many_starts(const bench::initial_value_problem& problem) {
    const precision_scope scope(digits_of_truth);
    many_starts all{
        problem, ode::explicit_system(ode::parse(problem.text())), {}, {}, {}, value_of<double>(problem.end)};
    const auto derivatives = static_cast<std::size_t>(problem.order);
    for (const auto& each : all.system.unknowns()) {
        const auto found = std::find(problem.unknowns.begin(), problem.unknowns.end(), each.name);
        for (std::size_t j = 0; j < derivatives; ++j) {
            all.places.push_back(static_cast<std::size_t>(found - problem.unknowns.begin()) * derivatives + j);
        }
    }
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> moved(-0.02, 0.02);
    for (std::size_t k = 0; k < solutions; ++k) {
        for (const std::size_t place : all.places) {
            all.starts.push_back(value_of<double>(problem.start[place]) + moved(engine));
        }
    }
    ode::taylor_march<mpfr> exact(all.system);
    for (std::size_t k = 0; k < compared; ++k) {
        exact.begin_at(mpfr(0), all.state_of<mpfr>(many_starts::sample(k)));
        auto& row = all.truth.emplace_back();
        for (const auto& of_unknown : exact.advance_to(value_of<mpfr>(problem.end))) {
            row.insert(row.end(), of_unknown.begin(), of_unknown.end());
        }
    }
    return all;
}

// One after the other; those that are compared, or all.
std::vector<double> ends_alone(const many_starts& of, int bits, bool all) {
    ode::taylor_march<double> march(of.system, ode::step_accuracy::of<double>(bits));
    std::vector<double> ends;
    for (std::size_t k = 0; k < (all ? solutions : compared); ++k) {
        march.begin_at(0, of.state_of<double>(all ? k : many_starts::sample(k)));
        for (const auto& of_unknown : march.advance_to(of.end)) {
            ends.insert(ends.end(), of_unknown.begin(), of_unknown.end());
        }
    }
    return ends;
}

// The solutions first .. last - 1 in lock step.
void march_together(const many_starts& of, int bits, std::size_t first, std::size_t last, std::vector<double>& ends) {
    ode::batch_march march(of.system, ode::step_accuracy::of<double>(bits));
    const std::span<const double> starts(of.starts.data() + first * of.size(), (last - first) * of.size());
    march.run({0, starts, {&of.end, 1}}, {ends.data() + first * of.size(), (last - first) * of.size()});
}

void march_on_threads(const many_starts& of, int bits, std::size_t threads, std::vector<double>& ends) {
    std::vector<std::jthread> running;
    for (std::size_t i = 0; i < threads; ++i) {
        running.emplace_back([&of, bits, i, threads, &ends] {
            march_together(of, bits, solutions * i / threads, solutions * (i + 1) / threads, ends);
        });
    }
}

std::vector<double> sampled(const many_starts& of, const std::vector<double>& ends) {
    std::vector<double> some;
    for (std::size_t k = 0; k < compared; ++k) {
        const auto from = ends.begin() + static_cast<std::ptrdiff_t>(many_starts::sample(k) * of.size());
        some.insert(some.end(), from, from + static_cast<std::ptrdiff_t>(of.size()));
    }
    return some;
}

void add(std::vector<contender>& all, const std::string& name, std::function<double()> pass, const mpfr& error,
         const mpfr& asked) {
    if (!(error <= asked)) {
        throw std::runtime_error(name + " is off by " + to_decimal(error, 3));
    }
    all.push_back({name, std::move(pass), to_decimal(error, 2)});
}

void add_ours(std::vector<contender>& all, const many_starts& of, const mpfr& asked) {
    const int bits =
        bench::least_tolerance(36, 53, asked, [&](int i) { return of.error_of(ends_alone(of, i, false)); });
    const auto ends = std::make_shared<std::vector<double>>(solutions * of.size());
    march_together(of, bits, 0, solutions, *ends);
    if (*ends != ends_alone(of, bits, true)) {
        throw std::runtime_error("solutions in lock step differ from those one after the other");
    }
    const mpfr error = of.error_of(sampled(of, *ends));
    add(all, fmt::format("libration batch_march, 2^-{}", bits),
        bench::timed(solutions, [&of, bits, ends] { march_together(of, bits, 0, solutions, *ends); }), error, asked);
    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    const auto on_the_wall = [&of, bits, threads, ends] {
        const auto begin = std::chrono::steady_clock::now();
        march_on_threads(of, bits, threads, *ends);
        return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() / solutions;
    };
    add(all, fmt::format("the same on {} threads, wall-clock time", threads), on_the_wall, error, asked);
    add(all, "libration taylor_march<double>, one by one",
        bench::timed(solutions, [&of, bits] { benchmark::DoNotOptimize(ends_alone(of, bits, true)); }), error, asked);
    const auto scalar = bench::timed(solutions, [&of, bits] { benchmark::DoNotOptimize(ends_alone(of, bits, true)); });
    const auto without_vectors = [scalar] {
        const vector_instructions_scope scope(vector_instructions().back());
        return scalar();
    };
    add(all, "the same without vector instructions", without_vectors, error, asked);
}

void add_odeint(std::vector<contender>& all, const many_starts& of, const mpfr& asked) {
    const auto solved = [&of](int k, bool whole) {
        const double tolerance = value_of<double>("1e-" + std::to_string(k));
        std::vector<double> ends;
        for (std::size_t i = 0; i < (whole ? solutions : compared); ++i) {
            const auto x = bench::by_odeint(of.problem, of.for_peers(whole ? i : many_starts::sample(i)), tolerance);
            const auto state = of.from_peers(x.data());
            ends.insert(ends.end(), state.begin(), state.end());
        }
        return ends;
    };
    const int k = bench::least_tolerance(10, 18, asked, [&](int i) { return of.error_of(solved(i, false)); });
    add(all, fmt::format("Boost.odeint RKF78, tolerance 1e-{}", k),
        bench::timed(solutions, [solved, k] { benchmark::DoNotOptimize(solved(k, true)); }),
        of.error_of(solved(k, false)), asked);
}

#ifdef LIBRATION_GSL_EQUATIONS
void add_gsl(std::vector<contender>& all, const many_starts& of, const mpfr& asked) {
    const auto ask = [&of](int k, bool whole) {
        const std::size_t count = whole ? solutions : compared;
        std::string input = fmt::format("{} 1e-{} 1 {} {} {}\n", of.problem.name, k, of.problem.end, of.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
            for (const double each : of.for_peers(whole ? i : many_starts::sample(i))) {
                input += fmt::format("{:a}\n", each);
            }
        }
        return bench::ask_peer<double>(LIBRATION_GSL_EQUATIONS, input, count * of.size());
    };
    const auto ends = [&](int k) {
        const auto answer = ask(k, false);
        std::vector<double> all_ends;
        for (std::size_t i = 0; i < compared; ++i) {
            const auto state = of.from_peers(answer.values.data() + i * of.size());
            all_ends.insert(all_ends.end(), state.begin(), state.end());
        }
        return all_ends;
    };
    const int k = bench::least_tolerance(10, 18, asked, [&](int i) { return of.error_of(ends(i)); });
    add(
        all, fmt::format("GSL rk8pd, tolerance 1e-{}", k), [ask, k] { return ask(k, true).nanoseconds / solutions; },
        of.error_of(ends(k)), asked);
}
#endif

void compare(const bench::initial_value_problem& problem) {
    const mpfr asked = pow(mpfr(10), -12);
    const many_starts of = with_many_starts(problem);
    std::vector<contender> all;
    add_ours(all, of, asked);
    add_odeint(all, of, asked);
#ifdef LIBRATION_GSL_EQUATIONS
    add_gsl(all, of, asked);
#else
    fmt::print("(GSL was not found when this was configured)\n");
#endif
    bench::run_rounds(all, rounds);
    bench::print_ratios(
        fmt::format("{} to t = {} from {} starts, double, error at most 1e-12", problem.name, problem.end, solutions),
        "error", all);
}

}  // namespace

int main() {
    return libration::bench::exit_code_of("batch", [] {
        fmt::print("vectors {}\n", libration::vector_instructions().front());
        for (const auto& each : libration::bench::problems_with_peers()) {
            compare(each);
        }
        return 0;
    });
}
