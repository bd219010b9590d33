#include "attack/program.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace libration::attack {

program_answer answer_of(const std::string& command) {
    const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    const std::string line = folder.string() + "/" + command + " 2>&1";
    FILE* const pipe = popen(line.c_str(), "r");
    if (pipe == nullptr) {
        throw std::runtime_error("cannot start " + line);
    }
    std::string text;
    std::array<char, 4096> block{};
    while (const std::size_t count = fread(block.data(), 1, block.size(), pipe)) {
        text.append(block.data(), count);
    }
    const int status = pclose(pipe);
    if (!WIFEXITED(status) || WEXITSTATUS(status) > 2) {
        throw std::runtime_error("ended by a signal, or not started: " + command);
    }
    program_answer answer;
    answer.done = WEXITSTATUS(status) == 0;
    if (!answer.done) {
        answer.message = text;
    }
    std::istringstream lines(text);
    for (std::string each; std::getline(lines, each);) {
        if (!each.starts_with("libration: ")) {
            answer.lines.push_back(each);
        }
    }
    return answer;
}

std::string cell_of(const std::string& line, std::size_t column) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; i <= column; ++i) {
        std::getline(cells, cell, ',');
    }
    return cell;
}

}  // namespace libration::attack
