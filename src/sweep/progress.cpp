#include "sweep/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace libration {

progress::progress(std::string what, std::size_t steps)
    : what_(std::move(what)), steps_(steps), watched_(::isatty(STDERR_FILENO) != 0) {}

progress::~progress() {
    if (shown_) {
        fmt::print(stderr, "\r\033[K");
        std::fflush(stderr);
    }
}

void progress::step() {
    const std::lock_guard lock(mutex_);
    ++done_;
    const auto now = std::chrono::steady_clock::now();
    if (watched_ && (done_ == steps_ || now - last_shown_ > std::chrono::milliseconds(100))) {
        last_shown_ = now;
        show();
    }
}

void progress::show() {
    shown_ = true;
    const double elapsed = std::chrono::duration<double>(last_shown_ - start_).count();
    const double left = elapsed / static_cast<double>(done_) * static_cast<double>(steps_ - done_);
    fmt::print(stderr, "\r\033[K{}: {} of {}, about {:.0f} s left", what_, done_, steps_, left);
    std::fflush(stderr);
}

}  // namespace libration
