// Statements with indices against the same statements written out by hand.
#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"

namespace equation_text_indexed_statement_test {

using namespace libration;
using namespace libration::ode;

namespace {

std::string reason_for(const std::string& text) {
    try {
        parse(text);
    } catch (const error& problem) {
        return problem.what();
    }
    return "";
}

}  // namespace

TEST_CASE("indexed statement: ranges are written out") {
    CHECK(
        canonical_text("q[i]' = p[i] for i = 1..2; p[i]' = q[i+1] - 2*q[i] + q[i-1] for i = 1..2; q[0] = 0; q[3] = 0; "
                       "q[i](0) = (i mod 3)/5 for i = 1..2; p[i](0) = 0 for i = 1..2") ==
        "q[1]' = p[1]\nq[2]' = p[2]\np[1]' = q[2] - 2*q[1] + q[0]\np[2]' = q[3] - 2*q[2] + q[1]\nq[0] = 0\nq[3] = 0\n"
        "q[1](0) = (1)/5\nq[2](0) = (2)/5\np[1](0) = 0\np[2](0) = 0\n");
}

TEST_CASE("indexed statement: rings, tables and triangles") {
    // Lorenz 96 with 4 unknowns: the neighbours of 1 are 4 and 3 before it.
    CHECK(canonical_text("x[i]' = x[(i - 2) mod 4 + 1]*x[(i-3) mod 4+1] for i = 1..2") ==
          "x[1]' = x[4]*x[3]\nx[2]' = x[1]*x[4]\n");
    CHECK(canonical_text("u[i, j]' = -i*u[i][j] for i = 1..2 for j = 1..i") ==
          "u[1][1]' = -1*u[1][1]\nu[2][1]' = -2*u[2][1]\nu[2][2]' = -2*u[2][2]\n");
    CHECK(canonical_text("u[2*i]' = 3^i*mod(i + 1, 3) for i = -1..0") == "u[-2]' = 3^(-1)*0\nu[0]' = 3^0*1\n");
    CHECK(canonical_text("q'[1] = 1, q[2]'' = 3") == "q[1]' = 1\nq[2]'' = 3\n");
}

TEST_CASE("indexed statement: brackets of sets stay") {
    const auto system = parse("x' = -x; x(0) = [0, 1]; q[1]' = x; q[1](0) = [1/2, 1]");
    CHECK(system.sets.size() == 2);
    CHECK(system.unknowns() == std::vector<std::string>{"x", "q[1]"});
}

TEST_CASE("indexed statement: values are changed by the name with its index") {
    const auto system =
        changed(parse("q[i]' = k*q[i] for i = 1..2; q[i](0) = i for i = 1..2; k = 1"), "q[2](0) = 7, k = 3");
    CHECK(same_form(system.starts[1].value, expression(7)));
}

TEST_CASE("indexed statement: what is not an index is refused") {
    CHECK(reason_for("q[i]' = 1") ==
          "problem 'i' at line 1, column 3 is not an index with a range: write `q[i]' = p[i] for i = 1..100`");
    CHECK(reason_for("q[i]' = 1 for i = 3..1").find("is an empty range") != std::string::npos);
    CHECK(reason_for("q[1.5]' = 1").find("is not a whole number") != std::string::npos);
    CHECK(reason_for("q[i/2]' = 1 for i = 1..2").find("is not a whole number") != std::string::npos);
    CHECK(reason_for("q[i]' = 2i for i = 1..2").find("write 2*i") != std::string::npos);
    CHECK(reason_for("q[i]' = i' for i = 1..2").find("is an index, which has no derivative") != std::string::npos);
    CHECK(reason_for("q[i]' = 2*i mod 3 for i = 1..2").find("is not a remainder") != std::string::npos);
    CHECK(reason_for("q[i mod 0]' = 1 for i = 1..2").find("has the modulus 0") != std::string::npos);
    CHECK(reason_for("q[]' = 1").find("has no index behind it") != std::string::npos);
    CHECK(reason_for("q[i' = 1 for i = 1..2").find("is not closed") != std::string::npos);
    CHECK(reason_for("q[i]' = 1 for i = 1").find("has no range") != std::string::npos);
    CHECK(reason_for("q[i]' = 1 for i = 1..2 for i = 1..2").find("has two ranges") != std::string::npos);
    CHECK(reason_for("q[i]' = q[i] + q[i] for i = 1..1000000").find("symbols") != std::string::npos);
    CHECK(reason_for("x' = 1..2").find("is not in a range") != std::string::npos);
    CHECK(reason_for("x' = [0, 1]'").find("does not follow a name") != std::string::npos);
}

}  // namespace equation_text_indexed_statement_test
