// A reporter of Google Benchmark that keeps the CPU time of every repetition, for ratios of medians.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
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

/// Keeps times by the name of the benchmark and says nothing itself, but for benchmarks that failed.
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

    /// Throws std::out_of_range for a benchmark that did not run.
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

}  // namespace libration::bench
