// The coefficients of E = 1.71 to order N, compared with the recurrence printed in the paper, (pendseries), in the same
// arithmetic to the same digits: about the top, where every second coefficient vanishes, and about T*/2, where none
// does; in mpfr and on balls, and in double and quad. All in one run on one thread, the repetitions interleaved at
// random; medians with their spread.
//
//   ./run bench coefficients
//
// The printed recurrence is taylor_by_sine_cosine without parity: two full Cauchy products, with fused sums in mpfr,
// which favours it; in mpfr its initial values are given, while Libration begins with the typed energy; in double and
// quad, where computing the initial values is a large part, both begin there. At 1000 digits it is timed up to N = 1000
// and scaled by N^2. Exits with status 1 if the two sides disagree.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "libration/pendulum/expansion.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/quotient.hpp"
#include "ratio_table.hpp"

namespace {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::bench;

constexpr long guard = 20;

struct problem {
    std::string at;
    int order;
    long digits;
    int timed;  // the printed recurrence is timed up to this power
    int asked;  // the target ratio

    std::string name(const char* route) const { return fmt::format("{} {} {} {}", route, at, order, digits); }
};

const std::vector<problem>& problems() {
    static const std::vector<problem> all{
        {"top", 1000, 50, 1000, 10},     {"top", 4000, 50, 4000, 100},    {"top", 4000, 1000, 1000, 10},
        {"top", 16000, 1000, 1000, 100}, {"T/8", 1000, 50, 1000, 10},     {"T/8", 4000, 50, 4000, 100},
        {"T/8", 4000, 1000, 1000, 10},   {"T/8", 16000, 1000, 1000, 100},
    };
    return all;
}

// In a fixed scalar the printed recurrence always runs to the last order.
struct fixed_problem {
    std::string at;
    int order;

    std::string name(const char* route) const { return fmt::format("{} {} {}", route, at, order); }
};

const std::vector<fixed_problem>& fixed_problems() {
    static const std::vector<fixed_problem> all{{"top", 100}, {"top", 400}, {"top", 4000},
                                                {"T/8", 100}, {"T/8", 400}, {"T/8", 4000}};
    return all;
}

motion of_energy() { return motion::of_energy(read_exact("1.71").coefficient); }

template <class T>
expansion<T> ours(const std::string& at, int order) {
    return expand(exact_solution<T>(of_energy()), read_expansion_point(at), order);
}

template <class T>
struct printed_start {
    explicit printed_start(const std::string& at) {
        const exact_solution<T> solution(of_energy());
        const auto point = read_expansion_point(at);
        scale = *radius_about(solution, point);
        start = start_at(solution, phase_of(point, solution));
        start.of_theta = parity::any;
    }

    taylor_start<T> start;
    T scale;
};

template <class T>
power_series<T> printed(const printed_start<T>& from, int order) {
    return taylor_by_sine_cosine(from.start, order, from.scale);
}

// Throws std::runtime_error if the sides differ by 10^-digits of 8/n, or if a ball misses the mpfr value by that.
void compare(const problem& asked) {
    const precision_scope scope(asked.digits + guard);
    const auto found = ours<mpfr>(asked.at, asked.order);
    const auto other = printed(printed_start<mpfr>(asked.at), asked.timed);
    const auto proved = ours<ball>(asked.at, asked.order);
    const mpfr allowed = pow(mpfr(10), static_cast<int>(-asked.digits)) * 8;
    const auto misses = [&](const mpfr& difference, int n) { return abs(difference) * std::max(n, 1) > allowed; };
    for (int n = 0; n <= asked.order; ++n) {
        const bool in_both = n <= asked.timed;
        if ((in_both && misses(found.scaled[n] - other[n], n)) ||
            misses(found.scaled[n] - midpoint_of(proved.scaled[n]), n) ||
            misses(midpoint_of(radius_of(proved.scaled[n])), n)) {
            throw std::runtime_error(fmt::format("the sides disagree about {} at order {}, {} digits, n = {}", asked.at,
                                                 asked.order, asked.digits, n));
        }
    }
}

// Throws std::runtime_error if the sides differ by 4 ulps of the initial value plus one per power, of 8/n.
template <fixed_scalar T>
void compare(const fixed_problem& asked) {
    using std::abs;
    const auto found = ours<T>(asked.at, asked.order);
    const auto other = printed(printed_start<T>(asked.at), asked.order);
    for (int n = 0; n <= asked.order; ++n) {
        if (!(abs(T(found.scaled[n] - other[n])) * std::max(n, 1) <= epsilon<T>() * 8 * (4 + n))) {
            throw std::runtime_error(fmt::format("the sides disagree about {} at order {} in {} bits, n = {}", asked.at,
                                                 asked.order, digits<T>(), n));
        }
    }
}

// One benchmark in a scope of this many digits: prepare() once, work(prepared) in the loop.
template <class Prepare, class Work>
void add(const std::string& name, long digits, int repetitions, const Prepare& prepare, const Work& work) {
    const auto body = [digits, prepare, work](benchmark::State& state) {
        const precision_scope scope(digits + guard);
        const auto prepared = prepare();
        for (auto step : state) {
            static_cast<void>(step);
            auto result = work(prepared);
            benchmark::DoNotOptimize(result);
        }
    };
    benchmark::RegisterBenchmark(name.c_str(), body)->Repetitions(repetitions)->MinTime(0.02);
}

void add_all(const problem& asked) {
    const int repetitions = asked.digits > 100 ? 3 : 7;
    const auto itself = [asked] { return asked; };
    add(asked.name("mpfr"), asked.digits, repetitions, itself,
        [](const problem& p) { return ours<mpfr>(p.at, p.order); });
    add(asked.name("ball"), asked.digits, repetitions, itself,
        [](const problem& p) { return ours<ball>(p.at, p.order); });
    if (asked.timed == asked.order || asked.order == 4000) {
        add(
            asked.name("printed"), asked.digits, 3, [asked] { return printed_start<mpfr>(asked.at); },
            [order = asked.timed](const printed_start<mpfr>& from) { return printed(from, order); });
    }
}

template <fixed_scalar T>
void add_both(const fixed_problem& asked, const char* ours_by, const char* printed_by) {
    const auto itself = [asked] { return asked; };
    add(asked.name(ours_by), 0, 7, itself, [](const fixed_problem& p) { return ours<T>(p.at, p.order); });
    add(asked.name(printed_by), 0, 7, itself,
        [](const fixed_problem& p) { return printed(printed_start<T>(p.at), p.order); });
}

constexpr long far = 1'000'000'000;

void add_single() {
    add(
        "single", 50, 21, [] { return 0; },
        [](int) {
            const exact_solution<ball> solution(of_energy());
            const expansion_point top;
            const ball scale = midpoint(*radius_about(solution, top));
            return to_proved_decimal(coefficients_about(solution, top, scale, far, far).front() / pow(scale, far), 50);
        });
}

constexpr double milliseconds = 1e-3;

void print_table(const time_keeper& times) {
    fmt::print("coefficients at E = 1.71: CPU time in milliseconds, median and half the distance of the quartiles\n");
    fmt::print("{:>4} {:>6} {:>7} {:>18} {:>15} {:>15} {:>13} {:>13} {:>6}\n", "at", "order", "digits", "(pendseries)",
               "mpfr", "ball, proved", "ratio mpfr", "ratio ball", "aim");
    for (const problem& at : problems()) {
        // The timed part is the same for both orders of 1000 digits.
        problem part = at;
        part.order = at.timed == at.order ? at.order : 4000;
        const double times_longer = static_cast<double>(at.order) / at.timed;
        const double scaled = times_longer * times_longer;
        const typical_time slow = times.of(part.name("printed"));
        const typical_time fast = times.of(at.name("mpfr"));
        const typical_time proved = times.of(at.name("ball"));
        fmt::print("{:>4} {:>6} {:>7} {:>18} {:>15} {:>15} {:>13.0f} {:>13.0f} {:>6}\n", at.at, at.order, at.digits,
                   shown(slow, scaled * milliseconds) + (at.timed == at.order ? " " : "*"), shown(fast, milliseconds),
                   shown(proved, milliseconds), slow.microseconds * scaled / fast.microseconds,
                   slow.microseconds * scaled / proved.microseconds, at.asked);
    }
    fmt::print("* timed to N = 1000 and scaled by N^2\n");
    fmt::print("a_n alone, n = 10^9, about the top, from the typed energy to 50 proved digits: {} ms\n",
               shown(times.of("single"), milliseconds));
}

void print_fixed_table(const time_keeper& times) {
    fmt::print("\nthe same in double and quad: CPU time in microseconds\n");
    fmt::print("{:>4} {:>6} {:>18} {:>15} {:>6} {:>18} {:>15} {:>6}\n", "at", "order", "(pendseries)", "double",
               "ratio", "(pendseries)", "quad", "ratio");
    const auto sides = [&](const fixed_problem& of, const char* printed_by, const char* ours_by) {
        const typical_time slow = times.of(of.name(printed_by));
        const typical_time fast = times.of(of.name(ours_by));
        return fmt::format("{:>18} {:>15} {:>6.1f}", shown(slow), shown(fast), slow.microseconds / fast.microseconds);
    };
    for (const fixed_problem& of : fixed_problems()) {
        fmt::print("{:>4} {:>6} {} {}\n", of.at, of.order, sides(of, "printed double", "double"),
                   sides(of, "printed quad", "quad"));
    }
}

int run(const std::vector<char*>& words) {
    if (!initialized(words)) {
        return 2;
    }
    for (const problem& each : problems()) {
        compare(each);
        add_all(each);
    }
    for (const fixed_problem& each : fixed_problems()) {
        compare<double>(each);
        compare<quad>(each);
        add_both<double>(each, "double", "printed double");
        add_both<quad>(each, "quad", "printed quad");
    }
    add_single();
    time_keeper times;
    benchmark::RunSpecifiedBenchmarks(&times);
    print_table(times);
    print_fixed_table(times);
    return 0;
}

}  // namespace

int main(int count, char** given) {
    const libration::whole_quotient_scope by_whole_sequences(libration::quotient_by_flint);
    return libration::bench::exit_code_of("coefficients", [&] { return run({given, given + count}); });
}
