// --check for any problem: a second proof, and the same output.
#include <catch2/catch.hpp>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_second_proof_test {

using namespace libration::tests;

namespace {

void check_confirmed(const words& line) {
    INFO(command_line(line));
    CHECK(output_of(line + words{"--check"}) == output_of(line));
}

}  // namespace

TEST_CASE("the option --check proves values, events, unknowns, radii, positions and coefficients twice",
          "[command][check]") {
    check_confirmed({"reference", "--problem", "lorenz", "--time", "1,2", "--digits", "20"});
    check_confirmed({"reference", "--problem", "y' = (c/(1-t))*(c/(t-1)); y(0)=0; c = 1 - 2^(-349)", "--time", "1/16",
                     "--digits", "197"});
    check_confirmed({"reference", "--problem", "x'' = -x; x(0)=1; x'(0)=0", "--until", "x = 1/3", "--count", "3",
                     "--digits", "15"});
    check_confirmed({"find", "--problem", "y' = k*y; y(0)=1; k=0.6", "--unknown", "k", "--such-that", "y(1) = 2"});
    check_confirmed({"find", "--problem", "van_der_pol", "--periodic", "--digits", "12"});
    check_confirmed({"radius", "--problem", "y' = 1+y^2; y(0)=0", "--prove", "--digits", "3"});
    check_confirmed({"singularities", "--problem", "y' = 1+y^2; y(0)=0", "--prove", "--digits", "8"});
    check_confirmed({"coefficients", "--problem", "y' = 1+y^2; y(0)=1", "--order", "70", "--scalar", "ball:40"});
}

TEST_CASE("the option --check without two proofs is refused", "[command][check][bad input]") {
    check_refused({"reference", "--problem", "sir", "--time", "inf", "--check"}, {"--check", "inf"});
    check_refused({"find", "--problem", "blasius", "--unknown", "k", "--such-that", "f'(inf) = 1", "--check"},
                  {"--check", "infinity"});
    check_refused({"radius", "--problem", "y' = 1+y^2; y(0)=1", "--check"}, {"--check", "--prove"});
    check_refused({"singularities", "--problem", "y' = 1+y^2; y(0)=1", "--check"}, {"--check", "--prove"});
    check_refused({"coefficients", "--problem", "y' = 1+y^2; y(0)=1", "--order", "5", "--check"}, {"--check", "ball"});
    check_refused({"coefficients", "--energy", "1", "--order", "5", "--check"}, {"--check", "--problem"});
}

}  // namespace command_second_proof_test
