// The study uniform: its norms against sampled errors, its bounds, and its refusals.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/uniform_resummation.hpp"
#include "pendulum/typed.hpp"
#include "studies/study_rows.hpp"

namespace studies_uniform_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

const study_words few{{"--energies", "1e-20,1.71,4"}, {"--gaps", "1e-30,-1e-30"}, {"--orders", "4,16"}};

motion motion_at(const table_row& row) { return with_gap(row.at("gap")); }

}  // namespace

TEST_CASE("the norms of the study are the largest errors on the way down", "[studies][uniform]") {
    for (const table_row& row : rows_of_study("uniform", few)) {
        INFO("gap " << row.at("gap") << ", " << row.at("count") << " coefficients");
        const motion m = motion_at(row);
        const int order = std::stoi(row.at("order"));
        CHECK(order == 2 * std::stoi(row.at("count")) - (m.regime() == regime::rotation ? 1 : 0));
        CHECK(row.at("rigour") == "two-method");
        const precision_scope scope(140);
        const exact_solution<mpfr> truth(m);
        const auto f = uniform_from_top<mpfr>(m, order);
        mpfr largest(0);
        for (int i = 0; i <= 40; ++i) {
            const mpfr x = mpfr(i) / 40;
            largest = std::max(largest, mpfr(abs(f.value(x) - truth.from_top(x).theta)));
        }
        const mpfr norm = number_of(row.at("norm"));
        CHECK(largest <= norm * mpfr("1.00000001"));
        CHECK(largest > norm * mpfr("0.9"));  // samples a fortieth of T* apart
        CHECK(norm <= number_of(row.at("bound")));
        CHECK(number_of(row.at("rate")) < mpfr(1) / 3);
    }
}

TEST_CASE("in double the error is a rounding of the largest theta or the bound", "[studies][uniform]") {
    const auto tables = rows_by_suffix("uniform", few);
    REQUIRE(tables.at("double").size() == tables.at("").size());
    const precision_scope scope(40);
    for (const table_row& row : tables.at("double")) {
        INFO("gap " << row.at("gap") << ", " << row.at("count") << " coefficients");
        CHECK(row.at("scalar") == "double");
        CHECK(number_of(row.at("norm")) <= number_of(row.at("bound")) + mpfr("2e-15"));  // below 2 pi: two ulps
    }
}

TEST_CASE("E = 0, E = 2 and no coefficient are refused by the study uniform", "[studies][uniform]") {
    CHECK_THROWS_WITH(rows_of_study("uniform", {{"--energies", "2"}}), Catch::Contains("energy 2"));
    CHECK_THROWS_WITH(rows_of_study("uniform", {{"--energies", "0"}}), Catch::Contains("energy 0"));
    CHECK_THROWS_WITH(rows_of_study("uniform", {{"--energies", "1"}, {"--orders", "0"}}), Catch::Contains("0"));
}

}  // namespace studies_uniform_test
