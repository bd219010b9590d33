// Lack of memory, under a limit of the data size of the process: one line, exit status 1, and no partial row on stdout.

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "command/child_process.hpp"

namespace command_memory_test {

using namespace libration::tests;

#if !defined(__SANITIZE_ADDRESS__)  // whose address space alone exceeds such limits

// The process with this many kilobytes of data.
finished_process run_within(long kilobytes, const std::string& line) {
    const temporary_folder folder;
    const std::string out = (folder.path() / "out").string();
    const std::string err = (folder.path() / "err").string();
    const int status = std::system(("ulimit -d " + std::to_string(kilobytes) +
                                    "; exec timeout 60 '" LIBRATION_COMMAND "' " + line + " >" + out + " 2>" + err)
                                       .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of_file(out), text_of_file(err)};
}

void check_refused_for_memory(long kilobytes, const std::string& line, const std::string& mentioned) {
    const auto done = run_within(kilobytes, line);
    INFO(line << ", " << kilobytes << " kilobytes\n" << done.out << done.err);
    CHECK(done.exit_code == 1);
    CHECK(done.out.empty());
    CHECK(std::count(done.err.begin(), done.err.end(), '\n') == 1);
    CHECK(done.err.starts_with("libration: "));
    CHECK(done.err.find(mentioned) != std::string::npos);
}

TEST_CASE("a series that needs more memory than there is is refused before it is computed", "[command][memory]") {
    constexpr long two_gigabytes = 2'000'000;
    for (const std::string scalar : {"mpfr:50", "ball:50", "double", "rational"}) {
        // A leading logarithm: no law gives these coefficients.
        check_refused_for_memory(two_gigabytes,
                                 "coefficients --problem \"x' = x^2 - y; y' = y^2 + x; x(0) = 1; y(0) = 0\" --from "
                                 "99999999 --order 100000000 --scalar " +
                                     scalar,
                                 "libration: order 100000000 needs at least");
    }
    check_refused_for_memory(two_gigabytes, "coefficients --theta0 2.5 --omega0 0 --order 1000000 --scalar mpfr:100000",
                             "libration: power 1000000 needs at least 40.");
}

TEST_CASE("memory that GMP or FLINT does not get ends the command with one line", "[command][memory]") {
    int below_gmp = 0;
    // 8 megabytes are the stack of the thread that waits for signals.
    for (long kilobytes = 17'000; kilobytes <= 25'000; kilobytes += 2'000) {
        const auto done = run_within(kilobytes, "reference --theta0 2.5 --omega0 0 --time 3 --digits 60000");
        INFO(kilobytes << " kilobytes: exit code " << done.exit_code << "\n" << done.err);
        CHECK((done.exit_code == 0 || done.exit_code == 1));
        CHECK(done.out.empty() == (done.exit_code == 1));
        CHECK(std::count(done.err.begin(), done.err.end(), '\n') == done.exit_code);
        below_gmp += done.err == "libration: out of memory: ask for fewer digits, powers or times\n" ? 1 : 0;
    }
    CHECK(below_gmp > 0);
}

#endif

}  // namespace command_memory_test
