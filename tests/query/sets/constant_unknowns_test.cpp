// Unknowns that keep their initial values: which they are, and sets of solutions with them against closed forms.
#include "libration/query/sets/constant_unknowns.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/query/sets/set_events.hpp"
#include "libration/query/sets/solution_sets.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "query/sets/set_ranges.hpp"

namespace query_sets_constant_unknowns_test {

using namespace libration;
using namespace libration::ode;
using tests::check_range;
using tests::digits_of_ranges;
using tests::sharp;
using tests::value_of;

namespace {

using names = std::set<std::string>;

// All initial values are constant.
names constant_in(const std::string& problem, const ode::expression& used = {}) {
    const explicit_system system(parse(problem));
    std::vector<ode::expression> starts;
    for (const auto& of_unknown : system.starts()) {
        starts.insert(starts.end(), of_unknown.begin(), of_unknown.end());
    }
    return constant_unknowns(system, starts, used);
}

set_enclosures at_time_of(const std::string& problem, const std::string& time) {
    return enclosed_solutions(parse(problem), {.spans = {at_time(parse_constant(time).constant())}});
}

void check_number(const closed_interval& found, const ball& value) {
    CHECK(arb_equal(found.lower.handle(), value.handle()) != 0);
    CHECK(arb_equal(found.upper.handle(), value.handle()) != 0);
}

}  // namespace

TEST_CASE("unknowns are constant if no other one moves them", "[ode][proved][sets]") {
    CHECK(constant_in("x' = x + z; z' = z*x; x(0) = 1; z(0) = 0") == names{"z"});
    CHECK(constant_in("x' = x + z; z' = (z - 2)*x; x(0) = 1; z(0) = 2") == names{"z"});
    CHECK(constant_in("x' = x; z' = sin(z)*x; x(0) = 1; z(0) = 0") == names{"z"});
    CHECK(constant_in("x' = x; z'' = z*x; x(0) = 1; z(0) = 0; z'(0) = 0") == names{"z"});
    CHECK(constant_in("x' = x; z'' = z'*x; x(0) = 1; z(0) = 3; z'(0) = 0") == names{"z"});
    // Several that vanish together, and those that are left after others: z moves w, and w moves v.
    CHECK(constant_in("x' = 1; u' = v*x; v' = u*x; x(0) = 1; u(0) = 0; v(0) = 0") == names{"u", "v"});
    CHECK(constant_in("z' = 1; w' = z; v' = w; u' = u*v; z(0) = 0; w(0) = 0; v(0) = 0; u(0) = 0") == names{"u"});

    CHECK(constant_in("x' = x; z' = z*x + t; x(0) = 1; z(0) = 0").empty());
    CHECK(constant_in("x' = x; z' = z*x; x(0) = 1; z(0) = 1e-300").empty());
    CHECK(constant_in("x' = x; z'' = z*x; x(0) = 1; z(0) = 0; z'(0) = 1").empty());
    CHECK(constant_in("x' = x + z; z' = z*x; x(0) = 1; z(0) = 0", unknown("z")).empty());
}

// x' = z/x + ... is undefined at x = 0 although z = 0.
TEST_CASE("unknowns are not constant for equations whose domain depends on it", "[ode][proved][sets]") {
    CHECK(constant_in("x' = -1 + z/x; z' = 0; x(0) = 1; z(0) = 0").empty());
    CHECK(constant_in("x' = -1 + z*log(x); z' = 0; x(0) = 1; z(0) = 0").empty());
    CHECK(constant_in("x' = -1; z' = z*sqrt(x); x(0) = 1; z(0) = 0").empty());
    // The same argument elsewhere, where it may have any value, or any but 0.
    CHECK(constant_in("x' = -1 + z*log(x); y' = sin(x); z' = 0; x(0) = 1; y(0) = 0; z(0) = 0").empty());
    CHECK(constant_in("x' = -1 + z/x; y' = x^2; z' = 0; x(0) = 1; y(0) = 0; z(0) = 0").empty());
    CHECK(constant_in("x' = 1; y' = 1/x; z' = z*asin(x); x(0) = 1/2; y(0) = 0; z(0) = 0").empty());
    CHECK(constant_in("x' = 1/x; z' = z/x; x(0) = 1; z(0) = 0") == names{"z"});
    CHECK(constant_in("x' = log(x + z); z' = z*log(x); x(0) = 2; z(0) = 0") == names{"z"});
    CHECK(constant_in("x' = x/cos(z); z' = z*x; x(0) = 1; z(0) = 0") == names{"z"});
}

TEST_CASE("sets of solutions with constant unknowns have the ranges of closed forms", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    // x = x0 e^t, in the order of the equations.
    const auto zero =
        at_time_of("w' = w*x*y; x' = x*cos(w) + sin(w)*y; y' = -y; w(0) = 0; x(0) = [1, 2]; y(0) = 1", "1");
    CHECK(zero.names == std::vector<std::string>{"w", "x", "y"});
    check_number(zero.values[0][0], ball(0));
    check_range(zero.values[0][1], exp(ball(1)), ball(2) * exp(ball(1)), sharp);
    // x = e^(-2 b t), with the value 2, which a parameter gives.
    const auto two =
        at_time_of("x' = -b*w*x; w'' = (w - a)*x + w'; x(0) = 1; w(0) = a; w'(0) = 0; a = 2; b = [1, 3]", "1");
    CHECK(two.names == std::vector<std::string>{"x", "w", "w'"});
    check_range(two.values[0][0], exp(ball(-6)), exp(ball(-2)), sharp);
    check_number(two.values[0][1], ball(2));
    check_number(two.values[0][2], ball(0));
    // An initial value that is in a set, also through a parameter, is not constant: z = z0 e^t.
    for (const std::string start : {"z(0) = [0, 1]", "z(0) = a; a = [0, 1]"}) {
        const auto moving = at_time_of("x' = x; z' = z; x(0) = 0; " + start, "1");
        check_number(moving.values[0][0], ball(0));
        check_range(moving.values[0][1], ball(0), exp(ball(1)), sharp);
    }
    // All of them.
    const auto rest = at_time_of("x' = b*x; x(0) = 0; b = [1, 2]", "1");
    check_number(rest.values[0][0], ball(0));
}

TEST_CASE("events of sets with constant unknowns", "[ode][proved][sets]") {
    const precision_scope scope(digits_of_ranges);
    const std::string problem = "x' = x*w; w' = (w - 2)*x; x(0) = [1, 2]; w(0) = 2";
    const auto found = enclosed_events(parse(problem), {.condition = "x = 4"});
    CHECK(found.names == std::vector<std::string>{"x", "w"});
    check_range(found.events[0].time, log(ball(2)) / ball(2), log(ball(2)), sharp);
    check_number(found.events[0].values[1], ball(2));
    const auto with_w = enclosed_events(parse(problem), {.condition = "x = 2*w"});
    check_range(with_w.events[0].time, log(ball(2)) / ball(2), log(ball(2)), sharp);
}

// x = x0 - t ends at t = x0, where w/x is undefined.
TEST_CASE("a set with a constant unknown ends where its equations do", "[ode][proved][sets]") {
    const auto beyond = at_time_of("x' = -1 + w/x; w' = 0; x(0) = [1, 1.5]; w(0) = 0", "2");
    CHECK(beyond.missing);
    const auto before = at_time_of("x' = -1 + w/x; w' = 0; x(0) = [1, 1.5]; w(0) = 0", "0.5");
    check_range(before.values[0][0], value_of("0.5"), ball(1), sharp);
}

}  // namespace query_sets_constant_unknowns_test
