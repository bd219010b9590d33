// Condition numbers of solutions against closed forms, and against solutions from numbers that were moved.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/condition_numbers.hpp"
#include "libration/query/states.hpp"

namespace condition_numbers_test {

using namespace libration;

namespace {

std::vector<ode::number> numbers(const std::vector<std::string>& texts) {
    std::vector<ode::number> all;
    for (const std::string& each : texts) {
        all.push_back(ode::parse_constant(each).constant());
    }
    return all;
}

mpfr number_of_text(const std::string& decimal) { return mpfr(decimal); }

// Three digits are promised.
void check_three_digits(const mpfr& found, const mpfr& expected) {
    INFO(found << " for " << expected);
    CHECK(abs(mpfr(found - expected)) <= abs(expected) / 1000);
}

}  // namespace

// y = c e^(-k t): dy/dc c = y, dy/dk k = -k t y, y' t = -k t y. 1/3 and 1/10 are no doubles: the next ones differ by
// less than 2^-53 of themselves.
TEST_CASE("the condition numbers of an exponential, on both sides of its start", "[ode][proved][condition]") {
    const precision_scope scope(40);
    const auto system = ode::parse("y' = -k*y; y(0) = 1/3; k = 1/10");
    const auto states = ode::proved_conditions(system, numbers({"2", "30", "-5"}), 20);
    const std::vector<int> times{2, 30, -5};
    REQUIRE(states.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(states[i].values.size() == 1);
        const mpfr kt = mpfr(times[i]) / 10;
        const mpfr y = exp(mpfr(-kt)) / 3;
        CHECK(abs(mpfr(number_of_text(states[i].values[0].text) - y)) <= y * pow(mpfr(10), -19));
        check_three_digits(states[i].moved[0].by_start, y);
        check_three_digits(states[i].moved[0].by_parameters, mpfr(abs(kt) * y));
        check_three_digits(states[i].moved[0].by_time, mpfr(abs(kt) * y));
        const mpfr of_start = mpfr(1.0 / 3.0) - mpfr(1) / 3;
        const mpfr of_k = mpfr(0.1) - mpfr(1) / 10;
        check_three_digits(states[i].moved[0].by_rounding, mpfr(abs(mpfr(of_start * 3 * y - of_k * times[i] * y))));
    }
}

// The Lorenz equations with r and x(0) moved by 10^-20 of themselves: the difference quotient of 40 digits has 15.
TEST_CASE("condition numbers in chaos are those of solutions from moved numbers", "[ode][proved][condition]") {
    const precision_scope scope(50);
    const auto given = ode::parse(std::string(problem_text("lorenz")));
    const auto times = numbers({"4"});
    const auto found = ode::proved_conditions(given, times, 20).front();
    const auto at = [&](const std::vector<std::string>& changes) {
        ode::equation_system system = given;
        for (const std::string& each : changes) {
            system = ode::changed(system, each);
        }
        return ode::proved_trajectory(ode::explicit_system(system), times, 40).front();
    };
    const auto usual = at({});
    const auto moved = [&](const std::string& change, std::size_t k) {
        const mpfr difference = number_of_text(at({change})[k].text) - number_of_text(usual[k].text);
        return mpfr(abs(mpfr(difference * pow(mpfr(10), 20))));
    };
    for (std::size_t k = 0; k < 3; ++k) {
        check_three_digits(found.moved[k].by_start, moved("x(0) = 1 + 1e-20", k));
        check_three_digits(
            found.moved[k].by_parameters,
            mpfr(moved("s = 10*(1 + 1e-20)", k) + moved("r = 28*(1 + 1e-20)", k) + moved("b = 8/3*(1 + 1e-20)", k)));
        CHECK(found.values[k].text.substr(0, 19) == usual[k].text.substr(0, 19));
    }
}

// Fast motion that dies out, with the slow one beside it: 64 bits of the maps of errors are not enough here, and
// y = cos t + c e^(-1000 t) says what is left.
TEST_CASE("condition numbers of a stiff equation settle with more bits", "[ode][proved][condition]") {
    const precision_scope scope(60);
    const auto system = ode::parse("y' = -1000*(y - cos(t)) - sin(t); y(0) = 2");
    const auto states = ode::proved_conditions(system, numbers({"0.01", "0.5"}), 20);
    const auto left = [](const mpfr& t) { return mpfr(2 * exp(mpfr(-1000 * t))); };
    check_three_digits(states[0].moved[0].by_start, left(mpfr(1) / 100));
    check_three_digits(states[1].moved[0].by_start, left(mpfr(1) / 2));
    check_three_digits(states[1].moved[0].by_time, mpfr(sin(mpfr(0.5)) / 2));
}

// y = 1 + (y(0) - 1) cos t depends on y(0) by cos t, which is below 1e-39 at the first time and about 1e-17 at the second
// one. There the rounding of 4/3 to a double moves y by less than 64 bits of the flow tell, and by more than 1e-40.
TEST_CASE("effects that are negligible are 0, and others settle with more bits", "[ode][proved][condition]") {
    const precision_scope scope(60);
    const auto moved = [](const std::string& start, const std::string& time, long digits) {
        const auto system = ode::parse("y'' = 1 - y; y'(0) = 0; y(0) = " + start);
        return ode::proved_conditions(system, numbers({time}), digits).front().moved;
    };
    const auto at_quarter = moved("2", "1.5707963267948966192313216916397514420986", 20);
    CHECK(at_quarter[0].by_start == 0);
    CHECK(at_quarter[0].by_rounding == 0);
    check_three_digits(at_quarter[0].by_time, mpfr(pi<mpfr>() / 2));
    check_three_digits(at_quarter[1].by_start, mpfr(2));
    const std::string near = "1.5707963267948966";
    const auto beside = moved("4/3", near, 30);
    const mpfr cosine = abs(cos(mpfr(near)));
    check_three_digits(beside[0].by_start, mpfr(cosine * 4 / 3));
    check_three_digits(beside[0].by_rounding, mpfr(cosine * abs(mpfr(mpfr(4.0 / 3.0) - mpfr(4) / 3))));
}

TEST_CASE("the effects on one unknown need those that it depends on alone", "[ode][proved][condition]") {
    const auto system = ode::parse("x' = -x; y' = y^2 + x; x(0) = 1; y(0) = 1");
    CHECK(ode::dependence(system, {"x"}).names() == std::vector<std::string>{"x"});
    CHECK(ode::dependence(system, {"y"}).names() == std::vector<std::string>{"x", "y"});
}

// A value that is exactly 0 has no digits, and nobody asks for those of a parameter.
TEST_CASE("a parameter that is 0 does not move a solution", "[ode][proved][condition]") {
    const precision_scope scope(40);
    const auto system = ode::parse("y' = -y + p; y(0) = 1/3; p = 0");
    const auto found = ode::proved_conditions(system, numbers({"2"}), 20).front();
    REQUIRE(found.values.size() == 1);
    const mpfr y = exp(mpfr(-2)) / 3;
    CHECK(abs(mpfr(mpfr(found.values[0].text) - y)) <= y * pow(mpfr(10), -19));
    CHECK(found.moved[0].by_parameters == 0);
    check_three_digits(found.moved[0].by_start, y);
}

}  // namespace condition_numbers_test
