#include "verify/row_target.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* target_remedy = "choose a file in a folder that you may write in";

}  // namespace

row_target::row_target(const std::optional<std::string>& path) : path_(path.value_or("")) {
    if (!path) {
        return;
    }
    namespace fs = std::filesystem;
    std::error_code error;
    if (fs::is_symlink(path_, error)) {
        path_ = fs::weakly_canonical(path_, error).string();
    }
    const bool as_it_is = fs::exists(path_, error) && !fs::is_regular_file(path_, error);
    written_ = as_it_is ? path_ : fmt::format("{}.{}.part", path_, ::getpid());
    errno = 0;
    file_ = std::fopen(written_.c_str(), "wb");
    if (file_ == nullptr) {
        fail();
    }
}

row_target::~row_target() {
    if (file_ != nullptr && file_ != stdout) {
        std::fclose(file_);
        remove_part();
    }
}

void row_target::write(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
        fail();
    }
}

void row_target::finish() {
    if (std::fflush(file_) != 0) {
        fail();
    }
    if (file_ != stdout) {
        std::fclose(file_);
        file_ = nullptr;
        std::error_code error;
        if (written_ != path_) {
            std::filesystem::rename(written_, path_, error);
        }
        if (error) {
            remove_part();
            throw input_error("--out", path_, fmt::format("cannot be written ({})", error.message()), target_remedy);
        }
    }
}

void row_target::fail() const {
    const std::string reason = std::strerror(errno);
    if (path_.empty()) {
        throw std::runtime_error(fmt::format("stdout cannot be written ({})", reason));
    }
    throw input_error("--out", path_, fmt::format("cannot be written ({})", reason), target_remedy);
}

void row_target::remove_part() const {
    std::error_code error;
    if (written_ != path_) {
        std::filesystem::remove(written_, error);
    }
}

}  // namespace libration
