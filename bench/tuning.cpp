// The powers from which the routes of taylor/pole_reach.hpp cost less than the recurrence, measured here: the constants
// of pendulum/tuning.hpp, which affect costs and results only up to rounding.
//
//   ./run bench tuning                                                    the measurements, and the header
//   ./run bench tuning --out include/libration/pendulum/tuning.hpp the header into the tree
//
// All about the top of E = 1.71, where every second coefficient vanishes, in one run on one thread; recurrence and
// other route in turns, medians. A number in the header is the one of a coarse grid (powers of two for the fixed
// scalars) that minimizes the total loss of time over all measurements, so that two runs on one machine seldom differ.
#include <sys/utsname.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "libration/pendulum/expansion.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/ball/quotient.hpp"
#include "ratio_table.hpp"
#include "rounds.hpp"

namespace {

using namespace libration;
using namespace libration::bench;
using namespace libration::pendulum;

constexpr int rounds = 5;

// Sums are correct to a few ulps where the recurrence has lost digits: they may cost a quarter more.
constexpr double worth_of_sums = 1.25;

/// The times of both routes, in nanoseconds, and the size at which they were measured.
struct crossing {
    long power;
    long bits;
    double recurrence;
    double other;
};

template <class Recurrence, class Other>
crossing timed_in_turns(long power, long bits, const Recurrence& recurrence, const Other& other) {
    std::vector<contender> both{{"recurrence", timed(1, recurrence), ""}, {"other", timed(1, other), ""}};
    run_rounds(both, rounds);
    return {power, bits, both.front().median(), both.back().median()};
}

template <scalar T>
struct start {
    start() : solution(motion::of_energy(read_exact("1.71").coefficient)) {}

    series::power_series<T> by_recurrence(int order) const {
        return taylor_coefficients(start_at(solution, phase_of(top, solution)), order, scale);
    }

    exact_solution<T> solution;
    expansion_point top{};
    T scale = midpoint(radius_about(solution, top).value());
};

template <scalar T>
std::vector<crossing> thetas_against_recurrence() {
    std::vector<crossing> all;
    for (const long digits10 : {50L, 200L, 1000L, 3000L}) {
        const precision_scope scope(digits10);
        const start<T> from;
        for (const int order : {64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048}) {
            if (order * digits10 > 800'000) {
                continue;  // decided at smaller orders
            }
            all.push_back(timed_in_turns(
                order, digits<T>(), [&] { from.by_recurrence(order); },
                [&] { taylor_by_thetas(from.solution, from.top, order, from.scale); }));
        }
    }
    return all;
}

/// The powers p .. 3p/2 by sums over the singularities and those before by the recurrence, or all by the recurrence.
template <fixed_scalar T>
std::vector<crossing> sums_against_recurrence() {
    std::vector<crossing> all;
    const start<T> from;
    for (int power = 32; power <= 4096; power *= 2) {
        const int last = power + power / 2;
        all.push_back(timed_in_turns(
            power, digits<T>(), [&] { from.by_recurrence(last); },
            [&] {
                from.by_recurrence(power - 1);
                lattice_coefficients<T>(from.solution.of(), from.top, from.scale, last).between(power, last);
            }));
    }
    return all;
}

/// The loss of a rule "the other route from this size on": the sum of log(time taken/shortest).
template <class Rule>
double loss(const std::vector<crossing>& measured, const Rule& takes_other) {
    double sum = 0;
    for (const crossing& each : measured) {
        const double taken = takes_other(each) ? each.other : each.recurrence;
        sum += std::log(taken / std::min(each.other, each.recurrence));
    }
    return sum;
}

struct theta_rule {
    long power;
    long bits;  // power times bits, from this on
};

theta_rule best_theta_rule(const std::vector<crossing>& measured) {
    theta_rule best{};
    double least = HUGE_VAL;
    for (long power = 64; power <= 512; power += 32) {
        for (long size = 1L << 15; size <= 1L << 20; size += 1L << 15) {
            const double lost =
                loss(measured, [&](const crossing& at) { return at.power >= power && at.power * at.bits >= size; });
            if (lost < least) {
                least = lost;
                best = {power, size};
            }
        }
    }
    return best;
}

long best_sum_rule(std::vector<crossing> measured) {
    for (crossing& each : measured) {
        each.other /= worth_of_sums;
    }
    long best = 0;
    double least = HUGE_VAL;
    for (const crossing& candidate : measured) {
        const double lost = loss(measured, [&](const crossing& at) { return at.power >= candidate.power; });
        if (lost < least) {
            least = lost;
            best = candidate.power;
        }
    }
    return best;
}

void print(std::string_view title, std::string_view other, const std::vector<crossing>& measured) {
    fmt::print("{}\n{:>7} {:>7} {:>16} {:>16} {:>7}\n", title, "power", "bits", "recurrence, us",
               fmt::format("{}, us", other), "ratio");
    for (const crossing& at : measured) {
        fmt::print("{:>7} {:>7} {:>16.1f} {:>16.1f} {:>7.2f}\n", at.power, at.bits, at.recurrence / 1000,
                   at.other / 1000, at.recurrence / at.other);
    }
    fmt::print("\n");
}

std::string machine() {
    utsname system{};
    uname(&system);
    std::ifstream about("/proc/cpuinfo");
    for (std::string line; std::getline(about, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2);
        }
    }
    return static_cast<const char*>(system.machine);
}

struct constants {
    theta_rule on_balls;
    theta_rule in_mpfr;
    long in_double;
    long in_long_double;
    long in_quad;
};

std::string header(const constants& found) {
    return fmt::format(
        "// Made by `./run bench tuning --out include/libration/pendulum/tuning.hpp`: from where on a route "
        "costs less\n// than another, on {}, {:%Y-%m-%d}. Only costs and roundings depend on it.\n"
        "#pragma once\n\n"
        "namespace libration::pendulum::tuning {{\n\n"
        "/// Quotients of thetas instead of the recurrence: from this power on, and from this power times bits on.\n"
        "inline constexpr long thetas_from_power_on_balls = {};\n"
        "inline constexpr long thetas_from_bits_on_balls = {};\n"
        "inline constexpr long thetas_from_power_in_mpfr = {};\n"
        "inline constexpr long thetas_from_bits_in_mpfr = {};\n\n"
        "/// Sums over singularities instead of the recurrence: from this power on.\n"
        "inline constexpr long sums_from_power_in_double = {};\n"
        "inline constexpr long sums_from_power_in_long_double = {};\n"
        "inline constexpr long sums_from_power_in_quad = {};\n\n"
        "}}  // namespace libration::pendulum::tuning\n",
        machine(), fmt::gmtime(std::time(nullptr)), found.on_balls.power, found.on_balls.bits, found.in_mpfr.power,
        found.in_mpfr.bits, found.in_double, found.in_long_double, found.in_quad);
}

/// Writes the whole file or nothing: to a draft in the same directory, then renamed.
void write(const std::filesystem::path& path, const std::string& text) {
    auto draft = path;
    draft += ".draft";
    std::ofstream file(draft, std::ios::binary);
    if (!(file << text << std::flush)) {
        throw std::runtime_error(fmt::format("cannot write {}", draft.string()));
    }
    file.close();
    std::filesystem::rename(draft, path);
}

int run(const std::vector<std::string>& words) {
    if (!words.empty() && (words.size() != 2 || words.front() != "--out")) {
        fmt::print(stderr, "bench tuning: write no argument, or --out FILE\n");
        return 2;
    }
    const auto balls = thetas_against_recurrence<ball>();
    const auto numbers = thetas_against_recurrence<mpfr>();
    print("the coefficients up to a power, on balls", "thetas", balls);
    print("the coefficients up to a power, in mpfr", "thetas", numbers);
    const auto in_double = sums_against_recurrence<double>();
    const auto in_long_double = sums_against_recurrence<long double>();
    const auto in_quad = sums_against_recurrence<quad>();
    print("half as many coefficients again from a power on, in double", "sums", in_double);
    print("half as many coefficients again from a power on, in long double", "sums", in_long_double);
    print("half as many coefficients again from a power on, in quad", "sums", in_quad);
    const std::string text = header({best_theta_rule(balls), best_theta_rule(numbers), best_sum_rule(in_double),
                                     best_sum_rule(in_long_double), best_sum_rule(in_quad)});
    fmt::print("{}", text);
    if (!words.empty()) {
        write(words.back(), text);
    }
    return 0;
}

}  // namespace

int main(int count, char** given) {
    const libration::whole_quotient_scope by_whole_sequences(libration::quotient_by_flint);
    return libration::bench::exit_code_of("tuning", [&] { return run({given + 1, given + count}); });
}
