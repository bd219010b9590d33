// Runs another program as a child process. Written by hand, because Boost.Process takes twelve times as long to
// compile.
#pragma once

#include <string>
#include <vector>

namespace libration {

/// Runs a program with these words, the first its name or path, on our own stdin and stdout; its exit code, 127 where
/// it is not found. Throws std::runtime_error where no process can be made.
int run_program(const std::vector<std::string>& words);

/// Runs a program without arguments, gives it `input` as its stdin, and returns its stdout. Throws std::runtime_error
/// when it cannot be started or ends with another code than 0.
std::string output_of_program(const std::string& path, const std::string& input);

/// What a program that has ended printed on stdout, and its exit code, 127 where it is not found.
struct program_result {
    int exit_code;
    std::string out;
};
/// Runs a program with these words as run_program does, but keeps its stdout.
program_result result_of_program(const std::vector<std::string>& words);

}  // namespace libration
