// The study root_test against closed forms of the first coefficients and the asymptotic form of the later ones.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "studies/shared/list_answers.hpp"
#include "studies/study_rows.hpp"
#include "sweep/named_order.hpp"
#include "text/input_error.hpp"

namespace studies_root_test_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<table_row> roots(const study_words& words) { return rows_of_study("root_test", words); }

}  // namespace

TEST_CASE("the first roots are those of Taylor's theorem", "[studies][root_test]") {
    const precision_scope scope(60);
    // a_2 = -sin(theta_0)/2 about the top of libration, sin(theta_0)^2 = E (2 - E); a_1 = sqrt(2 E) in size about the
    // bottom.
    for (const char* const energy : {"0.5", "1", "1.71"}) {
        const mpfr e = number_of(energy);
        const mpfr top = sqrt(mpfr(2 / sqrt(mpfr(e * (2 - e)))));
        const mpfr bottom = 1 / sqrt(mpfr(2 * e));
        for (const table_row& row : roots({{"--energies", energy}, {"--orders", "8"}, {"--points", "0,1"}})) {
            const std::string place = row.at("point") + " " + row.at("n");
            if (place == "0 2") {
                CHECK_THAT(row.at("root"), right_to_the_last_digit_of(top));
                CHECK_THAT(row.at("corrected"), right_to_the_last_digit_of(mpfr(top / sqrt(mpfr(2)))));
            } else if (place == "1 1") {
                CHECK_THAT(row.at("root"), right_to_the_last_digit_of(bottom));
                CHECK(row.at("corrected") == row.at("root"));
            }
        }
    }
}

TEST_CASE("without a phase the error is that of the amplitude alone", "[studies][root_test]") {
    const precision_scope scope(40);
    std::map<std::string, int> rows;
    for (const table_row& row : roots({{"--energies", "1"}, {"--orders", "120"}, {"--points", "0,1"}})) {
        const int n = std::stoi(row.at("n"));
        ++rows[row.at("point")];
        const mpfr amplitude = row.at("point") == "0" ? 8 : 4;
        CHECK(row.at("amplitude") == (row.at("point") == "0" ? "8" : "4"));
        if (n >= 60) {
            // |a_n| = A/n R^-n to 5^(-n/2) at E = 1, in a column of 12 digits.
            const mpfr expected = pow(mpfr(n / amplitude), mpfr(1) / n) - 1;
            CHECK(abs(number_of(row.at("root_error")) - expected) < mpfr("1e-12"));
            const mpfr corrected = pow(amplitude, mpfr(-1) / n) - 1;
            CHECK(abs(number_of(row.at("corrected_error")) - corrected) < mpfr("1e-12"));
        }
    }
    // n = 2, 6, ..., 118 about the top, n = 1, 3, ..., 119 about the bottom.
    CHECK(rows == std::map<std::string, int>{{"0", 30}, {"1", 60}});
}

TEST_CASE("the amplitude bounds the coefficients of a pair", "[studies][root_test]") {
    const precision_scope scope(40);
    for (const table_row& row : roots({{"--energies", "0.5,2.02"}, {"--orders", "110"}, {"--points", "0,1/3"}})) {
        if (std::stoi(row.at("n")) >= 100) {
            // R/R2 is 0.918 at E = 2.02 about the top: up to 0.918^100 more, here within the last of 4 digits.
            const mpfr size = pow(mpfr(1 + number_of(row.at("corrected_error"))), -std::stoi(row.at("n")));
            CHECK(size <= number_of(row.at("amplitude")) * mpfr("1.001"));
        }
    }
}

TEST_CASE("the table of estimates holds the tests by size and the verdict", "[studies][root_test]") {
    const precision_scope scope(40);
    bool verdict = false;
    const study_words words{{"--energies", "1.71"}, {"--orders", "50"}, {"--points", "0"}};
    const auto rows = rows_by_suffix("root_test", words).at("estimates");
    for (const table_row& row : rows) {
        const std::string& method = row.at("method");
        CHECK((method == "verdict" || method == "root" || method == "root-corrected" || method == "top-line"));
        if (method == "verdict") {
            verdict = true;
            CHECK(number_of(row.at("relative_error")) < mpfr("1e-18"));
        }
    }
    CHECK(verdict);
}

// (1 - 2t)^(-1/2): a_n is the product of 2 - 1/k up to k = n, the radius 1/2.
TEST_CASE("with --prove the roots, the radius and their distance are proved", "[studies][root_test]") {
    const precision_scope scope(40);
    const auto order = order_asked("study", "root_test", equation_words{"y' = y^3; y(0) = 1", {}},
                                   {{"--prove", "yes"}, {"--orders", "24"}}, 2);
    CHECK(order.command.ends_with("--prove"));
    const auto rows = rows_of_table(tables_of(order).front());
    REQUIRE(rows.size() == 24);
    mpfr coefficient = 1;
    for (const table_row& row : rows) {
        const mpfr n = number_of(row.at("n"));
        coefficient *= 2 - 1 / n;
        const mpfr truth = pow(coefficient, mpfr(-1 / n));
        CHECK_THAT(row.at("proved_radius"), right_to_the_last_digit_of(mpfr(mpfr(1) / 2)));
        if (!row.at("law_root").empty()) {
            CHECK(abs(mpfr(number_of(row.at("law_root")) - truth)) <= number_of(row.at("law_error")));
            // Of each number in the ball, whose ends are at most twice its error apart, upwards to three digits.
            const mpfr distance = abs(mpfr(truth - mpfr(1) / 2));
            const mpfr most = (distance + 2 * number_of(row.at("law_error"))) * mpfr("1.01");
            CHECK(number_of(row.at("deviation")) >= distance);
            CHECK(number_of(row.at("deviation")) <= most);
        }
    }
    CHECK(rows.front().at("law_root").empty());
    CHECK_FALSE(rows.back().at("law_root").empty());
}

// x = 1/(1 - t), and y = exp(t) without a singularity.
TEST_CASE("the unknown that has no law is named", "[studies][root_test]") {
    const auto of = [](const std::string& text) {
        return order_asked("study", "root_test", equation_words{text, {}}, {{"--prove", "yes"}, {"--orders", "8"}}, 1);
    };
    CHECK_THROWS_WITH(tables_of(of("y'' = -y; y(0) = 0; y'(0) = 1")),
                      Catch::Contains("--prove has no law: the problem") && Catch::Contains("entire"));
    CHECK_THROWS_WITH(tables_of(of("x' = x^2; y' = y; x(0) = 1; y(0) = 1")),
                      Catch::Contains("--prove has no law of y: the problem"));
    const ode::explicit_system system(ode::parse("x' = x^2; y' = y; x(0) = 1; y(0) = 1"));
    const proved_law law = studies::law_of_unknown(system, "x", 10);
    CHECK(law.name() == "x");
    CHECK(law.limit(5).decimal->text == "1.0000");
    CHECK_THROWS_WITH(studies::law_of_unknown(system, "y", 10), Catch::Contains("has no law of y"));
}

TEST_CASE("what has no root test is refused", "[studies][root_test]") {
    CHECK_THROWS_AS(roots({{"--energies", "0"}}), libration::error);
    CHECK_THROWS_AS(roots({{"--energies", "1,2"}}), libration::error);
    CHECK_THROWS_AS(roots({{"--orders", "3"}}), input_error);
}

}  // namespace studies_root_test_test
