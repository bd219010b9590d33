// The study expansion_point against mpmath, the error norms from the top, and what can be proved about the best point.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_expansion_point_test {

using namespace libration;
using namespace libration::tests;

namespace {

using tables_by_suffix = std::map<std::string, std::vector<table_row>>;

tables_by_suffix expansion_point(const study_words& words) { return rows_by_suffix("expansion_point", words); }

// The numbers of a column by energy and point.
std::map<std::string, std::map<std::string, mpfr>> by_point(const std::vector<table_row>& rows,
                                                            const std::string& name) {
    std::map<std::string, std::map<std::string, mpfr>> numbers;
    for (const table_row& row : rows) {
        numbers[row.at("energy")][row.at("point")] = number_of(row.at(name));
    }
    return numbers;
}

}  // namespace

TEST_CASE("the radius about each point of the way is that of mpmath to the last digit", "[studies][expansion_point]") {
    // mpmath, 60 digits: sqrt(((1-x) T*)^2 + K'^2) with T* = ellipk(E/2), K' = ellipk(1-E/2), or sqrt(2/E) times
    // ellipk(2/E) and ellipk(1-2/E); x = 0, 1/4, 1/2, 3/4, 1.
    const std::map<std::string, std::vector<std::string>> tabulated{
        {"0.5",
         {"2.7372091620228073045683660639578977153213108", "2.49980929441790155838866052881717309592392481",
          "2.31538297104356018932640850234524879426083889", "2.19730957743389679837571719694310582464520393",
          "2.15651564749964323543867499880032202886411022"}},
        {"1.71",
         {"2.90669962925582283596766907887626079813041493", "2.43291049454362034366419134036415911600773258",
          "2.02781120634139163932085772922661578985447974", "1.74005665914236196267573523401619853101928497",
          "1.63290849095910067916538977551587693207326797"}},
        {"2.02",
         {"4.00171085490260204747390648017070599686684044", "3.1751894208016230063139506680135788990978003",
          "2.4175987338212856015744719584859013926644673", "1.81729389633502199034561477153599683216885736",
          "1.56689127306819635838384657341142323770881034"}}};
    const auto rows = expansion_point({{"--energies", "0.5,1.71,2.02"}, {"--orders", "4"}}).at("");
    REQUIRE(rows.size() == 15);
    std::map<std::string, std::size_t> seen;
    for (const table_row& row : rows) {
        const std::string& energy = row.at("energy");
        INFO("E = " << energy << ", x = " << row.at("point"));
        CHECK(significant_digits(row.at("radius")) == 40);
        CHECK_THAT(row.at("radius"), right_to_the_last_digit(tabulated.at(energy)[seen[energy]++]));
        CHECK(row.at("measured_rate").empty());
    }
}

TEST_CASE("the largest radius is at the top and the best rate half way, at every energy",
          "[studies][expansion_point]") {
    const precision_scope scope(50);
    const auto rows = expansion_point({{"--energies", "1e-3,0.05,0.5,1,1.5,1.9998,2.0002,2.5,4,8,1000"},
                                       {"--orders", "4"},
                                       {"--points", "0,1/4,49/100,1/2,51/100,3/4,1"}})
                          .at("");
    for (const auto& [energy, radius] : by_point(rows, "radius")) {
        INFO("E = " << energy);
        for (const auto& [point, value] : radius) {
            CHECK((point == "0" || value < radius.at("0")));
        }
    }
    for (const auto& [energy, rate] : by_point(rows, "rate")) {
        INFO("E = " << energy);
        for (const auto& [point, value] : rate) {
            CHECK((point == "1/2" || value > rate.at("1/2")));
        }
    }
}

TEST_CASE("from the bottom the series covers the way below E = 1 and above E = 4 alone", "[studies][expansion_point]") {
    const auto rows = expansion_point({{"--energies", "0.9999,1,1.0001,1.71,2.02,3.9999,4,4.0001"},
                                       {"--gaps", "1e-30,-1e-30"},
                                       {"--orders", "4"},
                                       {"--points", "0,1/2,1"}})
                          .at("");
    const std::map<std::string, std::string> at_bottom{
        {"0.9999", "yes"}, {"1", "boundary"}, {"4", "boundary"}, {"4.0001", "yes"}};
    for (const table_row& row : rows) {
        INFO("E = " << row.at("energy") << ", x = " << row.at("point"));
        const auto expected = at_bottom.find(row.at("energy"));
        const bool bottom = row.at("point") == "1";
        CHECK(row.at("covers") == (!bottom ? "yes" : expected == at_bottom.end() ? "no" : expected->second));
    }
}

TEST_CASE("the norms are those of mpmath", "[studies][expansion_point]") {
    // mpmath: the Taylor polynomial by (pendseries) against 2 asin(k cd) and 2 pi + 2 asin(sn), searched over 401
    // points and by golden section; all three are largest at an end.
    struct sample {
        std::string energy, point, order, norm;
    };
    const precision_scope scope(40);
    for (const auto& [energy, point, order, norm] :
         {sample{"0.5", "1", "9", "0.016018400104125"}, sample{"2.02", "1/2", "12", "0.0068344784422948"},
          sample{"1.71", "1/4", "20", "0.00026550681800753"}}) {
        const auto rows =
            expansion_point({{"--energies", energy}, {"--points", point}, {"--orders", order}}).at("norms");
        REQUIRE(rows.size() == 1);
        CHECK_THAT(rows[0].at("norm"), right_to_the_last_digit(norm));
        CHECK(abs(number_of(rows[0].at("log10_norm")) - log10(number_of(norm))) < mpfr("1e-11"));
    }
}

TEST_CASE("about the top the norms are those of the study error_norm", "[studies][expansion_point]") {
    const study_words words{{"--energies", "0.05,1.71,2.02"}, {"--orders", "10,40"}};
    auto there = words;
    there["--scalar"] = "mpfr:30";
    auto here = words;
    here["--points"] = "0";
    std::map<std::string, std::string> expected;
    for (const auto& [suffix, rows] : rows_by_suffix("error_norm", there)) {
        for (const table_row& row : rows) {
            if (row.at("method") == "series") {
                expected[row.at("energy") + " " + row.at("order")] = row.at("norm");
            }
        }
    }
    const auto rows = expansion_point(here).at("norms");
    REQUIRE(rows.size() == 6);
    for (const table_row& row : rows) {
        CHECK_THAT(row.at("norm"), right_to_the_last_digit(expected.at(row.at("energy") + " " + row.at("order"))));
    }
}

TEST_CASE("the measured rates are those of theory", "[studies][expansion_point]") {
    const precision_scope scope(40);
    const auto rows = expansion_point({{"--energies", "0.5,1.71,2.02,4.5"}, {"--orders", "40,160"}}).at("");
    const auto theory = by_point(rows, "rate");
    for (const auto& [energy, measured] : by_point(rows, "measured_rate")) {
        for (const auto& [point, rate] : measured) {
            INFO("E = " << energy << ", x = " << point);
            // (40/160)^(1/120) = 0.988 for the 1/n; a factor 10 by the oscillation would be 10^(1/120) = 1.02.
            CHECK(abs(rate / theory.at(energy).at(point) - mpfr("0.988")) < mpfr("0.02"));
        }
    }
}

TEST_CASE("double measures the same norms above its floor", "[studies][expansion_point]") {
    const precision_scope scope(40);
    study_words words{{"--energies", "1.71,2.02"}, {"--orders", "10"}};
    const auto exact = expansion_point(words).at("norms");
    words["--scalar"] = "double";
    const auto rounded = expansion_point(words).at("norms");
    REQUIRE(rounded.size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const mpfr norm = number_of(exact[i].at("norm"));
        // 1001 points miss the exact maximum by 1e-4 of it at most; rounding adds some 1e-15 theta.
        CHECK(abs(number_of(rounded[i].at("norm")) - norm) <= norm * mpfr("1e-4") + mpfr("1e-13"));
    }
}

TEST_CASE("energies without a way from the top to the bottom are refused", "[studies][expansion_point]") {
    CHECK_THROWS_AS(expansion_point({{"--energies", "0"}}), libration::error);
    CHECK_THROWS_AS(expansion_point({{"--energies", "1,2"}}), libration::error);
}

}  // namespace studies_expansion_point_test
