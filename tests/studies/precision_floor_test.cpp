// The study precision_floor: exact norms against those of error_norm's tables, floors against epsilon, refusals.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_precision_floor_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<table_row> rows_for(const study_words& words) { return rows_of_study("precision_floor", words); }

}  // namespace

TEST_CASE("each arithmetic follows the exact norm down to a few epsilon", "[studies][precision_floor]") {
    const precision_scope scope(60);
    const std::map<std::string, int> bits{{"double", 53}, {"long-double", 64}, {"quad", 113}};
    for (const table_row& row : rows_for({{"--energies", "0.5,2.02"}, {"--orders", "3,40,160"}})) {
        INFO("E = " << row.at("energy") << ", N = " << row.at("order") << ", " << row.at("method") << ", "
                    << row.at("scalar"));
        const mpfr unit = number_of(row.at("epsilon"));
        if (bits.contains(row.at("scalar"))) {
            CHECK(abs(unit / ldexp(mpfr(1), 1 - bits.at(row.at("scalar"))) - 1) < mpfr("1e-11"));
        } else {
            CHECK(unit < mpfr("1e-39"));  // 40 digits and at most 64 bits more, as MPFR rounds up to bits
            CHECK(unit > mpfr("1e-60"));
        }
        // theta and the coefficients' sum stay below 2 pi, and each is right to a few units: 20 epsilon pi.
        const mpfr difference = abs(number_of(row.at("norm")) - number_of(row.at("exact_norm")));
        CHECK(difference <= unit * pi<mpfr>() * 20 + number_of(row.at("norm")) * mpfr("1e-11"));
        CHECK((row.at("floor") == "yes") == (number_of(row.at("exact_norm")) * 2 < number_of(row.at("norm"))));
        CHECK(abs(number_of(row.at("norm_in_epsilon")) * unit / number_of(row.at("norm")) - 1) < mpfr("1e-5"));
    }
}

TEST_CASE("at a high order all arithmetics but the last show their floor", "[studies][precision_floor]") {
    const precision_scope scope(60);
    for (const table_row& row : rows_for({{"--energies", "0.5"}, {"--orders", "300"}})) {
        INFO(row.at("scalar") << ", " << row.at("method"));
        CHECK(row.at("floor") == "yes");
        // theta is 1 at most: the nearest number of the arithmetic misses it by up to a quarter of epsilon somewhere.
        CHECK(number_of(row.at("norm_in_epsilon")) > mpfr(1) / 8);
        CHECK(number_of(row.at("norm_in_epsilon")) < 10);
    }
}

TEST_CASE("exact norms and norms of the fixed scalars are those of error_norm", "[studies][precision_floor]") {
    const precision_scope scope(60);
    const study_words words{{"--energies", "1.71"}, {"--orders", "10,60"}};
    study_words in_double = words;
    in_double["--scalar"] = "double";
    study_words in_mpfr = words;
    in_mpfr["--scalar"] = "mpfr:20";
    const auto floors = rows_for(in_double);
    const auto rounded = rows_of_study("error_norm", in_double);
    const auto exact = rows_of_study("error_norm", in_mpfr);
    REQUIRE(floors.size() == 4);
    for (std::size_t i = 0; i < floors.size(); ++i) {
        CHECK_THAT(floors.at(i).at("norm"), right_to_the_last_digit(rounded.at(i).at("norm")));
        CHECK_THAT(floors.at(i).at("exact_norm"), right_to_the_last_digit(exact.at(i).at("norm")));
    }
}

TEST_CASE("at orders where the bound is far below epsilon floors are measured without an exact norm",
          "[studies][precision_floor]") {
    const precision_scope scope(60);
    const auto rows = rows_for({{"--energies", "0.5"}, {"--orders", "600"}, {"--scalar", "double"}});
    REQUIRE(rows.size() == 2);
    for (const table_row& row : rows) {
        CHECK(row.at("exact_norm").empty());
        CHECK(row.at("floor") == "yes");
        CHECK(number_of(row.at("norm_in_epsilon")) > mpfr(1) / 8);
        CHECK(number_of(row.at("norm_in_epsilon")) < 10);
    }
}

TEST_CASE("the floor is measured for each recurrence, and the usual one is named", "[studies][precision_floor]") {
    const precision_scope scope(60);
    const study_words words{{"--energies", "1.71"}, {"--orders", "10"}, {"--scalar", "double"}};
    study_words chosen = words;
    chosen["--recurrence"] = "printed,squares,omega,lattice";
    const auto usual = rows_for(words);
    const auto all = rows_for(chosen);
    REQUIRE(all.size() == 4 * usual.size());
    for (const table_row& row : all) {
        INFO(row.at("recurrence"));
        // The exact norm of the order 10 is far above the rounding of double.
        CHECK(abs(number_of(row.at("norm")) / number_of(row.at("exact_norm")) - 1) < mpfr("1e-9"));
    }
    CHECK(usual.at(0).at("recurrence") == "squares");
    CHECK(all.at(1).at("recurrence") == "squares");
    CHECK_THAT(all.at(1).at("norm"), right_to_the_last_digit(usual.at(0).at("norm")));
    CHECK_THROWS_WITH(rows_for({{"--energies", "1"}, {"--recurrence", "printde"}}), Catch::Contains("printde"));
}

TEST_CASE("E = 0 and E = 2 have no floor", "[studies][precision_floor]") {
    CHECK_THROWS_WITH(rows_for({{"--energies", "2"}}), Catch::Contains("energy 2"));
    CHECK_THROWS_AS(rows_for({{"--energies", "0"}}), libration::error);
}

}  // namespace studies_precision_floor_test
