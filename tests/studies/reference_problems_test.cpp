// The studies of proved values against closed forms, and against values that were printed wrong.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_reference_problems_test {

using namespace libration;
using namespace libration::tests;

// y = 1/(1 + e^-t) from y(0) = 1/2. Of y = c/(c + (1 - c) e^-t) dy/dc c/y is e^-t/(c + (1 - c) e^-t), at c = 1/2 2 e^-t
// y; t y'/y is t (1 - y). Three digits are printed. The poles are at i pi (2 k + 1).
TEST_CASE("reference values of the logistic equation, their condition numbers and the nearest singularity",
          "[studies][proved]") {
    const precision_scope scope(40);
    const auto rows =
        rows_by_suffix("reference_problems", {{"--problems", "logistic"}, {"--scalar", "ball:30"}}).at("");
    REQUIRE(rows.size() == 8);
    for (const table_row& row : rows) {
        const mpfr t = number_of(row.at("time"));
        const mpfr y = 1 / (1 + exp(mpfr(-t)));
        CHECK(abs(mpfr(number_of(row.at("value")) - y)) <= y * pow(mpfr(10), -29));
        const mpfr by_start = 2 * exp(mpfr(-t)) * y;
        CHECK(abs(mpfr(number_of(row.at("condition_start")) - by_start)) <= by_start / 100);
        const mpfr by_time = t * (1 - y);
        CHECK(abs(mpfr(number_of(row.at("condition_time")) - by_time)) <= by_time / 100);
        CHECK(row.at("condition_parameters") == "0");
        CHECK(row.at("changed_digit").empty());  // 1/2 is a double
        CHECK(abs(mpfr(number_of(row.at("singularity_re")))) < 1e-3);
        CHECK(abs(mpfr(number_of(row.at("singularity_im")) - pi<mpfr>())) < 1e-3);
        CHECK(abs(mpfr(number_of(row.at("radius")) - sqrt(mpfr(t * t + pi<mpfr>() * pi<mpfr>())))) < 1e-3);
        CHECK(row.at("rigour") == "proved");
    }
}

// Problem A1 is y_i' = -k_i y_i from 1, k = 1/2, 1, 100, 90, up to t = 20: y3 is e^-2000 there.
TEST_CASE("reference values of a stiff problem are those of its closed form at every scale", "[studies][proved]") {
    const precision_scope scope(40);
    const auto rows =
        rows_by_suffix("reference_problems", {{"--problems", "stiff_a1"}, {"--scalar", "ball:50"}}).at("");
    REQUIRE(rows.size() == 44);
    CHECK(number_of(rows.front().at("time")) == mpfr(20) / 1024);
    CHECK(number_of(rows.back().at("time")) == 20);
    const std::map<std::string, mpfr> rates{{"y1", mpfr(1) / 2}, {"y2", 1}, {"y3", 100}, {"y4", 90}};
    for (const table_row& row : rows) {
        const mpfr y = exp(mpfr(-rates.at(row.at("unknown")) * number_of(row.at("time"))));
        CHECK(abs(mpfr(number_of(row.at("value")) - y)) <= y * pow(mpfr(10), -29));
        CHECK(row.at("digits") == "30");
        CHECK(row.at("condition_start").empty());
    }
}

// 2.73 and 0.0178 are no doubles: their roundings, at most 2^-53 of them, change a digit about the 16th.
TEST_CASE("a parameter that is no double changes a digit", "[.long][studies][proved]") {
    const auto rows = rows_by_suffix("reference_problems", {{"--problems", "sir"}, {"--scalar", "ball:20"}}).at("");
    REQUIRE(rows.size() == 16);
    for (const table_row& row : rows) {
        const int digit = std::stoi(row.at("changed_digit"));
        CHECK(digit >= 12);
        CHECK(digit <= 20);
    }
}

// S + I - (a/r) log S is constant for SIR; kepler's are -1/2 and sqrt(1 - e^2) = 4/5.
TEST_CASE("reference values keep their invariants to the digits that they have", "[.long][studies][proved]") {
    const auto rows =
        rows_by_suffix("reference_problems", {{"--problems", "kepler"}, {"--scalar", "ball:30"}}).at("invariants");
    REQUIRE(rows.size() == 2);
    const precision_scope scope(40);
    CHECK(number_of(rows[0].at("value")) == -0.5);
    CHECK(abs(mpfr(number_of(rows[1].at("value")) - mpfr(4) / 5)) <= pow(mpfr(10), -30));
    for (const table_row& row : rows) {
        CHECK(number_of(row.at("difference")) < 100 * pow(mpfr(10), -30));  // a few units of values up to 2
    }
}

TEST_CASE("values in print are judged to their last digit", "[studies][proved]") {
    const auto rows = rows_by_suffix("published", {{"--values", "blasius,lorenz_orbit"}}).at("");
    REQUIRE(rows.size() == 4);
    for (const table_row& row : rows) {
        CHECK(row.at("verdict") == "holds");
        CHECK(row.at("value").substr(0, 18) == row.at("printed").substr(0, 18));
    }
}

}  // namespace studies_reference_problems_test
