// Folders to work in: nothing of them stays, whatever ends the process.
#include "run/working_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <string>
#include <vector>

#include "command/temporary_folder.hpp"

namespace run_working_folder_test {

using libration::working_folder;
using libration::tests::temporary_folder;

namespace {

// A child that works in a folder until a signal comes: how it ended.
int status_of_worker_after(int signal, const std::string& parent) {
    const pid_t child = ::fork();
    if (child == 0) {
        const working_folder working(parent);
        std::ofstream(working.path() + "/half.svg") << "<svg>";
        if (signal == 0) {
            ::kill(::getpid(), SIGKILL);
        }
        ::kill(::getpid(), signal);
        ::sleep(20);
        ::_exit(99);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

}  // namespace

TEST_CASE("a working folder goes with its object", "[run]") {
    const temporary_folder parent;
    {
        const working_folder working(parent.path().string());
        std::ofstream(working.path() + "/file") << "x";
        CHECK(parent.content().size() == 2);
    }
    CHECK(parent.content().empty());
}

TEST_CASE("a working folder goes with INT, TERM and HUP, which still end the process", "[run]") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const temporary_folder parent;
        const int status = status_of_worker_after(signal, parent.path().string());
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal);
        CHECK(parent.content().empty());
    }
}

TEST_CASE("what a killed process left is taken away by the next one, and what a living one has is not", "[run]") {
    const temporary_folder parent;
    status_of_worker_after(0, parent.path().string());
    REQUIRE(parent.content().size() == 2);
    std::filesystem::create_directory(parent.path() / ".drawing.1");  // of a version without locks
    const int living = ::open((parent.path() / ".drawing.1").c_str(), O_RDONLY | O_DIRECTORY);
    REQUIRE(::flock(living, LOCK_EX) == 0);
    { const working_folder working(parent.path().string()); }
    CHECK(parent.content() == std::vector<std::string>{".drawing.1"});
    ::close(living);
    { const working_folder working(parent.path().string()); }
    CHECK(parent.content().empty());
}

}  // namespace run_working_folder_test
