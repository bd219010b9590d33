#include "run/time_limit.hpp"

#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <mutex>
#include <system_error>
#include <utility>

#include "libration/scalar/error.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"

namespace libration {

namespace {

constexpr int ended_code = 1;
// For a computation that has called check_time(), and for another one.
constexpr std::chrono::seconds between_checks{5};
constexpr std::chrono::milliseconds without_checks{300};

// Never destroyed: the thread that waits for signals may outlive main.
struct limited_command {
    std::mutex mutex;
    std::condition_variable_any changed;
    std::list<std::function<std::string()>> sources;
    std::string subject, value;  ///< of the error: "--timeout", "3"
    bool finished = false;
    std::atomic<bool> ending = false;
    std::atomic<bool> checked = false;
};

limited_command& current() {
    static limited_command& one = *new limited_command;
    return one;
}

// How far the command came, as the end of a line.
std::string status() {
    const std::lock_guard lock(current().mutex);
    const std::string text = current().sources.empty() ? "" : current().sources.back()();
    return text.empty() ? "ended the command before any part of it was finished" : "ended the command at " + text;
}

error ended_error() { return {error_kind::undecided, current().subject, current().value, status()}; }

// Returns if the command ends by itself.
void end_command(std::string subject, std::string value) {
    limited_command& command = current();
    {
        std::unique_lock lock(command.mutex);
        command.subject = std::move(subject);
        command.value = std::move(value);
        command.ending = true;
        const auto wait = command.checked ? std::chrono::milliseconds(between_checks) : without_checks;
        if (command.changed.wait_for(lock, wait, [&] { return command.finished; })) {
            return;
        }
    }
    std::fflush(stdout);
    at_ending_signal::call_all();
    say_line(ended_error().what());
    std::_Exit(ended_code);
}

void end_by_signal() {
    end_command("a signal", "");
    for (;;) {
        ::pause();  // the main thread ends the process
    }
}

}  // namespace

time_limit::time_limit(std::optional<std::chrono::milliseconds> limit, std::string typed, bool signals)
    : typed_(std::move(typed)), signals_(signals) {
    limited_command& command = current();
    command.finished = false;
    command.ending = false;
    command.checked = false;
    if (signals_) {
        try {
            at_ending_signal::set_first(end_by_signal);
        } catch (const std::system_error&) {
            signals_ = false;  // no thread can be started: a signal ends the process as usual
        }
    }
    if (limit) {
        timer_ = std::jthread([this, limit](const std::stop_token& finished) { wait_for_end(finished, *limit); });
    }
}

void time_limit::wait_for_end(const std::stop_token& finished, std::chrono::milliseconds limit) {
    std::unique_lock lock(current().mutex);
    if (!current().changed.wait_for(lock, finished, limit, [] { return current().finished; }) &&
        !finished.stop_requested()) {
        lock.unlock();
        end_command("--timeout", typed_);
    }
}

time_limit::~time_limit() {
    {
        const std::lock_guard lock(current().mutex);
        current().finished = true;
    }
    current().changed.notify_all();
    if (signals_ && !current().ending) {
        at_ending_signal::set_first({});
    }
}

void check_time() {
    current().checked = true;
    if (current().ending) {
        throw ended_error();
    }
}

status_source::status_source(std::function<std::string()> status) {
    const std::lock_guard lock(current().mutex);
    current().sources.push_back(std::move(status));
    place_ = std::prev(current().sources.end());
}

status_source::~status_source() {
    const std::lock_guard lock(current().mutex);
    current().sources.erase(place_);
}

}  // namespace libration
