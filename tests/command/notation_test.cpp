// Equations in the notations of textbooks on the command line, and what --set gives that the text leaves open.
#include <catch2/catch.hpp>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_notation_test {

using namespace libration::tests;
using Catch::Contains;

namespace {

words reference_of(const std::string& problem, const words& more = {}) {
    return words{"reference", "--problem", problem, "--time", "1", "--digits", "10"} + more;
}

}  // namespace

TEST_CASE("notations of textbooks give the same digits", "[command][notation]") {
    // tan 1, by the standard notation.
    const std::string tangent = output_of(reference_of("x' = 1 + x^2; x(0) = 0"));
    CHECK_THAT(tangent, Contains("1.557407725"));
    CHECK(output_of(reference_of("dx/dt = 1 + x²; x(0) = 0")) == tangent);
    CHECK(output_of(reference_of("x′(t) = 1 + x(t)·x(t), x(0) = 0")) == tangent);
    CHECK(output_of(reference_of("x' = a + x^2; x(0) = 0", {"--set", "a=1"})) == tangent);
    CHECK(output_of(reference_of("x' = 1 + x^2", {"--set", "x(0)=0"})) == tangent);
    CHECK(output_of(reference_of("dx/dt = a + b*x²", {"--set", "x(0)=0, a=1", "--set", "b=1"})) == tangent);
}

TEST_CASE("what the text leaves open is named with both remedies", "[command][notation]") {
    check_refused(
        reference_of("x' = a + x^2; x(0) = 0"),
        {"--problem 'a' at line 1, column 6 has no value: add --set a=NUMBER, or write x' = a + x^2; x(0) = 0; a "
         "= NUMBER for a parameter, a' = ... for an unknown, variable a for the independent variable"});
    check_refused(
        reference_of("x' = x^2"),
        {"--problem 'x' has no initial value: add --set \"x(0) = NUMBER\", or write x' = x^2; x(0) = NUMBER"});
    check_refused(reference_of("x'' = -λ x; x(0) = 1"),
                  {"--problem 'λ x' at line 1, column 8 multiplies without *: write x'' = -λ*x"});
    check_refused(reference_of("x' = a(t+1); x(0) = 1; a = 2"), {"is ambiguous: write x' = a*(t+1) for a product"});
    check_refused(reference_of("x' = x; x(0) = 1", {"--set", "b=1"}), {"--set", "does not name a parameter"});
    check_refused(reference_of("x' = x; x(0) = 1", {"--set", "x=3"}),
                  {"--set 'x' at line 1, column 1 is an unknown: write x(0)=3 for its initial value"});
    check_refused(reference_of("x' = e^t; x(0) = 1", {"--set", "e=3"}),
                  {"--set 'e' at line 1, column 1 is Euler's number: write `e=3` in the problem for a parameter"});
    check_refused(reference_of("x' = x; x(0) = 1", {"--set", "t=3"}),
                  {"--set 't' at line 1, column 1 is the independent variable, which has no value: leave it out"});
    check_refused(reference_of("dy/dx = x; x' = y"),
                  {"differentiates by x, which is an unknown: give one of them another name"});
}

TEST_CASE("problems prints a text in standard notation", "[command][notation]") {
    CHECK(output_of({"problems", "dx/dt = 1 + x², x(0) = 0"}) == "x' = 1 + x^2\nx(0) = 0\n");
    check_refused({"problems", "x' = y z"},
                  {"problems 'y z' at line 1, column 6 multiplies without *: write x' = y*z"});
}

TEST_CASE("a number of more than three turns is noted as radians", "[command][notation]") {
    const auto radians =
        run_libration({"reference", "--theta0", "150", "--omega0", "0", "--time", "1", "--digits", "5"});
    CHECK(radians.exit_code == 0);
    CHECK(radians.err ==
          "libration: --theta0 150 is more than three turns, as it is in radians: write 150deg for degrees\n");
    for (const std::string angle : {"150deg", "3", "6", "18", "7pi"}) {
        const auto quiet =
            run_libration({"reference", "--theta0", angle, "--omega0", "0", "--time", "1", "--digits", "5"});
        CHECK(quiet.err.empty());
    }
}

TEST_CASE("an incomplete exponent is not a point, as it is not a time", "[command][bad input]") {
    const words growth{"--problem", "y' = y; y(0) = 1"};
    check_refused(words{"coefficients", "--order", "2", "--at", "2e"} + growth, {"--at '2e'"});
    check_refused(words{"reference", "--time", "2e"} + growth, {"--times '2e'"});
}

}  // namespace command_notation_test
