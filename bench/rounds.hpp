// Computations that are timed in turns, so that other load of the machine affects all alike, and a table of them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace libration::bench {

/// CPU time of this process.
inline double cpu_nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// One method. pass() computes all outputs and returns nanoseconds per output, as measured by itself if the work is
/// done by another program; error is the error of its values, as defined by the benchmark.
struct contender {
    std::string name;
    std::function<double()> pass;
    std::string error;
    std::vector<double> times{};

    double median() const {
        std::vector<double> sorted = times;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
    /// Half the distance between the quartiles, relative to the median.
    double spread() const {
        std::vector<double> sorted = times;
        std::sort(sorted.begin(), sorted.end());
        const std::size_t count = sorted.size();
        return (sorted[count - 1 - count / 4] - sorted[count / 4]) / (2 * sorted[count / 2]);
    }
};

/// Passes over `outputs` outputs, timed here, repeated for 5 ms, because a single quick one would mostly fetch memory.
template <class Work>
std::function<double()> timed(std::size_t outputs, Work work) {
    return [outputs, work = std::move(work)] {
        const double start = cpu_nanoseconds();
        double passed = 0;
        int passes = 0;
        while (passed < 5e6) {
            work();
            passed = cpu_nanoseconds() - start;
            ++passes;
        }
        return passed / passes / static_cast<double>(outputs);
    };
}

/// Every contender once per round, in varying order.
inline void run_rounds(std::vector<contender>& all, int rounds) {
    std::vector<std::size_t> order(all.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::mt19937 engine(1);
    for (int round = 0; round < rounds; ++round) {
        std::shuffle(order.begin(), order.end(), engine);
        for (const std::size_t i : order) {
            all[i].times.push_back(all[i].pass());
        }
    }
}

/// Medians, spreads, and ratios to the first one.
inline void print_ratios(const std::string& title, const std::string& error, const std::vector<contender>& all) {
    fmt::print("{}\n{:<52} {:>16} {:>9}  {}\n", title, "", "ns an output", "ratio", error);
    for (const contender& each : all) {
        const double median = each.median();
        const int decimals = median < 1000 ? 2 : 0;
        fmt::print("{:<52} {:>16} {:>9.1f}  {}\n", each.name,
                   fmt::format("{:.{}f} +-{:.0f}%", median, decimals, each.spread() * 100),
                   median / all.front().median(), each.error);
    }
    fmt::print("\n");
}

}  // namespace libration::bench
