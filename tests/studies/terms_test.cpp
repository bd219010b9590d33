// The study terms: its orders against norms that error_norm finds by itself, against the bounds, and its refusals.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_terms_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<table_row> rows_for(const study_words& words) { return rows_of_study("terms", words); }

}  // namespace

TEST_CASE("the least order is where the norms of error_norm fall below 10^-D for good", "[studies][terms]") {
    const precision_scope scope(60);
    for (const table_row& row : rows_for({{"--energies", "0.5,1.71,2.02,4"}, {"--digits", "3,12"}})) {
        INFO("E = " << row.at("energy") << ", D = " << row.at("digits") << ", " << row.at("method"));
        const int order = std::stoi(row.at("order"));
        const int first = order == 0 ? 0 : order - 1;
        std::string orders = std::to_string(first);
        for (int n = first + 1; n < order + 12; ++n) {
            orders += "," + std::to_string(n);
        }
        const mpfr goal = pow(mpfr(10), -std::stoi(row.at("digits")));
        for (const table_row& other : rows_of_study(
                 "error_norm", {{"--energies", row.at("energy")}, {"--orders", orders}, {"--scalar", "mpfr:20"}})) {
            if (other.at("method") != row.at("method")) {
                continue;
            }
            const int n = std::stoi(other.at("order"));
            INFO("N = " << n);
            CHECK((number_of(other.at("norm")) > goal) == (n == order - 1));
            if (n == order) {
                CHECK_THAT(row.at("norm"), right_to_the_last_digit(other.at("norm")));
            } else if (n == order - 1) {
                CHECK_THAT(row.at("norm_before"), right_to_the_last_digit(other.at("norm")));
            }
        }
    }
}

TEST_CASE("measured orders are below the proved ones and near the prediction", "[studies][terms]") {
    const precision_scope scope(60);
    std::map<std::string, int> of_series;
    for (const table_row& row : rows_for({{"--gaps", "1e-1,-1e-1,1e-4,-1e-4"}, {"--digits", "8,25"}})) {
        INFO("gap " << row.at("gap") << ", D = " << row.at("digits") << ", " << row.at("method"));
        const int order = std::stoi(row.at("order"));
        const std::string key = row.at("gap") + " " + row.at("digits");
        CHECK(order <= std::stoi(row.at("proved_order")));
        // |a_n| R^n is about 8/n: the series needs somewhat less than its rate says, the resummation less than that.
        const mpfr predicted = number_of(row.at("predicted"));
        if (row.at("method") == "series") {
            of_series[key] = order;
            CHECK(order < predicted);
            CHECK(order > predicted / 2);
            const bool rotates = row.at("gap").front() == '-';
            CHECK(std::stoi(row.at("terms")) == (rotates ? (order + 1) / 2 + 1 : order / 2 + 1));
        } else {
            CHECK(order < of_series.at(key));
        }
    }
    CHECK(of_series.size() == 8);
}

TEST_CASE("digits that the constant already has take no order at all", "[studies][terms]") {
    const auto rows = rows_for({{"--energies", "1e-30"}, {"--digits", "10"}});
    REQUIRE(rows.size() == 2);
    CHECK(rows.front().at("order") == "0");
    CHECK(rows.front().at("norm_before").empty());
}

TEST_CASE("E = 0, E = 2 and too many digits are refused", "[studies][terms]") {
    CHECK_THROWS_WITH(rows_for({{"--energies", "2"}}), Catch::Contains("energy 2"));
    CHECK_THROWS_WITH(rows_for({{"--energies", "0"}}), Catch::Contains("energy 0"));
    CHECK_THROWS_WITH(rows_for({{"--energies", "1"}, {"--digits", "5000"}}), Catch::Contains("5000"));
}

}  // namespace studies_terms_test
