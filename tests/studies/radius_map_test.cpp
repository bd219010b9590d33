// The study radius_map against the exact lattice by mpmath, and against what can be proved about the best point.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"
#include "text/input_error.hpp"

namespace studies_radius_map_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::map<std::string, std::vector<table_row>> radius_map(const study_words& words) {
    return rows_by_suffix("radius_map", words);
}

}  // namespace

TEST_CASE("verdicts hold the radius of mpmath within their uncertainty", "[studies][radius_map]") {
    // mpmath, 60 digits: sqrt(((1-x) T*)^2 + K'^2) with T* = ellipk(E/2), K' = ellipk(1-E/2), or sqrt(2/E) times
    // ellipk(2/E) and ellipk(1-2/E); x = 0, 1/2, 1.
    const std::map<std::string, std::string> tabulated{{"0.5 0", "2.7372091620228073045683660639578977153213108"},
                                                       {"0.5 1/2", "2.31538297104356018932640850234524879426083889"},
                                                       {"0.5 1", "2.15651564749964323543867499880032202886411022"},
                                                       {"2.02 0", "4.00171085490260204747390648017070599686684044"},
                                                       {"2.02 1/2", "2.4175987338212856015744719584859013926644673"},
                                                       {"2.02 1", "1.56689127306819635838384657341142323770881034"}};
    const precision_scope scope(60);
    const auto rows = radius_map({{"--energies", "0.5,2.02"}, {"--points", "0,1/2,1"}, {"--orders", "50"}}).at("");
    REQUIRE(rows.size() == tabulated.size());
    for (const table_row& row : rows) {
        INFO("E = " << row.at("energy") << ", x = " << row.at("point"));
        const std::string& expected = tabulated.at(row.at("energy") + " " + row.at("point"));
        CHECK_THAT(row.at("exact"), right_to_the_last_digit(expected));
        CHECK(abs(number_of(row.at("radius")) - number_of(expected)) <= number_of(row.at("uncertainty")));
        CHECK(number_of(row.at("relative_error")) * number_of(row.at("exact")) <= number_of(row.at("uncertainty")));
        CHECK(number_of(row.at("position_error")) <= number_of(row.at("uncertainty")));
        CHECK((row.at("kind") == "logarithm" || row.at("kind") == "unknown"));
        CHECK(row.at("count") == (row.at("point") == "0" ? "4" : "2"));
        const mpfr along = number_of(row.at("point") == "0" ? "1" : row.at("point") == "1" ? "0" : "0.5");
        CHECK(abs(number_of(row.at("position_re")) - along * number_of(row.at("tstar"))) <=
              number_of(row.at("uncertainty")));
        CHECK(abs(number_of(row.at("position_im")) - number_of(row.at("height"))) <= number_of(row.at("uncertainty")));
    }
}

TEST_CASE("the deduced optimum is the top for the radius and half way for the rate", "[studies][radius_map]") {
    const auto rows =
        radius_map({{"--energies", "0.5,1.9,4"}, {"--points", "0,1/4,1/2,1"}, {"--orders", "30"}}).at("optimum");
    REQUIRE(rows.size() == 3);
    for (const table_row& row : rows) {
        INFO("E = " << row.at("energy"));
        CHECK(row.at("points") == "4");
        CHECK(row.at("largest_radius_point") == "0");
        CHECK(row.at("exact_largest_radius_point") == "0");
        CHECK(row.at("least_rate_point") == "1/2");
        CHECK(row.at("exact_least_rate_point") == "1/2");
    }
}

TEST_CASE("lists too short for approximants have no kind and say why", "[studies][radius_map]") {
    const auto tables = radius_map({{"--energies", "1"}, {"--points", "0"}, {"--orders", "6"}});
    const table_row& row = tables.at("").at(0);
    CHECK((row.at("kind").empty() || row.at("kind") == "unknown"));
    CHECK_FALSE(row.at("note").empty());
}

TEST_CASE("energies without a way from the top to the bottom have no map", "[studies][radius_map]") {
    CHECK_THROWS_AS(radius_map({{"--energies", "0"}}), libration::error);
    CHECK_THROWS_AS(radius_map({{"--energies", "1,2"}}), libration::error);
    CHECK_THROWS_AS(radius_map({{"--orders", "3"}}), input_error);
}

}  // namespace studies_radius_map_test
