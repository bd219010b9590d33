// Branches of Bratu's problem and of a cubic, compared with their closed forms: points, turning points, and ends.
#include "libration/query/shooting/solution_branch.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/error.hpp"

namespace query_shooting_solution_branch_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long digits = 25;

struct followed {
    std::vector<branch_point> points;
    branch_result result;

    std::vector<branch_point> turns() const {
        std::vector<branch_point> found;
        for (const branch_point& each : points) {
            if (each.kind == branch_point_kind::turning_point) {
                found.push_back(each);
            }
        }
        return found;
    }
};

followed along(const std::string& text, const std::string& unknown, const std::string& condition,
               const std::vector<std::string>& values, const std::string& parameter = "k") {
    branch_question question{parse(text), {unknown}, {}, parameter, values, digits};
    add_condition(question.conditions, question.system, condition);
    followed found;
    found.result = follow_branch(question, [&](const branch_point& point) { found.points.push_back(point); });
    return found;
}

ball value_of(const known_value& x) {
    mpfr value;
    mpfr_set_str(handle(value), x.decimal.value().text.c_str(), 10, MPFR_RNDN);
    return ball(value);
}

bool equal(const known_value& printed, const ball& exact) {
    return certainly_less(abs(value_of(printed) - exact), abs(exact) * pow(ball(10), 1 - digits));
}

}  // namespace

// y'' = -k e^y, y(0) = y(1) = 0: with q = sqrt(y'(0)^2 + 2 k)/4, k = 8 (q/cosh q)^2. The turning point has
// q tanh q = 1, so that k = 8 (q^2 - 1) and y'(0) = 4 q tanh q = 4.
TEST_CASE("Bratu's branch passes its turning point", "[ode][proved][branch]") {
    const precision_scope scope(digits + 30);
    const auto found = along("y'' = -k*e^y; y(0) = 0; y'(0) = 0; k = 1", "y'(0)", "y(1) = 0", {"0", "3/2", "3.5"});
    REQUIRE(found.points.size() == 6);
    CHECK(found.result.unproved.empty());
    const ball tiny = pow(ball(10), 3 - digits);
    for (const branch_point& each : found.points) {
        const ball k = value_of(each.values[0]);
        const ball slope = value_of(each.values[1]);
        const ball q = sqrt(slope * slope + k * 2) / 4;
        CHECK(certainly_less(abs(ball(8) * q * q / (cosh(q) * cosh(q)) - k), tiny));
    }
    const auto turns = found.turns();
    REQUIRE(turns.size() == 1);
    CHECK(turns[0].values[0].decimal->text.starts_with("3.513830719125161206"));
    CHECK(equal(turns[0].values[1], ball(4)));
    CHECK(found.points[2].values[0].decimal->text == found.points[4].values[0].decimal->text);
    CHECK(certainly_less(value_of(found.points[2].values[1]), value_of(found.points[4].values[1])));
}

// y(1) = y(0) + k - 3 s + s^3, an S-shaped curve with turning points at s = -1 and 1, k = -2 and 2.
TEST_CASE("a branch with two turning points leaves the range at the other end", "[ode][proved][branch]") {
    const precision_scope scope(digits + 30);
    const auto found = along("y' = k - 3*s + s^3; y(0) = 0; s = -2; k = -3", "s", "y(1) = 0", {"3", "0", "-3"});
    REQUIRE(found.turns().size() == 2);
    CHECK(found.result.end == branch_end::left);
    CHECK(found.points.size() == 2 + 2 + 3);
    CHECK(equal(found.turns()[0].values[0], ball(-2)));
    CHECK(equal(found.turns()[0].values[1], ball(-1)));
    CHECK(equal(found.turns()[1].values[0], ball(2)));
    CHECK(equal(found.turns()[1].values[1], ball(1)));
}

// s^2 + k^2 = 1.
TEST_CASE("a closed branch ends where it begins", "[ode][proved][branch]") {
    const auto found = along("y' = s^2 + k^2; y(0) = 0; s = 0.3; k = 0", "s", "y(1) = 1", {"-0.95", "0.95"});
    CHECK(found.result.end == branch_end::closed);
    CHECK(found.turns().size() == 2);
}

TEST_CASE("a turning point in an initial value and with a time that depends on the unknown", "[ode][proved][branch]") {
    const precision_scope scope(digits + 30);
    // y(T) = p e^T = T, so that p = T e^-T with its maximum 1/e at T = 1.
    const auto found = along("y' = y; y(0) = 1/10; T = 1/10", "T", "y(T) = T", {"1/10", "7/20"}, "y(0)");
    REQUIRE(found.turns().size() == 1);
    CHECK(equal(found.turns()[0].values[0], exp(ball(-1))));
    CHECK(equal(found.turns()[0].values[1], ball(1)));
}

TEST_CASE("values of a branch that have no direction, and no first solution", "[ode][proved][branch][bad input]") {
    const std::string text = "y' = k - s^2; y(0) = 0; s = 1; k = 1";
    CHECK_THROWS_WITH(along(text, "s", "y(1) = 0", {"1", "2", "1"}), Catch::Contains("in one direction"));
    CHECK_THROWS_WITH(along(text, "s", "y(1) = 0", {"1"}), Catch::Contains("in one direction"));
    CHECK_THROWS_WITH(along(text, "s", "y(1) = 0", {"-1", "1"}), Catch::Contains("the last iterate is s = "));
}

}  // namespace query_shooting_solution_branch_test
