#include "run/working_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace libration {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".drawing.";
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
    at_signal_.emplace([path = path_] { take_away(path); });
    std::error_code error;
    if (!fs::create_directory(path_, error)) {
        throw std::runtime_error(fmt::format("{} cannot be made ({})", path_,
                                             error ? error.message() : "this process has one there already"));
    }
    lock_ = locked(path_);
}

working_folder::~working_folder() {
    take_away(path_);
    at_signal_.reset();
    if (lock_ >= 0) {
        ::close(lock_);
    }
}

}  // namespace libration
