#include "run/working_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace libration {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".drawing.";
constexpr std::array<int, 3> ending_signals{SIGINT, SIGTERM, SIGHUP};

// What is to be taken away when a signal ends the process. Never destroyed: the thread that waits may outlive main.
struct registry {
    std::mutex mutex;
    std::set<std::string> folders;
    std::array<int, 2> pipe{-1, -1};
};

registry& registered() {
    static registry& all = *new registry;
    return all;
}

// A program that is still drawing may put another file there meanwhile.
void take_away(const std::string& folder) {
    std::error_code error;
    for (int attempt = 0; attempt < 100; ++attempt) {
        fs::remove_all(folder, error);
        if (!fs::exists(folder, error)) {
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

// A handler may do next to nothing, so it wakes the thread that waits.
extern "C" void tell_of_signal(int number) {
    const int before = errno;
    const auto byte = static_cast<unsigned char>(number);
    [[maybe_unused]] const auto written = ::write(registered().pipe[1], &byte, 1);
    errno = before;
}

// Takes the folders away and lets the signal do what it does by itself.
void wait_for_signal() {
    unsigned char number = 0;
    while (::read(registered().pipe[0], &number, 1) != 1) {
    }
    const std::lock_guard lock(registered().mutex);
    for (const std::string& folder : registered().folders) {
        take_away(folder);
    }
    ::signal(number, SIG_DFL);
    ::kill(::getpid(), number);
    std::this_thread::sleep_for(std::chrono::seconds(10));  // with the lock held, so that nothing moves any more
}

// A signal that the process was started to ignore (nohup) stays ignored.
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

// The folder's lock; -1 where another process holds it.
int locked(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor);
        return -1;
    }
    return descriptor;
}

void take_away_abandoned(const std::string& parent) {
    std::error_code error;
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(parent, error)) {
        if (entry.path().filename().string().starts_with(prefix)) {
            found.insert(entry.path().string());
        }
    }
    for (const std::string& folder : found) {
        if (const int lock = locked(folder); lock >= 0) {
            fs::remove_all(folder, error);
            ::close(lock);
        }
    }
}

}  // namespace

working_folder::working_folder(const std::string& parent)
    : path_((fs::path(parent) / fmt::format("{}{}", prefix, ::getpid())).string()) {
    take_away_abandoned(parent);
    watch_signals();
    const std::lock_guard guard(registered().mutex);
    std::error_code error;
    if (!fs::create_directory(path_, error)) {
        throw std::runtime_error(fmt::format("{} cannot be made ({})", path_,
                                             error ? error.message() : "this process has one there already"));
    }
    lock_ = locked(path_);
    registered().folders.insert(path_);
}

working_folder::~working_folder() {
    const std::lock_guard guard(registered().mutex);
    take_away(path_);
    registered().folders.erase(path_);
    if (lock_ >= 0) {
        ::close(lock_);
    }
}

std::unique_lock<std::mutex> working_folder::uninterrupted() { return std::unique_lock(registered().mutex); }

}  // namespace libration
