// The study approximants: what its approximants are worth, against what is known of them by other ways.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_approximants_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::map<std::string, std::vector<table_row>> rows_for(const std::string& problems, const std::string& orders) {
    return rows_by_suffix("approximants", {{"--problems", problems}, {"--orders", orders}, {"--digits", "16"}});
}

mpfr norm_in(const std::vector<table_row>& rows, const std::string& method, int order) {
    for (const table_row& row : rows) {
        if (row.at("method") == method && row.at("order") == std::to_string(order)) {
            return number_of(row.at("norm"));
        }
    }
    throw std::runtime_error("there is no row of " + method);
}

}  // namespace

TEST_CASE("the branch point of Rayleigh's collapse takes most of the error of the series", "[studies][approximants]") {
    const precision_scope scope(40);
    const auto rows = rows_for("rayleigh", "2,50,100,200").at("");
    // sqrt(R) falls like the 2/5-th power: s(t) = (1 - (t/T)^2)^(2/5) is off by less than a hundredth [Obreschkow2012].
    CHECK(norm_in(rows, "asymptotic", 2) < 0.01);
    // N^-(2/5) of the series and N^-(8/5) of the approximant, from 100 to 200; no point is the end itself.
    CHECK(norm_in(rows, "series", 100) / norm_in(rows, "series", 200) == Approx(std::pow(2, 0.4)).epsilon(0.06));
    CHECK(norm_in(rows, "asymptotic", 100) / norm_in(rows, "asymptotic", 200) ==
          Approx(std::pow(2, 1.6)).epsilon(0.03));
}

TEST_CASE("approximants of Blasius' layer are best at a moderate order", "[studies][approximants]") {
    const precision_scope scope(40);
    const auto rows = rows_for("blasius", "10,50,160").at("");
    CHECK(norm_in(rows, "asymptotic", 10) > 1e-3);
    CHECK(norm_in(rows, "asymptotic", 50) < 1e-8);
    CHECK(norm_in(rows, "asymptotic", 160) > 1e-4);
    // At the radius 5.69 of f [Boyd1999], times k^(1/3) for k = 1, f is 8.8e-4 k^(-1/3) from its line: read off a
    // table.
    for (const table_row& row : rows) {
        if (row.at("method") == "asymptotic" && row.at("order") == "160") {
            CHECK(static_cast<double>(number_of(row.at("predicted"))) == Approx(8.8e-4 * 1.444).epsilon(0.35));
        }
    }
}

TEST_CASE("the Vandermonde system of SIR loses digits that the decay keeps", "[studies][approximants]") {
    const precision_scope scope(40);
    const auto rows = rows_for("sir", "4,24,60");
    CHECK(norm_in(rows.at(""), "asymptotic", 60) < 1e-3);
    CHECK(norm_in(rows.at(""), "pade", 60) > 1);
    const auto& losses = rows.at("digits");
    REQUIRE(losses.size() == 3);
    CHECK(number_of(losses[0].at("lost_digits")) < 2);
    CHECK(number_of(losses[2].at("lost_digits")) > 10);
    for (const table_row& row : losses) {
        CHECK(number_of(row.at("log10_decay")) < -14);
    }
}

TEST_CASE("published numbers are judged, and some of them do not hold", "[studies][approximants]") {
    const auto rows = rows_for("falkner_skan,sakiadis", "4").at("published");
    std::map<std::string, int> verdicts;
    for (const table_row& row : rows) {
        ++verdicts[row.at("verdict")];
        // f''(0) of Hiemenz's flow: public codes differ from each other, so that one of them errs.
        if (row.at("changes").starts_with("b = 1;")) {
            CHECK(row.at("verdict") == "fails");
        }
    }
    CHECK(verdicts["holds"] == 14);
    CHECK(verdicts["fails"] == 3);
}

TEST_CASE("what has no known far behaviour is refused with the names that have", "[studies][approximants]") {
    CHECK_THROWS_WITH(rows_for("lorenz", "4"), Catch::Contains("'lorenz'") && Catch::Contains("sir_japan"));
    CHECK_THROWS_WITH(rows_for("sir", "0"), Catch::Contains("not an order of an approximant"));
}

}  // namespace studies_approximants_test
