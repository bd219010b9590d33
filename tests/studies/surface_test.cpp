// The study surface: angles against closed forms and the reference of the other routes, and the error's two sources.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"
#include "text/input_error.hpp"

namespace studies_surface_test {

using namespace libration;
using namespace libration::tests;

namespace {

const study& surface() { return study_of("surface"); }

std::vector<table_row> rows_for(const study_words& words) {
    return csv_rows(to_csv(tables_of(order_of(surface(), words, 2)).front().data));
}

}  // namespace

TEST_CASE("the surface has the angles of Jacobi's functions and of the separatrix", "[studies][surface]") {
    // mpmath at 60 digits: libration 2 asin(k sn(t, k)), rotation 2 am(t/k, k) = 2 atan2(sn, cn) unwrapped, separatrix
    // 4 atan(exp t) - pi: `mp.dps = 60; ellipfun('sn', t, m=E/2)`, and so on.
    const std::map<std::string, std::string> expected{{"1.71", "-2.3576926918590822954456554692676663126556924743616"},
                                                      {"2", "3.1388904989000629507142195800005520946629162449689"},
                                                      {"2.02", "6.1538624328429958734254186894176413083149948710006"}};
    const auto rows = rows_for({{"--energies", "1.71,2,2.02"}, {"--times", "7.3"}, {"--period-by", "agm"}});
    REQUIRE(rows.size() == 3);
    for (const table_row& row : rows) {
        INFO("E = " << row.at("energy"));
        CHECK_THAT(row.at("theta"), right_to_the_last_digit(expected.at(row.at("energy"))));
        const precision_scope scope(60);
        const mpfr difference = abs(number_of(row.at("approximation")) - number_of(row.at("theta")));
        CHECK(abs(difference - number_of(row.at("error"))) <= last_place(row.at("theta")));
    }
    CHECK(rows[1].at("regime") == "separatrix");
    CHECK(rows[1].at("method") == "critical");
    CHECK(rows[1].at("error") == "0");
}

TEST_CASE("next to E = 2 the error of the surface is that of the period", "[studies][surface]") {
    const auto rows = rows_for(
        {{"--energies", "1.997"}, {"--times", "18.8"}, {"--period-by", "agm,resummed:60"}, {"--orders", "60"}});
    REQUIRE(rows.size() == 2);
    const precision_scope scope(40);
    CHECK(number_of(rows[0].at("error")) < mpfr("1e-5"));
    CHECK(number_of(rows[1].at("error")) > mpfr("1e-2"));
}

TEST_CASE("in double the closed solution at E = 2 keeps its rounding", "[studies][surface]") {
    const auto rows = rows_for({{"--energies", "2"}, {"--times", "0.7,3,9"}, {"--scalar", "double"}});
    const precision_scope scope(40);
    bool rounded = false;
    for (const table_row& row : rows) {
        const mpfr error = number_of(row.at("error"));
        rounded = rounded || error > 0;
        // Four times an arctangent of an exponential: a few roundings of pi.
        CHECK(error < 16 * epsilon<double>());
    }
    CHECK(rounded);
}

TEST_CASE("the surface refuses rest, and multiples of an infinite period", "[studies][surface]") {
    const auto tables = [](const study_words& words) { return tables_of(order_of(surface(), words, 1)); };
    CHECK_THROWS_AS(tables({{"--energies", "1,0"}}), libration::error);
    CHECK_THROWS_AS(tables({{"--energies", "1,2"}, {"--times", "0:T:3"}}), input_error);
    CHECK_NOTHROW(tables({{"--energies", "1"}, {"--times", "0:T:3"}, {"--orders", "3"}}));
}

}  // namespace studies_surface_test
