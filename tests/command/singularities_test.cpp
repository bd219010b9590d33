// `libration singularities` and `radius --prove`: their contract, closed forms, and refusals.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_singularities_test {

using namespace libration;
using namespace libration::tests;

namespace {

using words = std::vector<std::string>;

words with(words first, const words& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

}  // namespace

// 1/(7/3 - t).
TEST_CASE("a pole as a row, and proved", "[command][singularity]") {
    const words command{"singularities", "--problem", "y' = y^2; y(0) = 3/7", "--digits", "12"};
    const auto rows = rows_of(command);
    REQUIRE(rows.size() == 1);
    const table_row& pole = rows.front();
    CHECK(pole.at("position_re") == "2.33333333333");
    CHECK(pole.at("position_im") == "0");
    CHECK(pole.at("modulus") == "2.33333333333");
    CHECK(pole.at("kind") == "pole of order 1");
    CHECK(pole.at("exponent_re") == "-1");
    CHECK(pole.at("coefficient_re") == "-1");
    CHECK(pole.at("resonances") == "-1");
    CHECK(pole.at("rigour") == "heuristic");
    const auto proved = rows_of(with(command, {"--prove"}));
    CHECK(proved.front().at("rigour") == "proved");
    CHECK(number_of(proved.front().at("uncertainty")) <= mpfr("1e-12"));
    CHECK(proved.front().at("evidence") == "the round integral of y is not 0; 1/y has a simple zero");
}

TEST_CASE("bounds of a radius are printed outwards", "[command][singularity]") {
    const auto rows = rows_of({"radius", "--problem", "y' = y^2; y(0) = 3/7", "--prove", "--digits", "20"});
    REQUIRE(rows.size() == 1);
    const precision_scope scope(50);
    const mpfr lower = number_of(rows.front().at("lower"));
    const mpfr upper = number_of(rows.front().at("upper"));
    CHECK(lower <= mpfr(7) / 3);
    CHECK(mpfr(7) / 3 <= upper);
    CHECK(upper - lower < lower * mpfr("1e-20"));
    CHECK(rows.front().at("rigour") == "proved");
    const auto entire = rows_of({"radius", "--problem", "y'' = -t*y; y(0) = 1; y'(0) = 0", "--prove"});
    CHECK(entire.front().at("lower") == "inf");
    CHECK(entire.front().at("upper") == "inf");
}

// (1 + t^2/3)^(-1/2) starts where its equation is singular.
TEST_CASE("singularities and the radius from a singular start", "[command][singularity]") {
    const words star{"--problem", "lane_emden", "--set", "n=5", "--digits", "15"};
    const auto rows = rows_of(with({"singularities", "--prove"}, star));
    REQUIRE(rows.size() == 2);
    const precision_scope scope(40);
    for (const auto& row : rows) {
        CHECK(row.at("position_re") == "0");
        CHECK(abs(abs(number_of(row.at("position_im"))) - sqrt(mpfr(3))) < mpfr("1e-14"));
        CHECK(row.at("kind") == "algebraic");
        CHECK(row.at("exponent_re") == "-0.5");
        CHECK(row.at("rigour") == "proved");
    }
    const auto radius = rows_of(with({"radius", "--prove"}, star)).front();
    CHECK(number_of(radius.at("lower")) < sqrt(mpfr(3)));
    CHECK(sqrt(mpfr(3)) < number_of(radius.at("upper")));
}

TEST_CASE("what singularities and proofs do not understand is refused", "[command][singularity][bad input]") {
    check_refused({"singularities"}, {"--problem"});
    check_refused({"singularities", "--problem", "blasius", "--within", "0"}, {"--within", "'0'"});
    check_refused({"singularities", "--problem", "blasius", "--digits", "0"}, {"--digits"});
    check_refused({"singularities", "--problem", "thomas_fermi"}, {"--problem", "root"});
    check_refused({"radius", "--prove", "--problem", "lane_emden", "--set", "n=3/2"}, {"--problem", "several values"});
    check_refused({"radius", "--prove", "--energy", "1"}, {"--prove", "--problem"});
    check_refused({"radius", "--prove", "--problem", "blasius", "--order", "20"}, {"--order", "'20'"});
    check_refused({"radius", "--prove", "--problem", "blasius", "--at", "1"}, {"--at"});
}

// S(inf) of Eyam, 76.0563587702 [PROBLEMS] as it is cut off there, by another computation than Lambert's function.
TEST_CASE("what an epidemic leaves", "[command][problem]") {
    const auto rows = rows_of({"reference", "--problem", "sir", "--time", "inf", "--digits", "12"});
    CHECK(rows.front().at("S") == "76.0563587703");
    CHECK(rows.front().at("I") == "0");
    CHECK(rows.front().at("rigour") == "proved");
}

}  // namespace command_singularities_test
