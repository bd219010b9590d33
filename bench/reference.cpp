// theta(0.7) at E = 1.71 from the decimal input to the proved digits, compared with Arb's theta functions and with
// Boost.Math. All in one run on one thread, the repetitions interleaved at random; medians with their spread.
//
//   ./run bench reference [--long]      16 to 10^4 digits; --long adds 10^5, there without Boost.Math
//
// Each route uses the fewest guard digits that give the requested digits: a ball of radius below one unit of the last
// digit, for Boost.Math a value that differs from the proved one by less. Exits with 1 if the routes disagree.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "libration/scalar/ball/decimal.hpp"
#include "ratio_table.hpp"
#include "reference_routes.hpp"

namespace {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::bench;

constexpr long most_guard = 60;
constexpr long boost_until = 10'000;

const question& asked() {
    static const question one{"1.71", "0.7"};
    return one;
}

// Guard digits of each route at one number of digits.
struct guards {
    long digits;
    long ours;
    long arb;
    long boost;  // 0: omitted
};

// The least guard digits for which enough() is true.
template <class Enough>
long least_guard(const char* route, long digits, const Enough& enough) {
    for (long guard = 1; guard <= most_guard; ++guard) {
        const precision_scope scope(digits + guard);
        if (enough()) {
            return guard;
        }
    }
    throw std::runtime_error(fmt::format("{} does not reach {} digits with {} more", route, digits, most_guard));
}

// Finds the guard digits, and compares the values. Throws std::runtime_error if they disagree.
guards compared(long digits) {
    guards found{digits, 0, 0, 0};
    found.ours = least_guard("ours", digits, [&] { return to_proved_decimal(by_landen(asked()), digits).has_value(); });
    found.arb =
        least_guard("Arb", digits, [&] { return to_proved_decimal(by_arb_theta(asked()), digits).has_value(); });
    const precision_scope wide(digits + 2 * most_guard);
    const ball proved = by_landen(asked());
    if (!overlaps(proved, by_arb_theta(asked()))) {
        throw std::runtime_error(fmt::format("Libration and Arb's theta functions disagree at {} digits", digits));
    }
    if (digits <= boost_until) {
        const ball unit = pow(ball(10), 1 - digits);  // theta is between 1 and 10
        found.boost = least_guard("Boost.Math", digits, [&] {
            const mpfr theta = by_boost(asked());
            const precision_scope wide_again(digits + 2 * most_guard);
            return certainly_less(abs(ball(theta) - proved), unit);
        });
    }
    return found;
}

std::string name_of(const char* route, long digits) { return fmt::format("{} {}", route, digits); }

// One benchmark: work() in a scope of this many digits.
template <class Work>
void add(const char* route, long digits, long guard, const Work& work) {
    const auto body = [digits, guard, work](benchmark::State& state) {
        const precision_scope scope(digits + guard);
        for (auto step : state) {
            static_cast<void>(step);
            auto result = work();
            benchmark::DoNotOptimize(result);
        }
    };
    const bool slow = digits > boost_until;
    benchmark::RegisterBenchmark(name_of(route, digits).c_str(), body)->Repetitions(slow ? 5 : 21)->MinTime(0.02);
}

void add_all(const guards& with) {
    const long digits = with.digits;
    add("ours", digits, with.ours, [] { return by_landen(asked()); });
    add("arb", digits, with.arb, [] { return by_arb_theta(asked()); });
    if (with.boost != 0) {
        add("boost", digits, with.boost, [] { return by_boost(asked()); });
    }
    // The cost of further times of one energy, and of the conversion to text, which is the same for all.
    const auto state = [digits, guard = with.ours](benchmark::State& loop) {
        const precision_scope scope(digits + guard);
        const exact_question exact(asked());
        const proved_canonical motion(exact.energy, exact.gap);
        const ball theta = motion.theta_at(motion.phase_at(exact.time));
        const bool prints = loop.range(0) == 1;
        for (auto step : loop) {
            static_cast<void>(step);
            if (prints) {
                auto text = to_proved_decimal(theta, digits);
                benchmark::DoNotOptimize(text);
            } else {
                auto again = motion.theta_at(motion.phase_at(exact.time));
                benchmark::DoNotOptimize(again);
            }
        }
    };
    const int repetitions = digits > boost_until ? 5 : 21;
    for (const auto& [route, which] : {std::pair{"next", 0}, std::pair{"print", 1}}) {
        benchmark::RegisterBenchmark(name_of(route, digits).c_str(), state)
            ->Arg(which)
            ->Repetitions(repetitions)
            ->MinTime(0.02);
    }
}

void print_table(const time_keeper& times, const std::vector<guards>& all) {
    fmt::print("theta({}) at E = {}: CPU time in microseconds, median and half the distance of the quartiles\n",
               asked().time, asked().energy);
    fmt::print("{:>6} {:>9} {:>17} {:>17} {:>17} {:>17} {:>17} {:>9} {:>10} {:>14}\n", "digits", "guard", "ours",
               "next time", "Arb theta", "Boost.Math", "printing", "Arb/ours", "Boost/ours", "same, printed");
    for (const guards& at : all) {
        const auto of = [&](const char* route) { return times.of(name_of(route, at.digits)); };
        const double ours = of("ours").microseconds;
        const double printing = of("print").microseconds;
        const bool boost = at.boost != 0;
        fmt::print("{:>6} {:>9} {:>17} {:>17} {:>17} {:>17} {:>17} {:>9.2f} {:>10} {:>14.2f}\n", at.digits,
                   fmt::format("{}/{}/{}", at.ours, at.arb, at.boost), shown(of("ours")), shown(of("next")),
                   shown(of("arb")), boost ? shown(of("boost")) : "-", shown(of("print")),
                   of("arb").microseconds / ours, boost ? fmt::format("{:.2f}", of("boost").microseconds / ours) : "-",
                   (of("arb").microseconds + printing) / (ours + printing));
    }
}

// Removes Libration's option from the arguments for Google Benchmark.
bool take_long(std::vector<char*>& words) { return std::erase(words, std::string("--long")) != 0; }

int run(std::vector<char*> words) {
    std::vector<long> digits{16, 50, 100, 1000, 10'000};
    if (take_long(words)) {
        digits.push_back(100'000);
    }
    if (!initialized(words)) {
        return 2;
    }
    std::vector<guards> all;
    all.reserve(digits.size());
    for (const long each : digits) {
        all.push_back(compared(each));
        add_all(all.back());
    }
    time_keeper times;
    benchmark::RunSpecifiedBenchmarks(&times);
    print_table(times, all);
    return 0;
}

}  // namespace

int main(int count, char** given) {
    return libration::bench::exit_code_of("reference", [&] { return run({given, given + count}); });
}
