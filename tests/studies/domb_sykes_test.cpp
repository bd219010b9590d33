// The study domb_sykes against closed forms of the first coefficients, parity, and the lattice of singularities.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "libration/pendulum/expansion_coverage.hpp"
#include "studies/study_rows.hpp"
#include "sweep/named_order.hpp"
#include "text/input_error.hpp"

namespace studies_domb_sykes_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

std::vector<table_row> rows_under(const std::string& suffix, const study_words& words) {
    return rows_by_suffix("domb_sykes", words).at(suffix);
}

}  // namespace

TEST_CASE("the first ratios are those of Taylor's theorem", "[studies][domb_sykes]") {
    const precision_scope scope(40);
    // About the bottom a_3 = -a_1/6 and a_5 = a_1 (1 + a_1^2)/120 with a_1^2 = 2 E, or its mirror image above 2; about
    // the top of libration a_2 = -sin(theta_0)/2 and a_4 = sin(theta_0) cos(theta_0)/24 with cos(theta_0) = 1 - E.
    for (const char* const energy : {"0.5", "1.71", "2.02"}) {
        const mpfr e = number_of(energy);
        std::map<std::string, mpfr> expected{{"1 2 3", mpfr(-1) / 6}, {"1 2 5", mpfr(-(1 + 2 * e) / 20)}};
        if (e < 2) {
            expected["0 2 4"] = (e - 1) / 12;
        }
        std::size_t seen = 0;
        for (const table_row& row : rows_under("", {{"--energies", energy}, {"--orders", "8"}, {"--points", "0,1"}})) {
            const auto found = expected.find(row.at("point") + " " + row.at("power") + " " + row.at("n"));
            if (found != expected.end()) {
                ++seen;
                CHECK_THAT(row.at("ratio"), right_to_the_last_digit_of(found->second));
            }
        }
        CHECK(seen == expected.size());
    }
}

TEST_CASE("in t parity divides every second time by 0, and at E = 1 three of four times", "[studies][domb_sykes]") {
    // About the top of libration a_0, a_2, a_4, ... are not 0: of 40 ratios the 20 with n even divide by 0, the others
    // are 0. At E = 1 a_0, a_2, a_6, ..., a_38 remain: 11 ratios are defined. About the bottom a_1, a_3, ... remain,
    // and a_0 = 0; but in rotation a_0 is pi or 2 pi, and a_1/a_0 defined and not 0.
    const std::map<std::string, std::string> undefined{{"0.5 0", "20"}, {"0.5 1", "20"},  {"1 0", "29"},
                                                       {"1 1", "20"},   {"2.02 0", "19"}, {"2.02 1", "19"}};
    std::map<std::string, std::string> last;
    for (const table_row& row :
         rows_under("lists", {{"--energies", "0.5,1,2.02"}, {"--orders", "40"}, {"--points", "0,1"}})) {
        const std::string place = row.at("energy") + " " + row.at("point");
        last[place] = row.at("power");
        if (row.at("power") == "1") {
            CHECK(row.at("ratios") == "40");
            CHECK(row.at("undefined") == undefined.at(place));
            CHECK(row.at("zero") == (place == "1 0" ? "11" : "20"));
            CHECK(row.at("limit").empty());
        }
    }
    CHECK(last == std::map<std::string, std::string>{
                      {"0.5 0", "2"}, {"0.5 1", "2"}, {"1 0", "4"}, {"1 1", "2"}, {"2.02 0", "2"}, {"2.02 1", "2"}});
}

TEST_CASE("in t^2 the plot about the bottom is straight, and about the top it scatters", "[studies][domb_sykes]") {
    const precision_scope scope(40);
    const study_words words{{"--energies", "0.5,1.71,2.02"}, {"--orders", "80"}, {"--points", "0,1"}};
    for (const table_row& row : rows_under("", words)) {
        const bool drawn = row.at("power") == "2" && row.at("point") == "1";
        CHECK(row.at("line").empty() != drawn);
        if (drawn && std::stoi(row.at("n")) >= 60) {
            // The next singularities are at 2 T* + i K~', at E = 0.5 at 1.86 K~': 1.86^-58 of the coefficient, five
            // times.
            CHECK(abs(number_of(row.at("scaled_ratio")) - number_of(row.at("line"))) < mpfr("1e-14"));
        }
    }
    for (const table_row& row : rows_under("lists", words)) {
        if (row.at("power") == "2") {
            const mpfr spread = number_of(row.at("largest")) - number_of(row.at("least"));
            CHECK((row.at("point") == "0" ? spread > 2 : spread < mpfr("0.03")));
            CHECK(row.at("limit") == (row.at("point") == "0" ? "" : "-1"));
        }
    }
}

TEST_CASE("the answers about a point of every kind are judged by the exact radius", "[studies][domb_sykes]") {
    const precision_scope scope(60);
    std::size_t verdicts = 0;
    for (const table_row& row :
         rows_under("intercepts", {{"--energies", "1,1.71"}, {"--orders", "12,50"}, {"--points", "0,1/2,1"}})) {
        const auto cover = coverage_from<mpfr>(motion::of_energy(read_exact(row.at("energy")).coefficient),
                                               read_exact(row.at("point")).coefficient);
        CHECK_THAT(row.at("exact"), right_to_the_last_digit_of(cover.radius));
        CHECK(row.at("radius").empty() == row.at("relative_error").empty());
        CHECK((!row.at("radius").empty() || !row.at("note").empty()));
        if (row.at("method") == "verdict" && row.at("order") == "50") {
            ++verdicts;
            const mpfr error = abs(number_of(row.at("radius")) - cover.radius);
            CHECK(error <= number_of(row.at("uncertainty")));
            CHECK(error < cover.radius * mpfr("1e-18"));
        }
    }
    CHECK(verdicts == 6);
}

TEST_CASE("what has no ratios is refused", "[studies][domb_sykes]") {
    CHECK_THROWS_AS(rows_under("", {{"--energies", "0"}}), libration::error);
    CHECK_THROWS_AS(rows_under("", {{"--energies", "1,2"}}), libration::error);
    CHECK_THROWS_AS(rows_under("", {{"--orders", "3"}}), input_error);
}

// (1 - 2t)^(-1/2): a_n/a_(n-1) = 2 - 1/n, which is the line itself.
TEST_CASE("with --prove the law of an equation is in further columns", "[studies][domb_sykes]") {
    const precision_scope scope(40);
    const auto order = order_asked("study", "domb_sykes", equation_words{"y' = y^3; y(0) = 1", {}},
                                   {{"--prove", "yes"}, {"--orders", "80"}}, 2);
    CHECK(order.command.find("--prove --orders") == std::string::npos);
    CHECK(order.command.ends_with("--prove"));
    const auto rows = rows_of_table(tables_of(order).front());
    REQUIRE(rows.size() == 80);
    for (const table_row& row : rows) {
        const mpfr truth = 2 - mpfr(1) / number_of(row.at("n"));
        CHECK(abs(mpfr(number_of(row.at("proved_limit")) - 2)) < mpfr("1e-28"));
        if (!row.at("law_ratio").empty()) {
            CHECK(abs(mpfr(number_of(row.at("law_ratio")) - truth)) <= number_of(row.at("law_error")));
            CHECK(abs(mpfr(number_of(row.at("proved_line")) - truth)) < mpfr("1e-28"));
            CHECK(number_of(row.at("deviation")) >= 0);
        }
    }
    CHECK(number_of(rows.back().at("deviation")) < mpfr("1e-10"));
    CHECK(rows.front().at("law_ratio").empty());
    CHECK_THROWS_AS(tables_of(order_asked("study", "domb_sykes", equation_words{"y'' = -y; y(0) = 0; y'(0) = 1", {}},
                                          {{"--prove", "yes"}, {"--orders", "8"}}, 1)),
                    error);
}

}  // namespace studies_domb_sykes_test
