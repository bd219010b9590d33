// The study cost: its counts against sums done by hand, the agreement of its routes, and what the paper says of them.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"
#include "text/input_error.hpp"

namespace studies_cost_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<study_table> run(const study_words& words) { return tables_of_study("cost", words); }

using rows_by_route = std::map<std::string, table_row>;

// The one row of each route.
rows_by_route by_route(const study_table& part) {
    rows_by_route rows;
    for (const table_row& row : csv_rows(to_csv(part.data))) {
        rows[row.at("route")] = row;
    }
    return rows;
}

}  // namespace

TEST_CASE("the paper's two quadratic steps are N^2 and N^2/2 products", "[studies][cost]") {
    const auto rows = by_route(run({{"--energies", "1.71"}, {"--orders", "100"}}).front());
    REQUIRE(rows.size() == 9);
    // Two sums of j products, j = 1 .. 98, one for each of 99 a_n, four for the start; sum of j = 1 .. 101.
    CHECK(rows.at("direct").at("multiplications") == "9805");
    CHECK(rows.at("convolution").at("multiplications") == "5151");
    CHECK(rows.at("running_sums").at("multiplications") == "0");
    CHECK(rows.at("alpha_beta").at("multiplications") == "3");
}

TEST_CASE("the arcsine costs 1.5 times the direct recursion, the cheapest routes 5.3 times less", "[studies][cost]") {
    const auto rows = by_route(run({{"--energies", "1.71"}, {"--orders", "640"}}).front());
    const precision_scope scope(30);
    const auto ratio = [&](const std::string& route) { return number_of(rows.at(route).at("ratio")); };
    CHECK(abs(ratio("arcsine") - mpfr("1.5")) < mpfr("0.02"));
    CHECK(abs(ratio("arcsine_parity") - mpfr("0.375")) < mpfr("0.01"));
    CHECK(abs(1 / ratio("symmetric_squares") - mpfr(16) / 3) < mpfr("0.15"));
    CHECK(abs(1 / ratio("speed") - mpfr(16) / 3) < mpfr("0.15"));
    const auto nonzero = [&](const std::string& route) {
        return number_of(rows.at(route).at("nonzero_multiplications"));
    };
    CHECK(abs(nonzero("direct") / nonzero("symmetric_squares") - mpfr(4) / 3) < mpfr("0.05"));
}

TEST_CASE("all routes but the arcsine agree to the digits, and the arcsine as theory says", "[studies][cost]") {
    const precision_scope scope(30);
    for (const std::string energy : {"0.5", "1.71", "2.02"}) {
        for (const auto& [route, row] : by_route(run({{"--energies", energy}, {"--orders", "160"}}).front())) {
            INFO("E = " << energy << ", " << route);
            if (!row.at("note").empty()) {
                CHECK(energy == "2.02");
                CHECK(row.at("multiplications").empty());
                CHECK(row.at("note").find("branch point") != std::string::npos);
                continue;
            }
            const mpfr difference = number_of(row.at("log10_difference").substr(1)) * -1;
            REQUIRE(row.at("log10_difference").front() == '-');
            if (row.at("expected_growth").empty()) {
                CHECK(difference < -60);  // 65 digits in the arithmetic
            } else {
                // 10^-65 times the growth, and the size of the coefficients and sums
                CHECK(abs(difference + 65 - number_of(row.at("expected_growth"))) < 3);
            }
        }
    }
}

TEST_CASE("times are marked as those of the machine", "[studies][cost]") {
    const auto tables = run({{"--energies", "1.71,2.02"}, {"--orders", "10,20"}, {"--scalar", "double"}});
    REQUIRE(tables.size() == 2);
    CHECK_FALSE(tables[0].timed);
    CHECK(tables[1].timed);
    CHECK(tables[0].data.rows().size() == 36);
    CHECK(tables[1].data.rows().size() == 32);  // two energies and two orders: no arcsine in the second energy
    const precision_scope scope(30);
    for (const table_row& row : csv_rows(to_csv(tables[1].data))) {
        CHECK(number_of(row.at("seconds")) > 0);
        CHECK((row.at("route") != "direct" || number_of(row.at("ratio")) == 1));
    }
}

TEST_CASE("energies and orders without a series are refused", "[studies][cost]") {
    CHECK_THROWS_AS(run({{"--energies", "0"}}), libration::error);
    CHECK_THROWS_AS(run({{"--energies", "2"}}), libration::error);
    CHECK_THROWS_AS(run({{"--energies", "1e-400"}, {"--orders", "4"}, {"--scalar", "double"}}), libration::error);
    CHECK_THROWS_AS(run({{"--orders", "1,20"}}), input_error);
}

}  // namespace studies_cost_test
