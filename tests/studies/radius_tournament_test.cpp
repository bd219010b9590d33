// The tournament on a part of its problems: its judgements again from its own cells, and what the uncertainties
// promise.
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>

#include "libration/number/exact.hpp"
#include "libration/scalar/decimal.hpp"
#include "studies/study_rows.hpp"

namespace studies_radius_tournament_test {

using namespace libration;
using namespace libration::tests;

namespace {

mpfr number(const std::string& text) { return from_exact<mpfr>(read_exact(text)); }

// One run serves all tests of this file.
const std::map<std::string, std::vector<table_row>>& played() {
    static const auto rows = rows_by_suffix("radius_tournament", {{"--energies", "0.5,1,4"},
                                                                  {"--gaps", "1e-10"},
                                                                  {"--orders", "20"},
                                                                  {"--lists", "46"},
                                                                  {"--scalar", "double"}});
    return rows;
}

void check_radii() {
    const precision_scope scope(40);
    std::size_t judged = 0;
    for (const table_row& row : played().at("")) {
        INFO(row.at("problem") << " " << row.at("method") << " " << row.at("order"));
        if (row.at("radius").empty() || row.at("exact") == "inf" || row.at("exact") == "0") {
            CHECK(row.at("digits").empty());
            CHECK((!row.at("radius").empty() || !row.at("note").empty()));
            continue;
        }
        const mpfr exact = number(row.at("exact"));
        const mpfr away = abs(number(row.at("radius")) - exact);
        const mpfr uncertainty = number(row.at("uncertainty"));
        // 17 digits of each radius and 6 of the uncertainty are printed.
        const mpfr cut = exact / pow(mpfr(10), 15) + uncertainty / 100000;
        if (abs(away - uncertainty) > cut) {
            CHECK(row.at("covered") == (away < uncertainty ? "yes" : "no"));
            ++judged;
        }
        CHECK(abs(number(row.at("relative_error")) * exact - away) <= cut + away / 100000);
    }
    CHECK(judged > 250);
}

void check_known_answers() {
    const std::map<std::string, std::string> exact{
        {"log(1-t)", "1.0000000000000000"},
        {"tan t", "1.5707963267948966"},
        {"inverse Langevin", "0.90464367945768374"},  // sinh y = -y at 2.2507 + 4.2124 i
        {"Blasius", "5.6900380545226400"},            // 5.6900380545 [Boyd1999]
        {"e^t", "inf"},
        {"sum n! t^n", "0"},
        {"pendulum E=4 x=1", "1.3110287771460599"},   // K(1/sqrt 2)/sqrt 2: at E = 4 the bottom radius is T*
        {"pendulum E=1 x=0", "2.6220575542921198"}};  // the lemniscate constant
    std::set<std::string> seen;
    for (const table_row& row : played().at("")) {
        const auto known = exact.find(row.at("problem"));
        if (known != exact.end()) {
            CHECK(row.at("exact") == known->second);
            seen.insert(known->first);
        }
    }
    CHECK(seen.size() == exact.size());
}

void check_ranking() {
    const precision_scope scope(40);
    mpfr before(100);
    int rank = 0;
    for (const table_row& row : played().at("ranking")) {
        rank = row.at("rank") == "1" ? 1 : rank + 1;
        CHECK(row.at("rank") == std::to_string(rank));
        const mpfr digits = number(row.at("mean_digits"));
        CHECK((rank == 1 || digits <= before));
        before = digits;
        CHECK(row.at("false_answers") == "0");
        if (row.at("method") == "verdict") {
            CHECK(rank == 1);
        }
    }
}

void check_coverage() {
    const precision_scope scope(40);
    bool seen = false;
    for (const table_row& row : played().at("coverage")) {
        if (row.at("half") == "judged" && row.at("method") == "all") {
            CHECK(number(row.at("covered")) >= mpfr(95) / 100);
            CHECK(number(row.at("median_uncertainty_over_error")) < 30);
            seen = true;
        }
    }
    CHECK(seen);
}

void check_values() {
    const precision_scope scope(60);
    std::map<std::string, int> values;
    std::map<std::string, int> covered;
    for (const table_row& row : played().at("values")) {
        INFO(row.at("family") << " " << row.at("list") << " " << row.at("order"));
        CHECK(row.at("value").empty() == row.at("covered").empty());
        if (row.at("value").empty()) {
            CHECK(!row.at("note").empty());
            continue;
        }
        const mpfr exact = number(row.at("exact"));
        const mpfr away = abs(number(row.at("value")) - exact);
        const mpfr uncertainty = number(row.at("uncertainty"));
        // 40 digits of each value and 6 of the uncertainty are printed.
        const mpfr cut = abs(exact) / pow(mpfr(10), 39) + uncertainty / 100000;
        if (abs(away - uncertainty) > cut) {
            CHECK(row.at("covered") == (away < uncertainty ? "yes" : "no"));
        }
        for (const std::string& region : {row.at("region"), std::string("all")}) {
            ++values[region + row.at("order")];
            covered[region + row.at("order")] += row.at("covered") == "yes" ? 1 : 0;
        }
    }
    CHECK(values["all20"] >= 40);
    for (const table_row& row : played().at("value_coverage")) {
        const std::string at = row.at("region") + row.at("order");
        CHECK(row.at("values") == std::to_string(values[at]));
        CHECK((row.at("covered").empty() ||
               abs(number(row.at("covered")) - mpfr(covered[at]) / values[at]) < mpfr(1) / 1000));
        CHECK((row.at("region") != "all" || number(row.at("covered")) >= mpfr(97) / 100));
    }
}

}  // namespace

// One test case, so that the studies are run once.
TEST_CASE("radius_tournament judges answers and values, and ranks the tests", "[studies][radius_tournament]") {
    check_radii();
    check_known_answers();
    check_ranking();
    check_coverage();
    check_values();
}

TEST_CASE("radius_tournament refuses what has no radius", "[studies][radius_tournament]") {
    CHECK_THROWS_WITH(tables_of_study("radius_tournament", {{"--energies", "2"}, {"--orders", "20"}}),
                      Catch::Contains("energy 2"));
}

}  // namespace studies_radius_tournament_test
