// Common code of the benchmarks: a reporter of Google Benchmark that stores the CPU time of every repetition, for
// ratios of medians, and functions that start and end a benchmark.
#pragma once

#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace libration::bench {

/// Median and spread (half the distance between the quartiles, relative to the median) of repetitions.
struct typical_time {
    double microseconds;
    double spread;
};

/// Stores times by the name of the benchmark and prints only benchmarks that failed.
class time_keeper : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& /*context*/) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration) {
                const double seconds = run.cpu_accumulated_time / static_cast<double>(run.iterations);
                times_[run.run_name.function_name].push_back(seconds * 1'000'000);
            }
        }
    }

    bool knows(const std::string& name) const { return times_.contains(name); }

    /// Throws std::out_of_range for a benchmark that was not run.
    typical_time of(const std::string& name) const {
        std::vector<double> sorted = times_.at(name);
        std::sort(sorted.begin(), sorted.end());
        const std::size_t count = sorted.size();
        const double median = sorted[count / 2];
        return {median, (sorted[count - 1 - count / 4] - sorted[count / 4]) / (2 * median)};
    }

private:
    std::map<std::string, std::vector<double>> times_;
};

/// The median times `factor`, in microseconds if that is 1, and the spread.
inline std::string shown(const typical_time& time, double factor = 1) {
    return fmt::format("{:.2f} +-{:.0f}%", time.microseconds * factor, time.spread * 100);
}

/// Starts Google Benchmark with the arguments of a command line, the repetitions interleaved at random. False if one of
/// them is not a valid option.
inline bool initialized(std::vector<char*> words) {
    static std::string interleaved = "--benchmark_enable_random_interleaving=true";
    words.insert(words.begin() + 1, interleaved.data());
    int left = static_cast<int>(words.size());
    words.push_back(nullptr);
    benchmark::Initialize(&left, words.data());
    return !benchmark::ReportUnrecognizedArguments(left, words.data());
}

/// The result of run() as the exit code of a program; 1, with the reason on stderr, if it throws.
template <class Run>
int exit_code_of(const char* name, const Run& run) {
    try {
        return run();
    } catch (const std::exception& problem) {
        fmt::print(stderr, "bench {}: {}\n", name, problem.what());
        return 1;
    }
}

}  // namespace libration::bench
