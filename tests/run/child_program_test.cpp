// Other programs as parts of a study.
#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>
#include <string>

#include "command/temporary_folder.hpp"
#include "run/child_program.hpp"

namespace sweep_child_program_test {

using namespace libration;

TEST_CASE("a child program gets its input and its output comes back, also a megabyte", "[sweep][child_program]") {
    const std::string text(1'000'000, 'x');
    CHECK(output_of_program("/bin/cat", text) == text);
    CHECK(output_of_program("/bin/cat", "").empty());
}

TEST_CASE("a child program that is not there or fails is an error", "[sweep][child_program]") {
    CHECK_THROWS_AS(output_of_program("/no/such/program", ""), std::runtime_error);
    CHECK_THROWS_AS(output_of_program("/bin/false", ""), std::runtime_error);
}

TEST_CASE("a program is run by its name with its words, and its exit code is told", "[sweep]") {
    CHECK(run_program({"true"}) == 0);
    CHECK(run_program({"/bin/sh", "-c", "exit 3"}) == 3);
    CHECK(run_program({"/no/such/program"}) == 127);
}

TEST_CASE("the pipes of a child program end in silence where its parent ignores broken ones",
          "[sweep][child_program]") {
    const libration::tests::temporary_folder folder;
    const std::string said = (folder.path() / "said").string();
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    const int code = run_program({"sh", "-c", "yes 2>'" + said + "' | head -n 1 >/dev/null"});
    std::signal(SIGPIPE, before);
    CHECK(code == 0);
    CHECK(libration::tests::text_of_file(said).empty());
}

}  // namespace sweep_child_program_test
