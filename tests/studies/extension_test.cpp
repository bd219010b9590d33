// The four studies of an approximation extended to two periods: libration_series, rotation_series,
// near_separatrix_series and near_separatrix_resummed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_extension_test {

using namespace libration;
using namespace libration::tests;

namespace {

// The rows of one table of a run; the march is short, for the tests are.
std::vector<table_row> rows_of_table(const std::string& name, const std::string& suffix, study_words words) {
    words.emplace("--step", "1e-2");
    for (const study_table& part : tables_of(order_of(study_of(name), words, 2))) {
        if (part.suffix == suffix) {
            return csv_rows(to_csv(part.data));
        }
    }
    throw std::runtime_error(name + " makes no table " + suffix);
}

struct tabulated {
    std::string study, energy, time;
    std::string order;
    std::string theta, error;
};

}  // namespace

TEST_CASE("values and errors are those of the printed recurrence and of the integrated equation",
          "[studies][extension]") {
    // mpmath at 60 digits: a_n by (pendseries), alpha and beta solved from theta* and omega*, (newseries) as printed;
    // the truth by 160 Taylor steps of degree 60 through the equation itself.
    const std::vector<tabulated> all{
        {"libration_series", "1.71", "3T/16", "6", "1.02772909073247914790876422335417844448",
         "0.0219397987355222248961325650357"},
        {"libration_series", "1.71", "5T/8", "4", "-1.807750768731222085547779502942637450679",
         "0.00378693582984669058643878731244"},
        {"rotation_series", "2.02", "13T/32", "6", "5.016075876910878965984610350225115761106",
         "0.021994985484141511255002038665"},
        {"rotation_series", "2.02", "25T/16", "36", "13.46050339199076584767969514532492435563",
         "0.0000159658131421791641372339770074"},
        {"near_separatrix_series", "1.9998", "T/4", "20", "0.1330727267605706541554349095973345897653",
         "0.133072726760570654155434909597"},
        {"near_separatrix_series", "1.9998", "27T/16", "10", "-2.254036240189770284427379423350087350458",
         "0.00749296247320938962866295515895"},
        {"near_separatrix_resummed", "1.9998", "7T/32", "20", "1.376097114052736723102904525016960973866",
         "0.00138902382833285757895604985916"},
        {"near_separatrix_resummed", "1.9998", "15T/8", "5", "2.913637447157703241150933428720928286796",
         "0.0276203641089704046206635956532"}};
    for (const tabulated& each : all) {
        INFO(each.study << " at " << each.time << ", N = " << each.order);
        const auto rows = rows_of_table(
            each.study, "",
            {{"--energies", each.energy}, {"--orders", each.order}, {"--times", each.time}, {"--scalar", "mpfr:25"}});
        REQUIRE(rows.size() == 1);
        CHECK_THAT(rows[0].at("theta"), right_to_the_last_digit(each.theta));
        CHECK_THAT(rows[0].at("error"), right_to_the_last_digit(each.error));
        CHECK(abs(number_of(rows[0].at("log10_error")) - log10(number_of(each.error))) < mpfr("1e-10"));
    }
}

TEST_CASE("errors far below the digits printed are right too, and 0 where the approximation is exact",
          "[studies][extension]") {
    // Libration: theta - sigma_20 = a_22 t^22 (1 + O(t^2)), so that a time 10^5 times smaller has an error 10^110 times
    // smaller, up to 1e-10 of it.
    const auto rows = rows_of_table("libration_series", "", {{"--orders", "20"}, {"--times", "0,1e-10,1e-5,T/2,-T"}});
    REQUIRE(rows.size() == 5);
    const precision_scope scope(60);
    const mpfr ratio = number_of(rows[1].at("error")) / number_of(rows[2].at("error")) * pow(mpfr(10), 110);
    CHECK(abs(ratio - 1) < mpfr("1e-9"));
    CHECK(number_of(rows[1].at("error")) > 0);
    for (const std::size_t top : {0U, 3U, 4U}) {
        CHECK(rows[top].at("error") == "0");
        CHECK(rows[top].at("log10_error") == "-inf");
        CHECK(rows[top].at("omega") == "0");
    }
    const auto bottom = rows_of_table("near_separatrix_resummed", "", {{"--orders", "5"}, {"--times", "T/4"}});
    CHECK(bottom.at(0).at("theta") == "0");
    CHECK(bottom.at(0).at("error") == "0");
}

TEST_CASE("the numerical solution has at most 41 of the times, with errors of fourth order", "[studies][extension]") {
    const auto error_at = [](const std::string& step) {
        const auto rows = rows_of_table("libration_series", "numerical", {{"--times", "0:T:101"}, {"--step", step}});
        CHECK(rows.size() == 41);
        CHECK(rows.front().at("time") == "0");
        CHECK(rows.back().at("periods") == "1.00000000000");
        CHECK(rows[20].at("periods") == "0.500000000000");
        CHECK(rows[20].at("method") == "rk4");
        return number_of(rows[17].at("error"));
    };
    const precision_scope scope(30);
    // Not at T/2, where by symmetry the fourth order cancels and the fifth is left.
    const mpfr ratio = error_at("1/32") / error_at("1/64");
    CHECK(ratio > 12);
    CHECK(ratio < 20);
}

TEST_CASE("the exact table is the reference table", "[studies][extension]") {
    const auto rows = rows_of_table("rotation_series", "exact", {{"--times", "0,T/2,3T/2"}, {"--scalar", "mpfr:30"}});
    REQUIRE(rows.size() == 3);
    // From the top, pi, counterclockwise: the bottoms are at whole turns with the speed sqrt(2E).
    CHECK_THAT(rows[1].at("theta"), right_to_the_last_digit("6.28318530717958647692528676655900576839433879875"));
    CHECK_THAT(rows[2].at("theta"), right_to_the_last_digit("12.5663706143591729538505735331180115367886775975"));
    CHECK_THAT(rows[1].at("omega"), right_to_the_last_digit("2.00997512422417805404385298255191523738900"));
    CHECK(rows[1].at("error").empty());
}

TEST_CASE("fixed scalars keep the errors of mpfr down to their rounding", "[studies][extension]") {
    const study_words words{{"--orders", "20"}, {"--times", "0:2T:17"}};
    auto in_double = words;
    in_double["--scalar"] = "double";
    const auto exact = rows_of_table("near_separatrix_resummed", "", words);
    const auto rounded = rows_of_table("near_separatrix_resummed", "", in_double);
    REQUIRE(rounded.size() == exact.size());
    const precision_scope scope(40);
    for (std::size_t i = 0; i < exact.size(); ++i) {
        // Some 20 roundings of terms of 4 and less.
        CHECK(abs(number_of(rounded[i].at("error")) - number_of(exact[i].at("error"))) < 80 * epsilon<double>());
    }
}

TEST_CASE("E = 0 and E = 2 are refused before any work", "[studies][extension]") {
    for (const std::string name :
         {"libration_series", "rotation_series", "near_separatrix_series", "near_separatrix_resummed"}) {
        for (const std::string energy : {"0", "2"}) {
            const auto run = [&] { order_of(study_of(name), {{"--energies", "1.5," + energy}}, 1); };
            CHECK_THROWS_AS(run(), libration::error);
            CHECK_THROWS_WITH(run(), Catch::Contains("has the energy " + energy + ","));
        }
    }
}

}  // namespace studies_extension_test
