#include "run/ending_signal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <exception>
#include <thread>
#include <utility>

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

}  // namespace libration
