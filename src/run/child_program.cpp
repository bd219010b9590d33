#include "run/child_program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
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

std::string content_of(std::FILE* from) {
    std::string content;
    std::array<char, 4096> block{};
    std::rewind(from);
    for (std::size_t count = 1; count > 0;) {
        count = std::fread(block.data(), 1, block.size(), from);
        content.append(block.data(), count);
    }
    return content;
}

}  // namespace

std::string output_of_program(const std::string& path, const std::string& input) {
    const open_file in = nameless_file();
    const open_file out = nameless_file();
    if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0) {
        throw std::runtime_error("cannot write a temporary file");
    }
    std::rewind(in.get());
    std::string program = path;
    const std::array<char*, 2> arguments{program.data(), nullptr};
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        if (::dup2(::fileno(in.get()), STDIN_FILENO) >= 0 && ::dup2(::fileno(out.get()), STDOUT_FILENO) >= 0) {
            ::execv(program.c_str(), arguments.data());
        }
        ::_exit(127);
    }
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child) {
        throw std::runtime_error("cannot start " + path);
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw std::runtime_error(path + " failed");
    }
    return content_of(out.get());
}

}  // namespace libration
