// The exit code of each kind of error: 2 if the question has no answer as it is asked, 1 if no answer was found.
#include <catch2/catch.hpp>
#include <vector>

#include "command/child_process.hpp"
#include "libration/scalar/error.hpp"

namespace command_exit_code_test {

using namespace libration::tests;
using libration::error_kind;

namespace {

struct failing_command {
    error_kind kind;
    words line;
};

const std::vector<failing_command>& failing_commands() {
    static const std::vector<failing_command> all{
        {error_kind::argument, {"period", "--energy", "-1"}},
        {error_kind::argument, {"period", "--energy", "much"}},
        {error_kind::argument, {"reference", "--problem", "x' = log(x); x(0) = -1", "--times", "1"}},
        {error_kind::argument, {"reference", "--energy", "2", "--times", "T/4"}},
        {error_kind::range, {"period", "--energy", "1e-400", "--scalar", "double"}},
        {error_kind::undecided, {"reference", "--problem", "x' = 1 + x^2; x(0) = 0", "--times", "2", "--digits", "5"}},
        {error_kind::undecided, {"reference", "--problem", "x' = -x^2; x(0) = 1", "--times", "inf", "--digits", "5"}}};
    return all;
}

}  // namespace

TEST_CASE("the exit code of an error is 2 if the question is undefined and 1 if the program is unable to answer it",
          "[command][errors]") {
    for (const auto& [kind, line] : failing_commands()) {
        const temporary_folder folder;
        const finished_process done = run_libration(line, folder.path());
        INFO(command_line(line) << "\n" << done.err);
        CHECK(done.exit_code == (libration::is_undefined(kind) ? 2 : 1));
        CHECK(done.err.starts_with("libration: "));
    }
}

TEST_CASE("argument and range are undefined, undecided is not", "[command][errors]") {
    CHECK(libration::is_undefined(error_kind::argument));
    CHECK(libration::is_undefined(error_kind::range));
    CHECK_FALSE(libration::is_undefined(error_kind::undecided));
}

}  // namespace command_exit_code_test
