// The study divergence: the first terms of the series written out, the exact angle and the radius by mpmath, and what
// more terms do on both sides of the radius.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "studies/study_rows.hpp"

namespace studies_divergence_test {

using namespace libration;
using namespace libration::tests;

namespace {

const study& divergence() { return study_of("divergence"); }

struct found_tables {
    std::vector<table_row> sums;
    std::vector<table_row> radius;
};

found_tables tables_for(const study_words& words) {
    const auto tables = tables_of(order_of(divergence(), words, 2));
    REQUIRE(tables.size() == 2);
    CHECK(tables.at(0).suffix.empty());
    CHECK(tables.at(1).suffix == "radius");
    return {csv_rows(to_csv(tables.at(0).data)), csv_rows(to_csv(tables.at(1).data))};
}

}  // namespace

// /usr/bin/python3 -c "
// from mpmath import *
// mp.dps = 70
// m, r = mpf('0.855'), 1                      # E = 1.71; E = 2.02: m, r = 2/mpf('2.02'), sqrt(mpf('1.01'))
// Ts = ellipk(m)/r
// print(Ts, ellipk(1-m)/r, -2*asin(sqrt(m)*ellipfun('sn', Ts/2, m=m)))
// # rotation: 2*pi + 2*asin(ellipfun('sn', r*Ts/4, m=m))"
TEST_CASE("angles, T* and R are those of mpmath to the last digit", "[studies][divergence]") {
    const auto found = tables_for({{"--energies", "1.71,2.02"}, {"--times", "T/8"}, {"--orders", "1"}});
    CHECK_THAT(found.radius.at(0).at("tstar"),
               right_to_the_last_digit("2.4046855501020524370392622620974362432472407426333"));
    CHECK_THAT(found.radius.at(0).at("radius"),
               right_to_the_last_digit("1.632908490959100679165389775515876932073267970408"));
    CHECK_THAT(found.radius.at(0).at("period"),
               right_to_the_last_digit("9.618742200408209748157049048389744972988962970533"));
    CHECK_THAT(found.sums.at(0).at("theta_exact"),
               right_to_the_last_digit("-1.8115377045610687761342182902550767442708180051446"));
    CHECK_THAT(found.sums.at(0).at("time"), right_to_the_last_digit("1.20234277505102621851963113104871812162362037"));
    CHECK(number_of(found.sums.at(0).at("periods")) == decimal("0.125").value);
    CHECK_THAT(found.radius.at(1).at("tstar"),
               right_to_the_last_digit("3.6821924860914103291985717217316260818598922702127"));
    CHECK_THAT(found.radius.at(1).at("radius"),
               right_to_the_last_digit("1.5668912730681963583838465734114232377088103392868"));
    CHECK_THAT(found.radius.at(1).at("period"),
               right_to_the_last_digit("7.3643849721828206583971434434632521637197845404255"));
    CHECK_THAT(found.sums.at(1).at("theta_exact"),
               right_to_the_last_digit("7.917042291109626788940836050398931370032757427526"));
}

TEST_CASE("the first partial sums are those of the equation differentiated by hand", "[studies][divergence]") {
    // theta'' = -sin theta from (theta_0, w) with sin theta_0 = 0, cos theta_0 = 1: theta''' = -w, theta^(5) = w^3 + w.
    const precision_scope scope(80);
    const auto found = tables_for({{"--energies", "1.71,2.02"}, {"--times", "1/3,7"}, {"--orders", "2,3,6"}});
    REQUIRE(found.sums.size() == 12);
    for (const table_row& row : found.sums) {
        INFO("E = " << row.at("energy") << ", N = " << row.at("order") << ", t = " << row.at("time"));
        const bool rotates = row.at("energy") == "2.02";
        const mpfr t = row.at("time").front() == '7' ? mpfr(7) : mpfr(mpfr(1) / 3);
        const mpfr w = sqrt(number_of(row.at("energy")) * 2) * (rotates ? 1 : -1);
        mpfr sum = (rotates ? mpfr(pi<mpfr>() * 2) : mpfr(0)) + w * t;
        sum += row.at("order") == "2" ? mpfr(0) : mpfr(-w * t * t * t / 6);
        sum += row.at("order") == "6" ? mpfr((w * w * w + w) * pow(t, 5) / 120) : mpfr(0);
        CHECK_THAT(row.at("theta"), right_to_the_last_digit_of(sum));
        // The printed angle is the less precise of the two: it has 40 digits, and a small error loses some of them.
        const mpfr difference = abs(sum - number_of(row.at("theta_exact"))) - number_of(row.at("error"));
        CHECK(abs(difference) <= last_place(row.at("theta_exact")) + last_place(row.at("error")));
    }
}

TEST_CASE("inside the radius more terms are better, outside they are worse", "[studies][divergence]") {
    const precision_scope scope(60);
    const auto found = tables_for({{"--energies", "0.5,1.71,2.02,6"}, {"--times", "0.02,1,12"}, {"--orders", "9,81"}});
    for (std::size_t energy = 0; energy < 4; ++energy) {
        const mpfr radius = number_of(found.radius.at(energy).at("radius"));
        for (std::size_t i = 0; i < 3; ++i) {
            const table_row& few = found.sums.at(energy * 6 + i);
            const table_row& many = found.sums.at(energy * 6 + 3 + i);
            INFO("E = " << few.at("energy") << ", t = " << few.at("time"));
            CHECK(few.at("order") == "9");
            CHECK(many.at("order") == "81");
            const bool inside = number_of(few.at("time")) < radius;
            CHECK((number_of(many.at("log10_error")) < number_of(few.at("log10_error"))) == inside);
            // The 72 powers more change the error by (t/R)^72 and not much else: |log10| of constants below 4.
            const mpfr change = number_of(many.at("log10_error")) - number_of(few.at("log10_error"));
            CHECK(abs(change - log10(number_of(few.at("time")) / radius) * 72) < 4);
        }
    }
}

TEST_CASE("the error has its digits where it is far below the angle", "[studies][divergence]") {
    const precision_scope scope(60);
    // At t = 1e-3 it is the first omitted term: a_11 t^11 (1 + O(t^2)) against a_13 t^13.
    const auto found = tables_for({{"--energies", "1.71"}, {"--times", "1e-3,2e-3"}, {"--orders", "10"}});
    const mpfr ratio = number_of(found.sums.at(1).at("error")) / number_of(found.sums.at(0).at("error"));
    CHECK(abs(ratio - 2048) < mpfr(1) / 50);  // 2048 times 3e-6 times a_13/a_11 < 1
    CHECK(significant_digits(found.sums.at(0).at("error")) == 40);
}

TEST_CASE("R is less than T* for 1 < E < 4 only, and equal to it at both ends", "[studies][divergence]") {
    const precision_scope scope(60);
    const auto found =
        tables_for({{"--energies", "0.1,0.99,1,1.01,1.9,2.1,3.9,4,4.1,9"}, {"--times", "1"}, {"--orders", "3"}});
    for (const table_row& row : found.radius) {
        INFO("E = " << row.at("energy"));
        const mpfr e = number_of(row.at("energy"));
        const mpfr ratio = number_of(row.at("radius_over_tstar"));
        if (e == 1 || e == 4) {
            CHECK(abs(ratio - 1) < mpfr("1e-38"));
        } else {
            CHECK((ratio < 1) == (e > 1 && e < 4));
        }
    }
}

TEST_CASE("the bottom itself has no error, and E = 0 and 2 no period", "[studies][divergence]") {
    const auto found = tables_for({{"--energies", "1.71"}, {"--times", "0"}, {"--orders", "5"}});
    CHECK(found.sums.front().at("error") == "0");
    CHECK(found.sums.front().at("log10_error") == "-inf");
    CHECK_THROWS_WITH(tables_for({{"--energies", "2"}}), Catch::Contains("energy 2"));
    CHECK_THROWS_WITH(tables_for({{"--energies", "0"}}), Catch::Contains("energy 0"));
}

}  // namespace studies_divergence_test
