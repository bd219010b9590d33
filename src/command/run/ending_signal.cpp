#include "run/ending_signal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "libration/scalar/error.hpp"
#include "run/progress.hpp"

namespace libration {

namespace {

constexpr std::array<int, 3> ending_signals{SIGINT, SIGTERM, SIGHUP};

// Never destroyed: the thread that waits may outlive main.
struct signal_registry {
    std::mutex mutex;
    std::list<std::function<void()>> actions;
    std::function<void()> first;
    std::array<int, 2> pipe{-1, -1};
};

signal_registry& registered() {
    static signal_registry& all = *new signal_registry;
    return all;
}

// A handler may do next to nothing, so it wakes the thread that waits.
extern "C" void tell_of_signal(int number) {
    const int before = errno;
    const auto byte = static_cast<unsigned char>(number);
    [[maybe_unused]] const auto written = ::write(registered().pipe[1], &byte, 1);
    errno = before;
}

// With the lock held.
void call_actions() {
    const auto& actions = registered().actions;
    std::for_each(actions.rbegin(), actions.rend(), [](const auto& action) { action(); });
}

// Calls the actions and lets the signal do what it does by itself.
void wait_for_signal() {
    unsigned char number = 0;
    while (::read(registered().pipe[0], &number, 1) != 1) {
    }
    std::function<void()> first;
    {
        const std::lock_guard lock(registered().mutex);
        first = registered().first;
    }
    if (first) {
        first();
    }
    const std::lock_guard lock(registered().mutex);
    call_actions();
    ::signal(number, SIG_DFL);
    ::kill(::getpid(), number);
    std::this_thread::sleep_for(std::chrono::seconds(10));  // with the lock held, so that nothing moves any more
}

void watch_signals() {
    static const bool watching = [] {
        if (::pipe2(registered().pipe.data(), O_CLOEXEC) != 0) {
            return false;
        }
        std::thread(wait_for_signal).detach();
        for (const int number : ending_signals) {
            struct sigaction now {};
            if (::sigaction(number, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) {
                now.sa_handler = tell_of_signal;
                now.sa_flags = SA_RESTART;
                ::sigaction(number, &now, nullptr);
            }
        }
        return true;
    }();
    static_cast<void>(watching);
}

}  // namespace

at_ending_signal::at_ending_signal(std::function<void()> done) {
    watch_signals();
    const std::lock_guard guard(registered().mutex);
    registered().actions.push_back(std::move(done));
    place_ = std::prev(registered().actions.end());
}

at_ending_signal::~at_ending_signal() {
    const std::lock_guard guard(registered().mutex);
    registered().actions.erase(place_);
}

void at_ending_signal::set_first(std::function<void()> first) {
    if (first) {
        watch_signals();
    }
    const std::lock_guard guard(registered().mutex);
    registered().first = std::move(first);
}

std::unique_lock<std::mutex> at_ending_signal::uninterrupted() { return std::unique_lock(registered().mutex); }

void at_ending_signal::call_all() noexcept {
    try {
        const std::lock_guard lock(registered().mutex);
        call_actions();
    } catch (const std::exception&) {
        // Memory is short, say: the others are not called.
    }
}

namespace {

constexpr int ended_code = 1;
// Until check_time() is called, by a computation that has called it and prints parts, and by another one; and for the
// output of what is finished by then.
constexpr std::chrono::milliseconds between_checks{5000};
constexpr std::chrono::milliseconds until_check{400};
constexpr std::chrono::seconds for_output{5};

// Never destroyed: the thread that waits for signals may outlive main.
struct limited_command {
    std::mutex mutex;
    std::condition_variable_any changed;
    std::list<std::function<std::string()>> sources;
    std::string subject, value;  ///< of the error: "--timeout", "3"
    bool finished = false;
    std::atomic<bool> ending = false;
    bool prints_parts = true;
    std::atomic<bool> checked = false;      ///< check_time() was called
    std::atomic<bool> ends_itself = false;  ///< it has thrown
};

limited_command& current() {
    static limited_command& one = *new limited_command;
    return one;
}

// How far the command got, as the end of a line; with the lock held.
std::string status() {
    const std::string text = current().sources.empty() ? "" : current().sources.back()();
    return text.empty() ? "ended the command before any part of it was finished" : "ended the command at " + text;
}

error ended_error() {
    const std::lock_guard lock(current().mutex);
    return {error_kind::undecided, current().subject, current().value, status()};
}

// Returns if the command ends by itself: false if it had ended before. Of two reasons the first is stated.
bool end_command(std::string subject, std::string value) {
    limited_command& command = current();
    {
        std::unique_lock lock(command.mutex);
        if (command.finished) {
            return false;
        }
        if (!command.ending) {
            command.subject = std::move(subject);
            command.value = std::move(value);
            command.ending = true;
        }
        const auto finished = [&] { return command.finished; };
        const auto wait = command.checked && command.prints_parts ? between_checks : until_check;
        command.changed.wait_for(lock, wait, [&] { return command.finished || command.ends_itself; });
        if (command.finished || (command.ends_itself && command.changed.wait_for(lock, for_output, finished))) {
            return true;
        }
    }
    std::fflush(stdout);
    at_ending_signal::call_all();
    say_line(ended_error().what());
    std::_Exit(ended_code);
}

void end_by_signal() {
    if (!end_command("a signal", "")) {
        return;  // the signal does what it does by itself
    }
    for (;;) {
        ::pause();  // the main thread ends the process
    }
}

}  // namespace

time_limit::time_limit(std::optional<std::chrono::milliseconds> limit, std::string typed, bool signals,
                       bool prints_parts)
    : typed_(std::move(typed)), signals_(signals) {
    {
        limited_command& command = current();
        const std::lock_guard lock(command.mutex);
        command.finished = false;
        command.ending = false;
        command.ends_itself = false;
        command.checked = false;
        command.prints_parts = prints_parts;
    }
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
        current().ends_itself = true;
        current().changed.notify_all();
        throw ended_error();
    }
}

bool is_ending() { return current().ending; }

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
