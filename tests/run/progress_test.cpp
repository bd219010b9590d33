#include "run/progress.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "command/temporary_folder.hpp"

namespace sweep_progress_test {

using namespace libration;
using libration::tests::temporary_folder;
using libration::tests::text_of_file;

namespace {

// Sends stderr of this process elsewhere until the end of the scope.
class redirected_stderr {
public:
    explicit redirected_stderr(int descriptor) : before_((std::fflush(stderr), ::dup(STDERR_FILENO))) {
        ::dup2(descriptor, STDERR_FILENO);
    }
    redirected_stderr(const redirected_stderr&) = delete;
    redirected_stderr& operator=(const redirected_stderr&) = delete;
    ~redirected_stderr() {
        std::fflush(stderr);
        ::dup2(before_, STDERR_FILENO);
        ::close(before_);
    }

private:
    int before_;
};

void run_five_steps(int descriptor) {
    const redirected_stderr elsewhere(descriptor);
    progress shown("five", 5);
    for (int i = 0; i < 5; ++i) {
        shown.step();
    }
}

// What has been written to a terminal, or into a pipe. The kernel hands it on when it finds the time: the end is where
// nothing comes for half a second, or where the writer has closed.
std::string text_on(int reader) {
    std::string text;
    std::array<char, 4096> buffer{};
    pollfd ready{reader, POLLIN, 0};
    while (::poll(&ready, 1, 500) > 0) {
        const auto size = ::read(reader, buffer.data(), buffer.size());
        if (size <= 0) {
            break;
        }
        text.append(buffer.data(), static_cast<std::size_t>(size));
    }
    return text;
}

}  // namespace

TEST_CASE("progress writes nothing when stderr is a file", "[sweep][progress]") {
    const temporary_folder folder;
    const std::string path = (folder.path() / "err").string();
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
    REQUIRE(file >= 0);
    run_five_steps(file);
    ::close(file);
    CHECK(text_of_file(path).empty());
}

TEST_CASE("progress writes nothing when stderr is a pipe", "[sweep][progress]") {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    run_five_steps(ends[1]);
    ::close(ends[1]);
    CHECK(text_on(ends[0]).empty());
    ::close(ends[0]);
}

TEST_CASE("on a terminal progress says how far it is and takes its line away", "[sweep][progress]") {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) {
        WARN("no pseudo-terminal here: not tested");
        return;
    }
    const int own_side = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY);
    REQUIRE(own_side >= 0);
    run_five_steps(own_side);
    const std::string text = text_on(terminal);
    CHECK(text.find("five: 5 of 5") != std::string::npos);
    CHECK(text.find('\n') == std::string::npos);
    CHECK(text.ends_with("\r\033[K"));
    ::close(own_side);
    ::close(terminal);
}

TEST_CASE("what may take days is shown with its rate and with what is slow", "[sweep][progress]") {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    REQUIRE(terminal >= 0);
    REQUIRE(::grantpt(terminal) == 0);
    REQUIRE(::unlockpt(terminal) == 0);
    const int other_end = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY);
    {
        const redirected_stderr elsewhere(other_end);
        progress shown("cells", 8, {}, [] { return "12 s so far: energy=1.9998"; });
        shown.step(6);
        ::usleep(1'300'000);  // the line is renewed every second
    }
    const std::string text = text_on(terminal);
    INFO(text);
    CHECK(text.find("cells: 6 of 8, ") != std::string::npos);
    CHECK((text.find(" a second, about ") != std::string::npos || text.find(" a minute, about ") != std::string::npos));
    CHECK(text.find("; 12 s so far: energy=1.9998") != std::string::npos);
    ::close(other_end);
    ::close(terminal);
}

}  // namespace sweep_progress_test
