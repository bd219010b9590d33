// Other programs as parts of a study.
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

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

}  // namespace sweep_child_program_test
