// --timeout and signals: what is finished is printed, one line has how far the command got, and the exit code is 1.
#include <signal.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "option/timeout_option.hpp"
#include "text/input_error.hpp"

namespace command_timeout_test {

using namespace libration;
using namespace libration::tests;
using Catch::Contains;
using std::chrono::milliseconds;

namespace {

// Of minutes: the times up to 1 are reached at once.
const words long_reference{"reference", "--problem", "lorenz", "--times", "1/2,1,100000", "--digits",
                           "20",        "--format",  "csv",    "--set",   "r=28"};

void check_ended(const finished_process& ended, const std::string& why) {
    INFO(ended.err);
    CHECK(ended.exit_code == 1);
    CHECK(std::ranges::count(ended.err, '\n') == 1);
    CHECK(ended.err.starts_with("libration: " + why));
}

}  // namespace

TEST_CASE("a duration is in seconds or has a unit", "[command][timeout]") {
    CHECK(duration_of("90") == milliseconds(90'000));
    CHECK(duration_of("90s") == milliseconds(90'000));
    CHECK(duration_of("1.5") == milliseconds(1500));
    CHECK(duration_of("250ms") == milliseconds(250));
    CHECK(duration_of("5min") == milliseconds(300'000));
    CHECK(duration_of("2h") == milliseconds(7'200'000));
    for (const char* wrong : {"", "s", "0", "-1", "1 day", "1e20", "0.1ms", "5minutes"}) {
        INFO(wrong);
        CHECK_THROWS_AS(duration_of(wrong), input_error);
    }
    check_refused(long_reference + words{"--timeout", "soon"}, {"--timeout 'soon'", "write seconds above 0"});
}

TEST_CASE("finished times are printed at the timeout", "[command][timeout]") {
    const auto before = std::chrono::steady_clock::now();
    const auto ended = run_libration(long_reference + words{"--timeout", "1200ms"});
    CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(20));
    check_ended(ended, "--timeout '1200ms' ended the command at ");
    CHECK_THAT(ended.err, Contains(" % of reference, time ") && Catch::EndsWith(" bits\n"));
    CHECK(csv_rows(ended.out).size() == 2);
}

TEST_CASE("finished times are printed at a signal", "[command][timeout]") {
    const temporary_folder folder;
    const auto ended = run_libration(long_reference, folder.path(), "/dev/null", [](pid_t command) {
        std::this_thread::sleep_for(milliseconds(1200));
        ::kill(command, SIGINT);
    });
    check_ended(ended, "a signal ended the command at ");
    CHECK(csv_rows(ended.out).size() == 2);
}

TEST_CASE("a search without an event prints the time that it reached", "[command][timeout]") {
    const auto ended = run_libration({"reference", "--problem", "lorenz", "--until", "z = 100", "--timeout", "500ms"});
    check_ended(ended, "the search for events was interrupted about time ");
    CHECK(ended.out.empty());
}

TEST_CASE("find ends at the timeout with the time of its integration", "[command][timeout]") {
    const auto ended =
        run_libration({"find", "--problem", "van_der_pol", "--periodic", "--digits", "1000", "--timeout", "500ms"});
    check_ended(ended, "--timeout '500ms' ended the command");
    CHECK(ended.out.empty());
}

TEST_CASE("singularities keeps what is found and proved at the timeout", "[command][timeout]") {
    const auto ended = run_libration({"singularities", "--problem", "painleve_1", "--within", "12", "--prove",
                                      "--digits", "40", "--format", "csv", "--timeout", "1500ms"});
    check_ended(ended, "--");
    CHECK_THAT(ended.err, Contains(" unproved: ") || Contains(" expansion points"));
}

TEST_CASE("a proof of a radius says at the timeout what is proved", "[command][timeout]") {
    const auto ended =
        run_libration({"radius", "--problem", "lorenz", "--prove", "--digits", "60", "--timeout", "1500ms"});
    check_ended(ended, "");
    CHECK_THAT(ended.err,
               Contains("--timeout '1500ms' ended the command at radius, ") && Contains(" expansion points"));
}

TEST_CASE("a command that ends before the timeout is not changed", "[command][timeout]") {
    const words tangent{"reference", "--problem", "x' = 1 + x^2; x(0) = 0", "--time", "1"};
    CHECK(output_of(tangent + words{"--timeout", "1min"}) == output_of(tangent));
}

TEST_CASE("commands without checks between their steps end at the timeout", "[command][timeout]") {
    for (const words& line : {words{"elliptic", "Pi", "--n", "1/3", "--m", "1/2", "--digits", "100000"},
                              words{"find", "--problem", "van_der_pol", "--periodic", "--digits", "3000"}}) {
        const auto before = std::chrono::steady_clock::now();
        const auto ended = run_libration(line + words{"--timeout", "200ms"});
        CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(4));
        check_ended(ended, "--timeout '200ms' ended the command");
    }
}

}  // namespace command_timeout_test
