#include "run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace libration {

namespace {

constexpr std::chrono::seconds between_renewals{1};
constexpr std::chrono::minutes between_lines{1};

}  // namespace

progress::progress(std::string what, std::size_t steps, progress_context context)
    : what_(std::move(what)), steps_(steps), context_(std::move(context)), watched_(::isatty(STDERR_FILENO) != 0) {}

progress::progress(std::string what, std::size_t steps, progress_context context, slowest slow)
    : progress(std::move(what), steps, std::move(context)) {
    slow_ = std::move(slow);
    keeper_ = std::jthread([this](const std::stop_token& ended) { keep_showing(ended); });
}

progress::~progress() {
    if (keeper_.joinable()) {
        keeper_.request_stop();
        keeper_.join();
    }
    if (shown_) {
        fmt::print(stderr, "\r\033[K");
        std::fflush(stderr);
    }
}

void progress::keep_showing(const std::stop_token& ended) {
    std::unique_lock lock(mutex_);
    const auto never = [] { return false; };
    while (!ended.stop_requested()) {
        if (watched_) {
            ended_.wait_for(lock, ended, between_renewals, never);
        } else {
            ended_.wait_for(lock, ended, between_lines, never);
        }
        if (ended.stop_requested()) {
            return;
        }
        last_shown_ = std::chrono::steady_clock::now();
        if (watched_) {
            show();
        } else {
            fmt::print(stderr, "libration: {}\n", line());
            std::fflush(stderr);
        }
    }
}

void progress::step(std::size_t count) {
    const std::lock_guard lock(mutex_);
    done_ += count;
    if (context_.whole) {
        context_.whole->reached(context_.part, static_cast<double>(done_) / static_cast<double>(steps_));
    }
    const auto now = std::chrono::steady_clock::now();
    if (watched_ && (done_ == steps_ || now - last_shown_ > std::chrono::milliseconds(100))) {
        last_shown_ = now;
        show();
    }
}

void progress::reached(double time, long bits) { stage(fmt::format("time {:.6g} with {} bits", time, bits)); }

void progress::stage(const std::string& done) {
    const std::lock_guard lock(mutex_);
    reached_ = done;
    const auto now = std::chrono::steady_clock::now();
    if (watched_ && now - last_shown_ > std::chrono::milliseconds(100)) {
        last_shown_ = now;
        show();
    }
}

// "12 % of reference, time 31.4 with 256 bits".
std::string progress::status() {
    const std::lock_guard lock(mutex_);
    const double part = steps_ > 0 ? 100 * static_cast<double>(done_) / static_cast<double>(steps_) : 0;
    return (steps_ > 1 ? fmt::format("{:.3g} % of {}", part, what_) : what_) +
           (reached_.empty() ? "" : ", " + reached_);
}

// "study 3 of 15, error_norm, cells: 120 of 800, 35 a second, about 20 s left; 12 s so far: energy=1.9998".
std::string progress::line() const {
    std::string text = fmt::format("{}{}", context_.before, what_);
    text += steps_ > 1 ? fmt::format(": {} of {}", done_, steps_) : "";
    const double elapsed = std::chrono::duration<double>(last_shown_ - start_).count();
    const double rate = elapsed > 0 ? static_cast<double>(done_) / elapsed : 0;
    if (slow_ && done_ > 0) {
        text += rate >= 1 ? fmt::format(", {:.0f} a second", rate) : fmt::format(", {:.3g} a minute", 60 * rate);
    }
    if (context_.whole) {
        text += fmt::format(", about {:.0f} s left for all", context_.whole->seconds_left());
    } else if (done_ > 0) {
        text += fmt::format(", about {:.0f} s left", static_cast<double>(steps_ - done_) / rate);
    }
    const std::string slow = slow_ ? slow_() : reached_;
    return slow.empty() ? text : text + "; " + slow;
}

void progress::show() {
    shown_ = true;
    fmt::print(stderr, "\r\033[K{}", line());
    std::fflush(stderr);
}

void say_line(const std::string& line) {
    fmt::print(stderr, "{}libration: {}\n", ::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "", line);
    std::fflush(stderr);
}

void progress_of_part::operator()(double part) {
    const auto now = static_cast<std::size_t>(std::clamp(part, 0.0, 1.0) * static_cast<double>(steps));
    if (now > done_) {
        all_.step(now - done_);
        done_ = now;
    }
    if (part < 1) {
        check_time();
    }
}

}  // namespace libration
