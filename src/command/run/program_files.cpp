#include "run/program_files.hpp"

#include <filesystem>

namespace libration {

namespace fs = std::filesystem;

namespace {

fs::path program_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace

bool runs_from_build_folder() {
    std::error_code error;
    return fs::equivalent(program_folder(), LIBRATION_BUILD_DIR, error);
}

std::string path_from_program(const std::string& relative) {
    return (program_folder() / relative).lexically_normal().string();
}

std::string peer_program(const std::string& name) {
    return path_from_program(runs_from_build_folder() ? name : LIBRATION_INSTALLED_PEERS_DIR "/" + name);
}

}  // namespace libration
