// The program in the same directory, for statements that only the command makes.
#pragma once

#include <string>
#include <vector>

namespace libration::attack {

/// Standard output of a command line, one entry per line; if it fails, the lines that it printed before that, and all of
/// its output as the message.
struct program_answer {
    bool done = false;
    std::vector<std::string> lines;
    std::string message;
};

/// Runs "libration ...", the program in the same directory. Throws std::runtime_error if it cannot be started.
program_answer answer_of(const std::string& command);

/// The cell of a line of CSV in which no earlier cell is quoted.
std::string cell_of(const std::string& line, std::size_t column);

}  // namespace libration::attack
