// The study all_time: errors against (newseries) in other arithmetic, and how the two reductions of time grow.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_all_time_test {

using namespace libration;
using namespace libration::tests;

namespace {

const study& all_time() { return study_of("all_time"); }

std::vector<table_row> rows_for(const study_words& words, std::size_t table = 0) {
    return csv_rows(to_csv(tables_of(order_of(all_time(), words, 2)).at(table).data));
}

}  // namespace

TEST_CASE("late errors are those of the exact descent folded by (newseries) as printed", "[studies][all_time]") {
    // mpmath at 60 digits: K by (Kold) and (Knew), the fundamental arc by sn, cn, dn, and (newseries) with that T* at
    // the 129 times.
    struct expected_row {
        std::string energy, rule, periods, period_error, error;
    };
    const std::vector<expected_row> all{
        {"1.71", "resummed:10", "1000", "0.0026698934839721654512996701638", "3.86575744819801235768179539005"},
        {"1.71", "series:40", "1", "0.000482363761240476621546247006387", "0.0017840936778469365956329392294"},
        {"2.02", "resummed:40", "1000000", "0.00234487116995866155866430247885", "2003.15259199802183855847664518"},
        {"4", "resummed:10", "10", "0.00000115043397720832486786823370391", "0.0000357931053290669916035184152097"},
    };
    for (const expected_row& each : all) {
        INFO("E = " << each.energy << ", T* by " << each.rule << ", p = " << each.periods);
        const auto rows =
            rows_for({{"--energies", each.energy}, {"--period-by", each.rule}, {"--periods", each.periods}});
        REQUIRE(rows.size() == 1);
        const precision_scope scope(60);
        // The expected texts have 30 digits.
        CHECK(abs(number_of(rows[0].at("period_error")) / number_of(each.period_error) - 1) < mpfr("1e-27"));
        CHECK(abs(number_of(rows[0].at("error")) / number_of(each.error) - 1) < mpfr("1e-27"));
    }
}

TEST_CASE("the error after p periods is p + 1 errors of the period, and none with the exact one",
          "[studies][all_time]") {
    const auto rows =
        rows_for({{"--energies", "0.5,4"}, {"--period-by", "resummed:40,agm"}, {"--periods", "0,1,1000,1e6"}});
    REQUIRE(rows.size() == 16);
    const precision_scope scope(40);
    for (const table_row& row : rows) {
        INFO("E = " << row.at("energy") << ", p = " << row.at("periods") << ", " << row.at("period_by"));
        if (row.at("period_by") == "agm") {
            CHECK(row.at("error") == "0");
            CHECK(row.at("log10_error") == "-inf");
            continue;
        }
        // The motion is off by less than 1e-9 of time, and omega next to its maximum by the square of that.
        CHECK(abs(number_of(row.at("error")) / number_of(row.at("predicted")) - 1) < mpfr("1e-15"));
    }
}

TEST_CASE("time reduced exactly keeps the rounding of the scalar, the remainder of rounded times loses it",
          "[studies][all_time]") {
    for (const table_row& row : rows_for({{"--energies", "1.71,2.02"}, {"--periods", "1,1000000000"}}, 1)) {
        INFO(row.at("scalar") << ", " << row.at("reduction") << ", E = " << row.at("energy")
                              << ", p = " << row.at("periods"));
        const precision_scope scope(60);
        const mpfr unit = row.at("scalar") == "double"        ? widen(epsilon<double>())
                          : row.at("scalar") == "long-double" ? widen(epsilon<long double>())
                                                              : widen(epsilon<quad>());
        const mpfr error = number_of(row.at("error"));
        if (row.at("reduction") == "exact") {
            CHECK(error < unit * 20);  // exact_solution: a few epsilon of an angle up to 2 pi
            CHECK(row.at("predicted").empty());
        } else {
            CHECK(error < number_of(row.at("predicted")) + unit * 20);
            CHECK((row.at("periods") == "1" || error > number_of(row.at("predicted")) / 100));
        }
    }
}

TEST_CASE("late times have no meaning at E = 0 and E = 2", "[studies][all_time]") {
    CHECK_THROWS_AS(rows_for({{"--energies", "0"}}), libration::error);
    CHECK_THROWS_AS(rows_for({{"--energies", "1,2"}}), libration::error);
}

}  // namespace studies_all_time_test
