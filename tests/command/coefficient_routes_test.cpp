// `libration coefficients --recurrence` and `--method resummed`: the routes agree, and what is printed of the
// resummation satisfies the conditions that define it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "scalars.hpp"

namespace command_coefficient_routes_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<table_row> rows_for(words options) {
    options.insert(options.begin(), "coefficients");
    return rows_of(options);
}

mpfr cell_of(const table_row& row, const std::string& name) { return number_of(row.at(name)); }

// sum_n column_n t^n.
mpfr sum_of(const std::vector<table_row>& rows, const std::string& name, const mpfr& t) {
    mpfr sum(0);
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        sum = sum * t + cell_of(*row, name);
    }
    return sum;
}

}  // namespace

TEST_CASE("coefficients of the resummation satisfy the conditions at both ends", "[command][coefficients]") {
    const precision_scope precision(60);
    for (const words& motion :
         {words{"--energy", "1.37"}, words{"--energy", "2.02"}, words{"--energy", "2.02", "--direction", "-"}}) {
        words line = motion;
        line.insert(line.end(), {"--method", "resummed", "--order", "13", "--digits", "40"});
        const auto rows = rows_for(line);
        REQUIRE(rows.size() == 14);
        const table_row& last = rows.back();
        INFO(command_line(line));
        CHECK(std::ranges::all_of(rows, [](const table_row& row) { return row.at("rigour") == "two-method"; }));
        CHECK(last.at("formulas") == "corrected");
        const mpfr period = cell_of(last, "tstar");
        const mpfr angle = cell_of(last, "theta_star");
        const mpfr speed = cell_of(last, "omega_star");
        const mpfr alpha = cell_of(last, "alpha") * pow(period, 14);
        const mpfr beta = cell_of(last, "beta") * pow(period, 15);
        // Forty digits each, of numbers below 100 and 15 terms.
        const mpfr tolerance("1e-36");
        CHECK(abs(sum_of(rows, "a", period) - cell_of(last, "sigma")) < tolerance);
        CHECK(abs(cell_of(last, "sigma") + alpha + beta - angle) < tolerance);
        CHECK(abs((cell_of(last, "sigma_slope") * period + alpha * 14 + beta * 15) / period - speed) < tolerance);
        // (truncation) and (truncation2) are the same polynomial.
        const mpfr t = period / 3;
        const mpfr factored = angle + speed * (t - period) + (t - period) * (t - period) * sum_of(rows, "a_hat", t);
        const mpfr expanded = sum_of(rows, "a", t) + alpha * pow(mpfr(1) / 3, 14) + beta * pow(mpfr(1) / 3, 15);
        CHECK(abs(factored - expanded) < tolerance);
        // sin^2 + cos^2 = 1; the sums to n = 13 are off by about (1/8R)^14.
        const mpfr sine = sum_of(rows, "s", mpfr(1) / 8);
        const mpfr cosine = sum_of(rows, "c", mpfr(1) / 8);
        CHECK(abs(sine * sine + cosine * cosine - 1) < mpfr("1e-14"));
        CHECK(abs(sine - sin(sum_of(rows, "a", mpfr(1) / 8))) < mpfr("1e-14"));
    }
}

TEST_CASE("the printed formulas are evaluated letter by letter, and marked", "[command][coefficients]") {
    const precision_scope precision(60);
    const auto rows =
        rows_for({"--energy", "1.71", "--method", "resummed-as-printed", "--order", "4", "--digits", "30"});
    const table_row& last = rows.back();
    CHECK(last.at("rigour") == "as printed");
    CHECK(last.at("formulas") == "printed");
    CHECK(abs(cell_of(last, "omega_star") - sqrt(mpfr("3.42"))) < mpfr("1e-28"));
    CHECK(abs(cell_of(rows[0], "b") - cell_of(rows[0], "a") - cell_of(last, "tstar") * cell_of(last, "omega_star")) <
          mpfr("1e-27"));
    // sigma_N(t) = sum a_n t^N: 5.68 at N = 1 (the errata).
    CHECK(abs(cell_of(rows[1], "sigma") - mpfr("5.68")) < mpfr("0.005"));
}

TEST_CASE("the recurrences agree up to the rounding of their arithmetic", "[command][coefficients]") {
    for (const std::string recurrence : {"printed", "squares", "omega", "lattice"}) {
        for (const std::string at : {"top", "bottom", "T/7"}) {
            INFO(recurrence << " about " << at);
            const auto rows = rows_for(
                {"--energy", "1.71", "--recurrence", recurrence, "--at", at, "--order", "40", "--scalar", "double"});
            REQUIRE(rows.size() == 41);
            for (const table_row& row : rows) {
                CHECK(row.at("recurrence") == recurrence);
                // 40 steps of a few roundings each, of coefficients of size 2 R^-n, R > 1.6.
                CHECK(cell_of(row, "difference") < mpfr("1e-13"));
            }
        }
    }
}

TEST_CASE("recurrences and the resummation are refused where they have no meaning", "[command][coefficients]") {
    check_refused({"coefficients", "--energy", "1", "--order", "3", "--recurrence", "printde"},
                  {"--recurrence 'printde'", "is not printed, squares, omega or lattice"});
    check_refused({"coefficients", "--energy", "2", "--order", "3", "--method", "resummed"}, {"--method 'resummed'"});
    check_refused({"coefficients", "--energy", "1", "--order", "3", "--method", "pade"},
                  {"--method 'pade'", "resummed-as-printed"});
    check_refused({"coefficients", "--problem", "lorenz", "--order", "3", "--recurrence", "omega"}, {"--recurrence"});
    check_refused({"coefficients", "--energy", "1", "--order", "3", "--method", "resummed", "--at", "bottom"},
                  {"--at", "--method"});
    check_refused({"coefficients", "--energy", "1", "--order", "3", "--recurrence", "omega", "--scalar", "ball:20"},
                  {"--recurrence 'omega'", "ball:20"});
}

}  // namespace command_coefficient_routes_test
