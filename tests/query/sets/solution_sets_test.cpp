// Enclosures of all solutions against closed forms of the range, and against single solutions of a set.
#include "libration/query/sets/solution_sets.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "query/sets/set_ranges.hpp"

namespace query_sets_solution_sets_test {

using namespace libration;
using namespace libration::ode;
using tests::check_range;
using tests::digits_of_ranges;
using tests::sharp;
using tests::value_of;

namespace {

number number_in(const std::string& text) { return parse_constant(text).constant(); }

set_enclosures enclosed_at(const std::string& problem, const std::vector<std::string>& times,
                           std::size_t most_parts = set_request{}.most_parts) {
    set_request asked{.spans = {}, .most_parts = most_parts};
    for (const std::string& each : times) {
        asked.spans.push_back(at_time(number_in(each)));
    }
    return enclosed_solutions(parse(problem), asked);
}

set_enclosures enclosed_over(const std::string& problem, const std::string& from, const std::string& to) {
    return enclosed_solutions(parse(problem), {.spans = {{number_in(from), number_in(to)}}});
}

}  // namespace

TEST_CASE("the range of a monotone value is that of the ends", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    const auto growth = enclosed_at("x' = x; x(0) = [0.9, 1.1]", {"1", "-2", "0"});
    check_range(growth.values[0][0], value_of("0.9") * exp(ball(1)), value_of("1.1") * exp(ball(1)), sharp);
    check_range(growth.values[1][0], value_of("0.9") * exp(ball(-2)), value_of("1.1") * exp(ball(-2)), sharp);
    check_range(growth.values[2][0], value_of("0.9"), value_of("1.1"), sharp);
    CHECK(growth.parts == 1);
    const auto decay = enclosed_at("x' = -b*x; x(0) = 1; b = 2 +- 1", {"1"});
    check_range(decay.values[0][0], exp(ball(-3)), exp(ball(-1)), sharp);
    const auto logistic = enclosed_at("x' = r*x*(1 - x); x(0) = 1/10; r = [1, 3]", {"2"});
    const auto at_rate = [](long r) { return ball(1) / (ball(1) + ball(9) * exp(ball(-2 * r))); };
    check_range(logistic.values[0][0], at_rate(1), at_rate(3), 1.0625);
    // A number in the equation and in the initial value: b e^(-b/4) increases up to b = 4.
    const auto both = enclosed_at("x' = -b*x; x(0) = b; b = [1, 2]", {"1/4"});
    check_range(both.values[0][0], exp(value_of("-1/4")), ball(2) * exp(value_of("-1/2")), sharp);
    const auto named = enclosed_at("x' = -r; r = k*x; k = [1, 3]; x(0) = 1", {"1"});
    check_range(named.values[0][0], exp(ball(-3)), exp(ball(-1)), sharp);
    // Through a parameter, and with an end that is not a fraction.
    const auto through = enclosed_at("x' = c; x(0) = 0; c = 2*b + 1; b = [0, pi]", {"1"});
    check_range(through.values[0][0], ball(1), ball(2) * pi<ball>() + 1, sharp);
}

TEST_CASE("a set is enclosed until shortly before a part of it blows up", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    // x0/(1 - x0 t), to ten times the largest start.
    const auto near = enclosed_at("x' = x^2; x(0) = [0.5, 1]", {"0.9"});
    check_range(near.values[0][0], value_of("0.5/0.55"), ball(10), sharp);
    const auto beyond = enclosed_at("x' = x^2; x(0) = [0.5, 1.5]", {"0.5", "1"}, 16);
    check_range(beyond.values[0][0], value_of("2/3"), ball(6), sharp);
    CHECK(beyond.values[1].empty());
    REQUIRE(beyond.missing);
    CHECK(beyond.missing->kind() == error_kind::undecided);
    // The first solution to end does so at t = 2/3.
    CHECK_THAT(beyond.missing->what(), Catch::Contains("all of them are proved to exist up to 0.6"));
    CHECK_THAT(beyond.missing->what(), Catch::Contains("x(0) in [1.4"));
}

TEST_CASE("a rotating box is not wrapped", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    for (const std::string time : {"1", "7", "100", "-3"}) {
        INFO(time);
        const auto found = enclosed_at("x'' = -x; x(0) = 2 +- 1/2; x'(0) = [-1, 1]", {time});
        const ball c = cos(value_of(time));
        const ball s = sin(value_of(time));
        const ball half_x = abs(c) / 2 + abs(s);
        const ball half_y = abs(s) / 2 + abs(c);
        check_range(found.values[0][0], c * 2 - half_x, c * 2 + half_x, sharp);
        check_range(found.values[0][1], s * -2 - half_y, s * -2 + half_y, sharp);
    }
    CHECK(enclosed_at("x'' = -x; x(0) = 1 +- 1; x'(0) = 0", {"1"}).names == std::vector<std::string>{"x", "x'"});
}

TEST_CASE("solutions of a wide set that are far from linear are enclosed by Taylor models", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    // A rotation by the angle r^2 t: (r cos(r^2 t), r sin(r^2 t)) for r in [1/2, 5/4]. At t = 3, with u = r^2 t up to
    // 4.6875, x is least at the zero 3.29231 of cot(u) - 2 u and y is greatest at the zero 1.83660 of tan(u) + 2 u; the
    // next ones are beyond. Values there are known to twice the digits.
    const auto turned = enclosed_at("x' = -y*(x^2 + y^2); y' = x*(x^2 + y^2); x(0) = [1/2, 5/4]; y(0) = 0", {"3"});
    const ball u = value_of("3.29231002128");
    const ball v = value_of("1.83659720315");
    check_range(turned.values[0][0], sqrt(u / 3) * cos(u), value_of("1/2") * cos(value_of("3/4")), 1.0625);
    check_range(turned.values[0][1], value_of("5/4") * sin(value_of("4.6875")), sqrt(v / 3) * sin(v), 1.0625);
    CHECK(turned.parts <= 4);
    // Functions, and parameters in them: every solution is at the quotient of initial values and e^t.
    const auto quotient = enclosed_at("x' = y/x; y' = 2*y^2/x^2; x(0) = [1, 2]; y(0) = [1, 3]", {"1/8"});
    for (const std::string x : {"1", "3/2", "2"}) {
        for (const std::string y : {"1", "2", "3"}) {
            const auto one =
                enclosed_trajectory(explicit_system(parse("x' = y/x; y' = 2*y^2/x^2; x(0) = " + x + "; y(0) = " + y)),
                                    {number_in("1/8")}, 120);
            REQUIRE(one);
            for (std::size_t i = 0; i < 2; ++i) {
                CHECK(certainly_less(quotient.values[0][i].lower, one->front()[i] + exact_multiple(ball(1), 1, -60)));
                CHECK(certainly_less(one->front()[i] - exact_multiple(ball(1), 1, -60), quotient.values[0][i].upper));
            }
        }
    }
}

TEST_CASE("the set LALO20 of the ARCH competition with W = 0.05", "[ode][proved][sets]") {
    const std::string equations =
        "x1' = 1.4*x3 - 0.9*x1; x2' = 2.5*x5 - 1.5*x2; x3' = 0.6*x7 - 0.8*x2*x3; x4' = 2 - 1.3*x3*x4; "
        "x5' = 0.7*x1 - x4*x5; x6' = 0.3*x1 - 3.1*x6; x7' = 1.8*x6 - 1.5*x2*x7; ";
    const std::vector<std::string> centre = {"1.2", "1.05", "1.5", "2.4", "1", "0.1", "0.45"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::string text = equations;
        for (std::size_t i = 0; i < centre.size(); ++i) {
            text += "x" + std::to_string(i + 1) + "(0) = " + centre[i] + more[i % more.size()] + "; ";
        }
        return text;
    };
    const auto found = enclosed_at(with({" +- 0.05"}), {"20"}, 1);
    REQUIRE_FALSE(found.missing);
    const precision_scope scope(50);
    for (const std::vector<std::string>& corner :
         {std::vector<std::string>{""}, {"+0.05"}, {"-0.05"}, {"+0.05", "-0.05"}, {"-0.05", "+0.05", "+0.05"}}) {
        const auto one = enclosed_trajectory(explicit_system(parse(with(corner))), {number_in("20")}, 120);
        REQUIRE(one);
        for (std::size_t i = 0; i < centre.size(); ++i) {
            CHECK(certainly_less(found.values[0][i].lower, one->front()[i]));
            CHECK(certainly_less(one->front()[i], found.values[0][i].upper));
            CHECK(certainly_less(found.values[0][i].upper - found.values[0][i].lower, value_of("0.02")));
        }
    }
}

TEST_CASE("the range of a value that is not monotone is approached by parts", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    // y = x0^2 (1 - e^(-2t))/2, with the least value inside the interval.
    const std::string problem = "x' = -x; y' = x^2; x(0) = [-1, 1]; y(0) = 0";
    const ball upper = (ball(1) - exp(ball(-2))) / 2;
    const auto found = enclosed_at(problem, {"1"}, 64);
    check_range(found.values[0][1], ball(0), upper, 1.125);
    // Of the number, not of the solution: b^2 for b in [-1, 2].
    const auto square = enclosed_at("x' = x; x(0) = b^2; b = [-1, 2]", {"1"}, 64);
    check_range(square.values[0][0], ball(0), ball(4) * exp(ball(1)), 1.125);
    const auto whole = enclosed_at(problem, {"1"}, 1);
    CHECK(whole.parts == 1);
    check_range(whole.values[0][1], ball(0), upper, 8);
}

TEST_CASE("every solution of a set is in its enclosure", "[ode][proved][sets]") {
    const std::vector<std::pair<std::string, std::string>> problems = {
        {"x' = x*(a - y); y' = y*(x - 1); a = #1.5#; x(0) = #1.2#; y(0) = #0.8#", "4"},
        {"x'' = m*(1 - x^2)*x' - x; m = #1#; x(0) = #1.4#; x'(0) = #2.4#", "3"},
        {"x' = 10*(y - x); y' = 28*x - y - x*z; z' = x*y - 8/3*z; x(0) = #1#; y(0) = #1#; z(0) = #1#", "1"},
        {"x'' = -sin(x); x(0) = #2#; x'(0) = #0.1#", "6"},
    };
    // Every # number # as an interval around it, or as a number in it.
    const auto with = [](std::string text, bool set, unsigned seed) {
        for (unsigned place = 0; text.find('#') != std::string::npos; ++place) {
            const auto first = text.find('#');
            const auto last = text.find('#', first + 1);
            const std::string given = text.substr(first + 1, last - first - 1);
            const long part = static_cast<long>((seed >> (2 * place)) % 4) - 1;  // -1 .. 2
            const std::string value =
                set ? given + " +- 1/64" : given + " + (" + std::to_string(part > 1 ? 0 : part) + "/64)";
            text.replace(first, last + 1 - first, value);
        }
        return text;
    };
    for (const auto& [text, time] : problems) {
        INFO(text);
        const auto found = enclosed_at(with(text, true, 0), {time}, 4);
        REQUIRE(found.values[0].size() == found.names.size());
        const precision_scope scope(50);
        for (const unsigned seed : {0U, 21U, 2U, 8U, 10U, 27U, 32U, 42U}) {
            const auto one =
                enclosed_trajectory(explicit_system(parse(with(text, false, seed))), {number_in(time)}, 120);
            REQUIRE(one);
            for (std::size_t k = 0; k < found.names.size(); ++k) {
                CHECK_FALSE(certainly_less(one->front()[k], found.values[0][k].lower));
                CHECK_FALSE(certainly_less(found.values[0][k].upper, one->front()[k]));
            }
        }
    }
}

TEST_CASE("intervals of any width and size", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    for (const std::string half : {"1e-300", "1e-30", "1e-5", "1/4"}) {
        INFO(half);
        const auto found = enclosed_at("x' = x; x(0) = 1 +- " + half, {"1"});
        check_range(found.values[0][0], (ball(1) - value_of(half)) * exp(ball(1)),
                    (ball(1) + value_of(half)) * exp(ball(1)), sharp);
    }
    const auto large = enclosed_at("x' = -x; x(0) = [1e300, 3e300]", {"1"});
    check_range(large.values[0][0], value_of("1e300") * exp(ball(-1)), value_of("3e300") * exp(ball(-1)), sharp);
    const auto around_zero = enclosed_at("x' = -x; x(0) = [-1e-300, 1e300]", {"1"});
    check_range(around_zero.values[0][0], value_of("-1e-300") * exp(ball(-1)), value_of("1e300") * exp(ball(-1)),
                sharp);
    // One number: the precision is that of the digits.
    for (const std::string one : {"[1/3, 1/3]", "1/3 +- 0"}) {
        const auto point = enclosed_at("x' = x; x(0) = " + one, {"1"});
        const ball truth = value_of("1/3") * exp(ball(1));
        CHECK_FALSE(certainly_less(truth, point.values[0][0].lower));
        CHECK_FALSE(certainly_less(point.values[0][0].upper, truth));
        CHECK(certainly_less(point.values[0][0].upper - point.values[0][0].lower, pow(ball(10), -50L)));
    }
}

TEST_CASE("a span contains all of its times", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    const auto swing = enclosed_over("x'' = -x; x(0) = 1; x'(0) = 0", "0", "4");
    check_range(swing.values[0][0], ball(-1), ball(1), 1.0625);
    check_range(swing.values[0][1], ball(-1), -sin(ball(4)), 1.0625);
    CHECK(swing.faces == 0);
    // On both sides of the initial point, and away from it.
    check_range(enclosed_over("x' = x; x(0) = 1", "-1", "1").values[0][0], exp(ball(-1)), exp(ball(1)), sharp);
    check_range(enclosed_over("x' = x; x(0) = 1", "-3", "-2").values[0][0], exp(ball(-3)), exp(ball(-2)), sharp);
    check_range(enclosed_over("x' = x; x(0) = 1", "5", "6").values[0][0], exp(ball(5)), exp(ball(6)), sharp);
    const auto growth = enclosed_over("x' = x; x(0) = [0.9, 1.1]", "0", "1");
    check_range(growth.values[0][0], value_of("0.9"), value_of("1.1") * exp(ball(1)), sharp);
    // |x| is largest at the start, x' = -x0 sin t in the quarter period.
    const auto turned = enclosed_over("x'' = -x; x(0) = [1, 2]; x'(0) = 0", "0", "pi/2");
    check_range(turned.values[0][0], ball(0), ball(2), 1.0625);
    check_range(turned.values[0][1], ball(-2), ball(0), 1.0625);
    // x = x0 cos t increases with x0 first, and decreases at the end.
    const auto further = enclosed_over("x'' = -x; x(0) = [1, 2]; x'(0) = 0", "0", "2");
    check_range(further.values[0][0], cos(ball(2)) * 2, ball(2), 1.0625);
}

// x = x0 e^(a t), whose values at t = 10 differ by a factor of 9.
TEST_CASE("spans of a set that is far from linear", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    const std::string problem = "x' = a*x; x(0) = [0.9, 1.1]; a = [0.9, 1.1]";
    const ball least = value_of("0.9"), most = value_of("1.1");
    const auto growth = enclosed_over(problem, "0", "10");
    check_range(growth.values[0][0], least, most * exp(ball(10) * most), sharp);
    const auto late = enclosed_over(problem, "9.99", "10");
    check_range(late.values[0][0], least * exp(value_of("8.991")), most * exp(ball(10) * most), 1.125);
}

TEST_CASE("what is not a set of solutions is rejected with its place", "[ode][proved][sets]") {
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"x' = x; x(0) = [2, 1]", "is an interval whose first end is above the second"},
        {"x' = x; x(0) = 1 +- (-1)", "is an interval whose first end is above the second"},
        {"x' = x; x(b) = 1; b = [0, 1]", "cannot be the initial point"},
        {"x' = c*x; x(0) = 1; c = 2*b; b = [0, k]; k = [1, 2]", "is a set of values"},
        {"t*x'' + 2*x' + t*x = 0; x(0) = 1; x'(0) = 0; k = [1, 2]", "is singular at the initial point"},
        {"when x = 2: stop; x' = x; x(0) = [0, 1]", "is an event"},
        {"x' = -x(t - 1); x(t <= 0) = 1; k = [0, 1]", "is delayed"},
        {"x' = z; 0 = z - k*x; k = [1, 2]; x(0) = 1", "algebraic equations"},
    };
    for (const auto& [text, told] : wrong) {
        INFO(text);
        try {
            enclosed_at(text, {"1"});
            FAIL("accepted");
        } catch (const error& problem) {
            CHECK(problem.kind() == error_kind::argument);
            CHECK_THAT(problem.what(), Catch::Contains(told));
        }
    }
}

TEST_CASE("sets in C++ are those of the text", "[ode][proved][sets]") {
    const ode::expression x = unknown("x");
    equation_system system;
    system.add(derivative(x), parameter("b") * x);
    system.begin_between(x, rational(9, 10), rational(11, 10));
    system.set_between("b", 1, 2);
    CHECK_THROWS_WITH(explicit_system(system), Catch::Contains("is a set of values"));
    const precision_scope scope(digits_of_ranges);
    const auto found = enclosed_solutions(system, {.spans = {at_time(number(1))}});
    check_range(found.values[0][0], value_of("0.9") * exp(ball(1)), value_of("1.1") * exp(ball(2)), sharp);
    system.set("b", 1).begin_between(x, 2, 3);
    CHECK(system.sets.size() == 1);
}

// From 0 there is no solution, or more than one, or the polynomial form has a pole beside the set.
TEST_CASE("sets on which the equations or their polynomial form are singular are refused", "[ode][proved][sets]") {
    for (const std::string problem :
         {"x' = sqrt(x); x(0) = [0, 1]", "x' = 1/x; x(0) = [0, 1]", "x' = -x/(x^2 + 1/100); x(0) = [-1, 1]",
          "x' = 1/(x^2 + 1/100); x(0) = [-1, 1]", "x' = log(x); x(0) = [0, 1]", "x' = x/a; x(0) = 1; a = [0, 1]",
          "x' = x*sqrt(a); x(0) = 1; a = [0, 1]"}) {
        INFO(problem);
        for (const std::size_t parts : {1U, 2U}) {
            const auto found = enclosed_at(problem, {"1"}, parts);
            CHECK(found.values[0].empty());
            REQUIRE(found.missing);
            CHECK(found.missing->kind() == error_kind::undecided);
            CHECK_THAT(found.missing->what(), Catch::Contains("no step from the initial point is proved") &&
                                                  Catch::Contains("may be singular on the set"));
        }
    }
}

}  // namespace query_sets_solution_sets_test
