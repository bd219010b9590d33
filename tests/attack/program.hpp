// The program beside this one, for statements that the command alone makes.
#pragma once

#include <string>
#include <vector>

namespace libration::attack {

/// Standard output of a command line, one entry per line; of one that fails the message alone.
struct program_answer {
    bool done = false;
    std::vector<std::string> lines;
    std::string message;
};

/// Runs "libration ...", the program in the folder of this one. Throws std::runtime_error where it cannot be started.
program_answer answer_of(const std::string& command);

/// The cells of a line of CSV, of which none before the one asked is quoted.
std::string cell_of(const std::string& line, std::size_t column);

}  // namespace libration::attack
