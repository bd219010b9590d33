// `libration singularities` and `radius --prove`: their contract, closed forms, and errors.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "libration/scalar/constants.hpp"

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
    // Half a unit of the last place and the disc.
    CHECK(number_of(proved.front().at("uncertainty")) <= mpfr("1e-11"));
    const precision_scope scope(40);
    CHECK(abs(number_of(proved.front().at("position_re")) - mpfr(7) / 3) <=
          number_of(proved.front().at("uncertainty")));
    CHECK(proved.front().at("evidence") == "the contour integral of y is nonzero; 1/y has a simple zero");
}

// y = 1/(1 - t), z = tan t: z is not singular at 1, and printed positions are correct within their uncertainty.
TEST_CASE("rows of a system speak of their own unknown", "[command][singularity]") {
    const auto rows = rows_of({"singularities", "--problem", "y'=y^2; z'=1+z^2; y(0)=1; z(0)=0", "--within", "5",
                               "--prove", "--digits", "10"});
    REQUIRE(rows.size() == 5);
    const precision_scope scope(40);
    const mpfr quarter = pi<mpfr>() / 2;
    const std::vector<mpfr> places{1, quarter, -quarter, 3 * quarter, -3 * quarter};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(rows[i].at("unknown") == (i == 0 ? "y" : "z"));
        CHECK(rows[i].at("rigour") == "proved");
        CHECK(rows[i].at("exponent_re") == "-1");
        CHECK(rows[i].at("evidence").ends_with(i == 0 ? "1/y has a simple zero" : "1/z has a simple zero"));
        CHECK(abs(number_of(rows[i].at("position_re")) - places[i]) <= number_of(rows[i].at("uncertainty")));
    }
    const auto plain = rows_of({"singularities", "--problem", "y'=1+y^2; z'=1+z^2; y(0)=0; z(0)=1", "--within", "4"});
    REQUIRE(plain.size() == 5);
    for (const auto& row : plain) {
        const mpfr start = row.at("unknown") == "y" ? mpfr(0) : pi<mpfr>() / 4;
        const mpfr turns = (number_of(row.at("position_re")) + start) / quarter;
        CHECK(abs(turns - round(turns)) * quarter <= number_of(row.at("uncertainty")));
    }
}

// z = 1/(1 + log(1 - t)): 1/log at 1.
TEST_CASE("cells without a value are empty", "[command][singularity]") {
    const auto rows = rows_of({"singularities", "--problem", "y'=y^2; z'=y*z^2; y(0)=1; z(0)=1", "--within", "2"});
    REQUIRE(rows.size() == 3);
    CHECK(rows[2].at("unknown") == "z");
    CHECK(rows[2].at("kind") == "unclear");
    CHECK(rows[2].at("exponent_re").empty());
    CHECK(rows[2].at("coefficient_im").empty());
}

// y = 1/(s - t).
TEST_CASE("radii and places at any scale", "[command][singularity]") {
    for (const std::string s : {"1e-100", "1e10"}) {
        const words problem{"--problem", "y' = y^2; y(0) = 1/" + s, "--digits", "8"};
        const auto radius = rows_of(with({"radius", "--prove"}, problem)).front();
        const precision_scope scope(30);
        CHECK(number_of(radius.at("lower")) < mpfr(s));
        CHECK(mpfr(s) < number_of(radius.at("upper")));
        const auto place = rows_of(with({"singularities"}, problem)).front();
        CHECK(abs(number_of(place.at("position_re")) - mpfr(s)) <= number_of(place.at("uncertainty")));
        CHECK(abs(number_of(place.at("coefficient_re")) + 1) < mpfr("1e-6"));
    }
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
    const mpfr error = abs(number_of(rows.front().at("verdict")) - mpfr(7) / 3);
    CHECK(error <= number_of(rows.front().at("verdict_uncertainty")));
    CHECK(rows.front().at("judgement") == "holds");
    const auto entire = rows_of({"radius", "--problem", "y'' = -t*y; y(0) = 1; y'(0) = 0", "--prove"});
    CHECK(entire.front().at("lower") == "inf");
    CHECK(entire.front().at("upper") == "inf");
    CHECK(entire.front().at("verdict") == "inf");
    CHECK(entire.front().at("judgement") == "holds");
}

TEST_CASE("a proved map judges the verdict on the coefficients", "[command][singularity]") {
    const std::string text = output_of({"singularities", "--problem", "y' = y^2; y(0) = 3/7", "--prove"});
    CHECK_THAT(text, Catch::Contains("heuristic  2.33333333333") &&
                         Catch::Contains("from the coefficients up to t^100: holds"));
}

// (1 + t^2/3)^(-1/2), whose equation is singular at the initial point.
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

// S(inf) of Eyam, 76.0563587702 [PROBLEMS] truncated as there, computed without Lambert's function.
TEST_CASE("what an epidemic leaves", "[command][problem]") {
    const auto rows = rows_of({"reference", "--problem", "sir", "--time", "inf", "--digits", "12"});
    CHECK(rows.front().at("S") == "76.0563587703");
    CHECK(rows.front().at("I") == "0");
    CHECK(rows.front().at("rigour") == "proved");
}

}  // namespace command_singularities_test
