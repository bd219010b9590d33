#include "run/child_program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace libration {

namespace {

using open_file = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A file without a name. Unlike a pipe it holds any amount before the other side reads.
open_file nameless_file() {
    open_file made(std::tmpfile(), &std::fclose);
    if (!made) {
        throw std::runtime_error("cannot make a temporary file");
    }
    return made;
}

std::string output_of(std::FILE* from) {
    std::string content;
    std::array<char, 4096> block{};
    std::rewind(from);
    for (std::size_t count = 1; count > 0;) {
        count = std::fread(block.data(), 1, block.size(), from);
        content.append(block.data(), count);
    }
    return content;
}

// Starts a program by its path, or by its name as a shell finds it, and waits: its exit code, 127 where there is none.
// Files that are there become its stdin and stdout.
int code_of_program(const std::vector<std::string>& words, std::FILE* in, std::FILE* out) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        // Who started us may ignore it; its pipes would complain of readers that have seen enough.
        ::signal(SIGPIPE, SIG_DFL);
        const bool connected = (in == nullptr || ::dup2(::fileno(in), STDIN_FILENO) >= 0) &&
                               (out == nullptr || ::dup2(::fileno(out), STDOUT_FILENO) >= 0);
        if (connected) {
            ::execvp(arguments.front(), arguments.data());
        }
        ::_exit(127);
    }
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child) {
        throw std::runtime_error("cannot start " + words.front());
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

int run_program(const std::vector<std::string>& words) { return code_of_program(words, nullptr, nullptr); }

program_result result_of_program(const std::vector<std::string>& words) {
    const open_file out = nameless_file();
    const int code = code_of_program(words, nullptr, out.get());
    return {code, output_of(out.get())};
}

std::string output_of_program(const std::string& path, const std::string& input) {
    const open_file in = nameless_file();
    const open_file out = nameless_file();
    if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0) {
        throw std::runtime_error("cannot write a temporary file");
    }
    std::rewind(in.get());
    if (code_of_program({path}, in.get(), out.get()) != 0) {
        throw std::runtime_error(path + " failed");
    }
    return output_of(out.get());
}

}  // namespace libration
