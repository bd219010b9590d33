// Coefficients of a law in decimals: by the law, by the recurrence and by symmetry.
#include "libration/problem/law_answer.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"

namespace problem_law_answer_test {

using namespace libration;

namespace {

law_report report_of(const std::string& text, const std::string& show, const std::vector<long>& orders, long digits) {
    return law_of(ode::explicit_system(ode::parse(text)), {.show = show}, orders, proved_digits(digits));
}

}  // namespace

// a_n of 1/(7/3 - t) is (3/7)^(n+1); of its derivative n + 1 times the next.
TEST_CASE("each coefficient says what proves it", "[problem][asymptotics]") {
    const auto report = report_of("y' = y^2; y(0) = 3/7", "", {0, 1, 5000}, 20);
    CHECK(report.complete);
    CHECK(report.coefficients.at(0, "by") == "recurrence");
    CHECK(report.coefficients.at(0, "value") == "0.42857142857142857143");
    CHECK(report.coefficients.at(2, "by") == "law");
    const auto slope = report_of("y' = y^2; y(0) = 3/7", "y'", {0}, 20);
    CHECK(slope.coefficients.at(0, "value") == "0.18367346938775510204");
    const auto even = report_of("y' = -2*t*y^2; y(0) = 1", "", {4000, 4001}, 20);
    CHECK(even.coefficients.at(0, "value") == "1.0000000000000000000");
    CHECK(even.coefficients.at(1, "by") == "symmetry");
    CHECK(even.coefficients.at(1, "value") == "0");
    CHECK(even.singularities.rows.size() == 2);
    CHECK_THROWS_AS(report_of("y' = y^2; y(0) = 3/7", "z", {}, 20), error);
}

}  // namespace problem_law_answer_test
