// The study resummations: that it agrees with error_norm where both measure the same, and what it shows.
#include <catch2/catch.hpp>
#include <map>
#include <string>

#include "studies/study_rows.hpp"

namespace studies_resummations_test {

using namespace libration;
using namespace libration::tests;

namespace {

// log10 of the norms by "method count".
std::map<std::string, mpfr> norms_of(const study_words& words) {
    std::map<std::string, mpfr> norms;
    for (const table_row& row : rows_of_study("resummations", words)) {
        if (row.at("norm") != "inf") {
            norms[row.at("method") + " " + row.at("count")] = number_of(row.at("log10_norm"));
        }
    }
    return norms;
}

}  // namespace

TEST_CASE("the norms of the series and of the paper's resummation are those of error_norm", "[studies][resummations]") {
    const precision_scope scope(40);
    int compared = 0;
    for (const table_row& row : rows_of_study("resummations", {{"--energies", "1.71,2.02"}, {"--orders", "6"}})) {
        if (row.at("method") != "series" && row.at("method") != "resummed") {
            continue;
        }
        INFO("E = " << row.at("energy") << ", " << row.at("method"));
        for (const table_row& other : rows_of_study(
                 "error_norm",
                 {{"--energies", row.at("energy")}, {"--orders", row.at("order")}, {"--scalar", "mpfr:20"}})) {
            if (other.at("method") == row.at("method")) {
                CHECK_THAT(row.at("norm"), right_to_the_last_digit(other.at("norm")));
                CHECK_THAT(row.at("bound"), right_to_the_last_digit(other.at("bound")));
                ++compared;
            }
        }
    }
    CHECK(compared == 4);
}

TEST_CASE("every norm is below its bound, and confirmed by the second route", "[studies][resummations]") {
    const precision_scope scope(40);
    for (const table_row& row :
         rows_of_study("resummations", {{"--energies", "0.5,4"}, {"--gaps", "1e-5"}, {"--orders", "4,12"}})) {
        INFO("gap " << row.at("gap") << ", " << row.at("method") << ", " << row.at("count"));
        if (row.at("norm") == "inf") {
            CHECK(row.at("method") == "pade");
            CHECK(row.at("rigour") == "heuristic");
            CHECK(row.at("log10_norm").empty());
            continue;
        }
        CHECK(row.at("rigour") == "two-method");
        if (!row.at("bound").empty()) {
            CHECK(number_of(row.at("norm")) <= number_of(row.at("bound")));
        }
        CHECK(row.at("bound").empty() == (row.at("method") == "pade"));
    }
}

TEST_CASE("a Pade approximant with a pole on the way has no norm", "[studies][resummations]") {
    const precision_scope scope(40);
    int poles = 0;
    for (const table_row& row : rows_of_study("resummations", {{"--energies", "1.71,1.99"}, {"--orders", "2"}})) {
        if (row.at("method") != "pade") {
            continue;
        }
        INFO(row.at("energy"));
        CHECK((row.at("norm") == "inf") == (row.at("energy") == "1.99"));
        if (row.at("norm") == "inf") {
            // t = (12/(E-1))^(1/2), as the test of arc_pade derives.
            const mpfr time = sqrt(mpfr(mpfr(12) / mpfr("0.99")));
            CHECK_THAT(row.at("time_of_maximum"), right_to_the_last_digit(to_decimal(time, 30)));
            ++poles;
        }
    }
    CHECK(poles == 1);
}

TEST_CASE("next to E = 2 only the uniform resummation gains by more coefficients", "[studies][resummations]") {
    const auto norms = norms_of({{"--gaps", "1e-6"}, {"--orders", "8,16"}});
    CHECK(norms.at("uniform 8") - norms.at("uniform 16") > 7);
    for (const std::string method : {"series", "resummed", "resummed_4", "resummed_8", "two_point", "pade"}) {
        INFO(method);
        CHECK(norms.at(method + " 8") - norms.at(method + " 16") < 3);
    }
    // At E = 0.1 the two-point expansion is the best of all.
    const auto slow = norms_of({{"--energies", "0.1"}, {"--orders", "16"}});
    CHECK(slow.at("two_point 16") < slow.at("uniform 16"));
    CHECK(slow.at("uniform 16") < slow.at("resummed_8 16"));
}

TEST_CASE("an odd count has no two-point expansion of rotation, and few no conditions", "[studies][resummations]") {
    const auto norms = norms_of({{"--energies", "4"}, {"--orders", "3"}});
    CHECK(norms.count("two_point 3") == 0);
    CHECK(norms.count("resummed_8 3") == 0);
    CHECK(norms.count("resummed_4 3") == 1);
}

TEST_CASE("E = 0, E = 2 and no coefficient are refused by the study resummations", "[studies][resummations]") {
    CHECK_THROWS_WITH(rows_of_study("resummations", {{"--energies", "2"}}), Catch::Contains("energy 2"));
    CHECK_THROWS_WITH(rows_of_study("resummations", {{"--energies", "0"}}), Catch::Contains("energy 0"));
    CHECK_THROWS_WITH(rows_of_study("resummations", {{"--energies", "1"}, {"--orders", "0"}}), Catch::Contains("0"));
}

}  // namespace studies_resummations_test
