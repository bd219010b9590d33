#include "run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace libration {

progress::progress(std::string what, std::size_t steps, progress_context context)
    : what_(std::move(what)), steps_(steps), context_(std::move(context)), watched_(::isatty(STDERR_FILENO) != 0) {}

progress::~progress() {
    if (shown_) {
        fmt::print(stderr, "\r\033[K");
        std::fflush(stderr);
    }
}

void progress::step() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (context_.whole) {
        context_.whole->reached(context_.part, static_cast<double>(done_) / static_cast<double>(steps_));
    }
    const auto now = std::chrono::steady_clock::now();
    if (watched_ && (done_ == steps_ || now - last_shown_ > std::chrono::milliseconds(100))) {
        last_shown_ = now;
        show();
    }
}

void progress::show() {
    shown_ = true;
    const std::string far = fmt::format("{}{}: {} of {}", context_.before, what_, done_, steps_);
    if (context_.whole) {
        fmt::print(stderr, "\r\033[K{}, about {:.0f} s left for all", far, context_.whole->seconds_left());
    } else {
        const double elapsed = std::chrono::duration<double>(last_shown_ - start_).count();
        const double left = elapsed / static_cast<double>(done_) * static_cast<double>(steps_ - done_);
        fmt::print(stderr, "\r\033[K{}, about {:.0f} s left", far, left);
    }
    std::fflush(stderr);
}

void say_line(const std::string& line) {
    fmt::print(stderr, "{}libration: {}\n", ::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "", line);
    std::fflush(stderr);
}

}  // namespace libration
