// Runs the built program as a user does: in another process, with separate outputs, neither of which is a terminal.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/temporary_folder.hpp"

namespace libration::tests {

/// After so many seconds a program is killed. With the sanitizers it takes several times as long as without.
#ifdef __SANITIZE_ADDRESS__
inline constexpr unsigned time_limit_seconds = 300;
#else
inline constexpr unsigned time_limit_seconds = 60;
#endif

/// The arguments of a command line.
using words = std::vector<std::string>;

inline words operator+(words first, const words& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

/// The result of a finished process.
struct finished_process {
    int exit_code;  ///< 128 + signal if a signal ended it
    std::string out;
    std::string err;
};

/// The arguments after `libration`, for messages of a failed test.
inline std::string command_line(const words& given) {
    std::string line = "libration";
    for (const std::string& word : given) {
        line += " " + word;
    }
    return line;
}

/// Runs `libration WORDS` in a directory and waits at most a minute, after which SIGALRM ends it. Its stdin is `input`;
/// `meanwhile` is called with its process id.
inline finished_process run_libration(const words& given, const std::filesystem::path& folder,
                                      const std::string& input = "/dev/null",
                                      const std::function<void(pid_t)>& meanwhile = {}) {
    const temporary_folder captured;
    const std::string out = (captured.path() / "out").string();
    const std::string err = (captured.path() / "err").string();
    std::string program = LIBRATION_COMMAND;
    words own = given;
    std::vector<char*> arguments{program.data()};
    for (std::string& word : own) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto redirect = [](const char* path, int flags, int descriptor) {
            return ::dup2(::open(path, flags, 0600), descriptor) == descriptor;
        };
        if (redirect(input.c_str(), O_RDONLY, STDIN_FILENO) &&
            redirect(out.c_str(), O_WRONLY | O_CREAT, STDOUT_FILENO) &&
            redirect(err.c_str(), O_WRONLY | O_CREAT, STDERR_FILENO) && ::chdir(folder.c_str()) == 0) {
            ::alarm(time_limit_seconds);
            ::execv(arguments.front(), arguments.data());
        }
        ::_exit(127);
    }
    if (child > 0 && meanwhile) {
        meanwhile(child);
    }
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child) {
        throw std::runtime_error("cannot start " + command_line(given));
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of_file(out), text_of_file(err)};
}

/// The same in a separate directory.
inline finished_process run_libration(const words& given) {
    const temporary_folder folder;
    return run_libration(given, folder.path());
}

/// The output of a command that must succeed without messages; throws std::runtime_error otherwise.
inline std::string output_of(const words& given) {
    const finished_process done = run_libration(given);
    if (done.exit_code != 0 || !done.err.empty()) {
        throw std::runtime_error(command_line(given) + " ended with " + std::to_string(done.exit_code) + ": " +
                                 done.err);
    }
    return done.out;
}

}  // namespace libration::tests
