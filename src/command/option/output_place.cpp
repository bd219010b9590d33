#include "option/output_place.hpp"

#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "text/input_error.hpp"

namespace libration {

void require_output_place(const std::string& option, const std::string& path) {
    const std::filesystem::path target(path);
    const auto folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
    std::error_code error;
    if (target.filename().empty() || std::filesystem::is_directory(target, error)) {
        throw input_error(option, path, "is a folder", "name a file");
    }
    if (!std::filesystem::is_directory(folder, error)) {
        throw input_error(option, path, "is in a folder that does not exist", "make the folder first");
    }
    if (::access(folder.c_str(), W_OK) != 0) {
        throw input_error(option, path, "cannot be written", "choose a folder that you may write in");
    }
}

}  // namespace libration
