// A progress line on stderr if it is a terminal; nothing in a pipe or a log, except for long-running work.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "run/ending_signal.hpp"
#include "run/work_estimate.hpp"

namespace libration {

/// The context that a progress line prints: the larger work that its steps belong to.
struct progress_context {
    std::string before;                    ///< "study 3 of 15, "
    std::shared_ptr<work_estimate> whole;  ///< nullptr for a work by itself
    std::size_t part = 0;                  ///< of the whole
};

/// Counts finished steps of a known number and shows how far and how long still. Safe to call from several threads, and
/// several of a work may be counted at once: they share the line.
class progress {
public:
    /// Returns a description of the slowest current items; empty if there are none.
    using slowest = std::function<std::string()>;

    progress(std::string what, std::size_t steps, progress_context context = {});
    /// For long-running work: with the rate and the slowest items, updated every second on a terminal; in a pipe or a
    /// log one line per minute.
    progress(std::string what, std::size_t steps, progress_context context, slowest slow);
    progress(const progress&) = delete;
    progress& operator=(const progress&) = delete;
    /// Takes the line away again.
    ~progress();

    void step(std::size_t count = 1);
    /// Of an integration: the time reached and the bits of the run, for the line.
    void reached(double time, long bits);
    /// Of other work: what is done, "120 expansion points", for the line.
    void stage(const std::string& done);

private:
    std::string status();
    void show();
    void keep_showing(const std::stop_token& ended);
    std::string line() const;

    std::string what_;
    std::size_t steps_;
    progress_context context_;
    std::size_t done_ = 0;
    bool watched_;
    bool shown_ = false;
    slowest slow_;
    std::string reached_;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point last_shown_ = start_;
    std::condition_variable_any ended_;
    status_source status_{[this] { return status(); }};
    std::jthread keeper_;  // last, so that it ends first
};

/// A separate line on stderr, "libration: ...", which replaces a progress line if one is shown.
void say_line(const std::string& line);

/// One of several works that are shown together, by the part of it that is done. One thread at a time.
class progress_of_part {
public:
    static constexpr std::size_t steps = 1000;

    /// `all` counts `steps` for each of the works.
    explicit progress_of_part(progress& all) : all_(all) {}
    /// A part from 0 to 1; one that is less than before does not count. Throws error if the command is to end
    /// (check_time) before the whole part is done.
    void operator()(double part);
    /// The time reached by an integration, and its bits.
    void reached(double time, long bits) { all_.reached(time, bits); }

private:
    progress& all_;
    std::size_t done_ = 0;
};

}  // namespace libration
