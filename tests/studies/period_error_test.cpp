// The study period_error: its errors against mpmath and against the sums themselves, its bounds, and its refusals.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_period_error_test {

using namespace libration;
using namespace libration::tests;

namespace {

const study& period_error() { return study_of("period_error"); }

std::vector<table_row> rows_for(const study_words& words) {
    const study_order order = order_of(period_error(), words, 2);
    return csv_rows(to_csv(tables_of(order).front().data));
}

struct expected_error {
    std::string energy, order, method, error;
};

}  // namespace

// /usr/bin/python3 -c "
// from mpmath import *
// mp.dps = 460
// for E, N in [('1e-3', 100), ('0.5', 20), ('1.71', 1), ('1.9998', 100), ('2.02', 10), ('4', 50)]:
//     e = mpf(E); m, r = (e/2, 1) if e < 2 else (2/e, sqrt(e/2))
//     c = [pi/2*binomial(2*n, n)**2/mpf(16)**n for n in range(N + 1)]
//     K = ellipk(m)
//     old = K - sum(c[n]*m**n for n in range(N + 1))
//     new = K - sum((c[n] - mpf(1)/(2*n + 1))*m**n for n in range(N + 1)) - atanh(sqrt(m))/sqrt(m)
//     print(E, N, nstr(old/r, 45), nstr(new/r, 45))"
TEST_CASE("the errors are those of mpmath to the last digit", "[studies][period_error]") {
    const std::vector<expected_error> expected{
        {"1e-3", "100", "series", "1.94876361933126553662399576593981157728880895e-336"},
        {"1e-3", "100", "resummed", "4.79396151901452229347980024617735292520852175e-339"},
        {"0.5", "20", "series", "7.02889678710685934155061721786570968168270657e-15"},
        {"0.5", "20", "resummed", "8.01517216418756035277939762000865633685100828e-17"},
        {"1.71", "1", "series", "0.498131508454746665447245558869687930400083563"},
        {"1.71", "1", "resummed", "0.0308576912447731532947544217254063152731735912"},
        {"1.9998", "100", "series", "2.01528892012132643893193008576693253428677147"},
        {"1.9998", "100", "resummed", "0.00117563144784645659931061204635082714613087516"},
        {"2.02", "10", "series", "0.878677184995203499489894594152968521783665067"},
        {"2.02", "10", "resummed", "0.00806388801513935813133127058443361921627516951"},
        {"4", "50", "series", "6.0140312589132332178329854479334078271507783e-18"},
        {"4", "50", "resummed", "2.86080561222283381525769337371413887883399447e-20"},
    };
    for (const expected_error& each : expected) {
        INFO("E = " << each.energy << ", N = " << each.order << ", " << each.method);
        const auto rows = rows_for({{"--energies", each.energy}, {"--orders", each.order}});
        REQUIRE(rows.size() == 2);
        const table_row& row = rows.at(each.method == "series" ? 0 : 1);
        CHECK(row.at("method") == each.method);
        CHECK(significant_digits(row.at("error")) >= 39);  // trailing zeros are digits too
        CHECK_THAT(row.at("error"), right_to_the_last_digit(each.error));
    }
}

TEST_CASE("no error of T* is above its bound, and none is less than a third below it", "[studies][period_error]") {
    const precision_scope scope(60);
    std::size_t seen = 0;
    for (const table_row& row :
         rows_for({{"--energies", "1e-3,0.5,1.71,2.02,4,1000"}, {"--gaps", "1e-3,-1e-3,1e-10,-1e-10,1e-30"}})) {
        INFO("E = " << row.at("energy") << ", N = " << row.at("order") << ", " << row.at("method"));
        // Seven digits of the ratio are printed, and it is above 1 by 1/(16 N^2) or more where it is nearest.
        CHECK(number_of(row.at("bound_over_error")) >= 1);
        CHECK(number_of(row.at("bound_over_error")) < mpfr(3) / 2);
        CHECK(abs(number_of(row.at("log10_error")) - log10(number_of(row.at("error")))) < mpfr("1e-9"));
        CHECK(abs(number_of(row.at("log10_bound")) - log10(number_of(row.at("bound")))) < mpfr("1e-9"));
        ++seen;
    }
    CHECK(seen == 11 * 6 * 2);
}

TEST_CASE("error and sum add up to one T* at all orders and in both methods", "[studies][period_error]") {
    const precision_scope scope(60);
    const auto rows = rows_for({{"--energies", "1.71"}, {"--orders", "1,5,30"}});
    const mpfr truth = number_of(rows.front().at("tstar")) + number_of(rows.front().at("error"));
    for (const table_row& row : rows) {
        // Both numbers have 40 digits, T* being 2.4.
        CHECK(abs(number_of(row.at("tstar")) + number_of(row.at("error")) - truth) < mpfr("1e-38"));
    }
}

TEST_CASE("next to E = 2 the resummed T* misses 1/(8N + 7)", "[studies][period_error]") {
    const precision_scope scope(60);
    for (const table_row& row : rows_for({{"--gaps", "1e-20,-1e-20"}, {"--orders", "10,100"}})) {
        if (row.at("method") == "resummed") {
            // The tail of the brackets is (1 - 15/(16 N) + O(N^-2))/(8N), which is (1 - 1/(16 N) + ...)/(8N + 7).
            const int order = std::stoi(row.at("order"));
            CHECK(abs(1 - number_of(row.at("error")) * (8 * order + 7)) * 15 * order < 1);
        }
    }
}

TEST_CASE("a fixed scalar shows its rounding", "[studies][period_error]") {
    const precision_scope scope(60);
    const auto rows = rows_for({{"--energies", "0.5"}, {"--orders", "5,100"}, {"--scalar", "double"}});
    CHECK(rows.at(0).at("scalar") == "double");
    const mpfr unit = ldexp(mpfr(1), -52);
    CHECK(number_of(rows.at(2).at("error")) <= unit * 4);  // of T* = 1.69, an ulp in each of a few operations
    CHECK(abs(number_of(rows.at(0).at("error")) - number_of(rows.at(0).at("bound"))) < mpfr("1e-4"));
}

TEST_CASE("E = 0 and E = 2 have no error of T*", "[studies][period_error]") {
    CHECK_THROWS_AS(rows_for({{"--energies", "2"}}), libration::error);
    CHECK_THROWS_WITH(rows_for({{"--energies", "1,0"}}), Catch::Contains("has the energy 0"));
    CHECK_THROWS_WITH(rows_for({{"--gaps", "0"}}), Catch::Contains("has the energy 2"));
}

}  // namespace studies_period_error_test
