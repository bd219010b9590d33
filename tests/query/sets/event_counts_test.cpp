// The numbers of events of all solutions of a set against closed forms.
#include "libration/query/sets/event_counts.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "corner_numbers.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"

namespace query_sets_event_counts_test {

using namespace libration;
using namespace libration::ode;

namespace {

number typed(const std::string& text) { return parse_constant(text).constant(); }

std::vector<long> counts_of(const std::string& problem, const std::string& condition, const std::string& before,
                            crossing way = crossing::any) {
    const auto found = event_counts(parse(problem), {.condition = condition, .before = typed(before), .way = way});
    INFO((found.missing ? found.missing->what() : ""));
    CHECK_FALSE(found.missing);
    return found.counts;
}

std::string missing_of(const std::string& problem, const std::string& condition, const std::string& before) {
    const auto found = event_counts(parse(problem), {.condition = condition, .before = typed(before), .most_parts = 4});
    CHECK(found.counts.empty());
    REQUIRE(found.missing);
    CHECK(found.missing->kind() == error_kind::undecided);
    return found.missing->what();
}

using numbers = std::vector<long>;

}  // namespace

TEST_CASE("solutions of a set have one number of events or several", "[ode][proved][sets]") {
    // ln 2 .. ln 4.
    const std::string decay = "x' = -x; x(0) = [1, 2]";
    CHECK(counts_of(decay, "x = 1/2", "1/4") == numbers{0});
    CHECK(counts_of(decay, "x = 1/2", "2") == numbers{1});
    CHECK(counts_of(decay, "x = 1/2", "2", crossing::up) == numbers{0});
    CHECK(counts_of(decay, "1/2 = x", "2", crossing::up) == numbers{1});
    CHECK(counts_of(decay, "x = 3", "-2") == numbers{1});
    CHECK(counts_of(decay, "x = 3", "-2", crossing::down) == numbers{1});
    CHECK(counts_of(decay, "x = 3", "-2", crossing::up) == numbers{0});
    CHECK(counts_of("x' = -x; x(0) = [0.9, 1.1]; a = [0.4, 0.5]", "x = a", "2") == numbers{1});
    // A sin t = 1: none for A < 1, two for A > 1, and for A = 1 the sides touch.
    const std::string waves = "x'' = -x; x(0) = 0; x'(0) = [0.5, 2]";
    CHECK(counts_of(waves, "x = 1", "3") == numbers{0, 2});
    CHECK(counts_of(waves, "x = 1", "3", crossing::up) == numbers{0, 1});
    CHECK(counts_of("x'' = -x; x(0) = 0; x'(0) = 1", "x = 1", "3") == numbers{0, 2});
    CHECK(counts_of("x'' = -x; x(0) = 0; x'(0) = [3/2, 2]", "x = 1", "9") == numbers{4});
    CHECK(counts_of("x'' = -x; x(0) = 1; x'(0) = 0", "x = 0", "100") == numbers{32});
    CHECK(counts_of("x'' = -x; x(0) = [1, 2]; x'(0) = 0", "x = t/10 + 1/20", "4") == numbers{1});
}

namespace {

// By the classical Runge-Kutta method in double, from (x, 1) to the time 3.64: how often the solution crosses the circle.
long crossings_of_circle(double x) {
    constexpr int steps = 36'400;
    constexpr double h = 3.64 / steps;
    const auto slope = [](const std::array<double, 2>& at) {
        return std::array{3 * at[0] - 3 * at[0] * at[1], at[0] * at[1] - at[1]};
    };
    const auto moved = [](const std::array<double, 2>& from, double by, const std::array<double, 2>& along) {
        return std::array{from[0] + by * along[0], from[1] + by * along[1]};
    };
    const auto is_inside = [](const std::array<double, 2>& at) { return std::hypot(at[0] - 1, at[1] - 1) < 0.161; };
    std::array<double, 2> state{x, 1};
    long count = 0;
    for (int i = 0; i < steps; ++i) {
        const auto a = slope(state);
        const auto b = slope(moved(state, h / 2, a));
        const auto c = slope(moved(state, h / 2, b));
        const auto d = slope(moved(state, h, c));
        const auto next = moved(moved(moved(moved(state, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
        count += is_inside(next) != is_inside(state) ? 1 : 0;
        state = next;
    }
    return count;
}

}  // namespace

// LOVO25 of the ARCH competition.
TEST_CASE("solutions that touch a surface have two events or none there", "[ode][proved][sets]") {
    const std::string orbit = "x' = 3*x - 3*x*y; y' = x*y - y; x(0) = 1.3 +- 0.012; y(0) = 1";
    const std::string circle = "(x - 1)^2 + (y - 1)^2 = 0.161^2";
    CHECK(crossings_of_circle(1.288) == 4);
    CHECK(crossings_of_circle(1.292) == 2);
    CHECK(crossings_of_circle(1.312) == 2);
    CHECK(counts_of(orbit, circle, "3.64") == numbers{2, 4});
    CHECK(counts_of(orbit, circle, "3.64", crossing::down) == numbers{1, 2});
}

TEST_CASE("numbers of events that are not decided are refused", "[ode][proved][sets]") {
    const std::string decay = "x' = -x; x(0) = [1, 2]";
    CHECK_THAT(missing_of(decay, "x = 1/2", "log(4)"),
               Catch::Contains("is not decided: the condition may hold in [1."));
    CHECK_THAT(missing_of(decay, "x = 1", "2"), Catch::Contains("the condition may hold in [0, "));
    CHECK_THAT(missing_of("x' = x^2; x(0) = [0.9, 1.1]", "x = -1", "2"),
               Catch::Contains("is not reached by every solution: all of them are proved to exist up to 0."));
    // A zero of the third order, where the difference and both derivatives are 0.
    CHECK_THAT(missing_of("x' = 3*(t - 1)^2; x(0) = -1", "x = 0", "2"), Catch::Contains("is not decided"));
    CHECK_THROWS_AS(counts_of(decay, "x = 1/2", "0"), error);
}

// x = s + (t - a) (t - b) (t - c) or s - ..., s in an interval, for fractions a, b, c of which two or three are often equal.
// The changes of sign for a number s are counted on a grid; two roots between neighbours of it would be missed, and the test
// would fail.
TEST_CASE("the numbers of events of cubic polynomials are among those found", "[ode][proved][sets]") {
    tests::corner_numbers from(3);
    int decided = 0;
    for (int trial = 0; trial < 15; ++trial) {
        std::vector<rational> roots;
        for (int i = 0; i < 3; ++i) {
            roots.emplace_back(from.half([&] { return from.between(2, 4) * 6; }, [&] { return from.between(3, 27); }),
                               8);
        }
        const rational width(from.between(0, 3), 16);
        const int sign = from.one_in(2) ? 1 : -1;
        const auto value = [&](const rational& s, const rational& t) {
            return rational(s + sign * (t - roots[0]) * (t - roots[1]) * (t - roots[2]));
        };
        const auto one = [](const rational& q) { return "(" + q.str() + ")"; };
        std::string product = std::to_string(sign);
        std::string slope;
        for (std::size_t i = 0; i < 3; ++i) {
            slope += std::string(i == 0 ? "" : " + ") + "(t - " + one(roots[(i + 1) % 3]) + ")*(t - " +
                     one(roots[(i + 2) % 3]) + ")";
            product += "*(-" + one(roots[i]) + ")";
        }
        const std::string problem = "x' = " + std::to_string(sign) + "*(" + slope + "); x(0) = [" + product + " - " +
                                    one(width) + ", " + product + " + " + one(width) + "]";
        INFO(problem);
        const auto found = event_counts(parse(problem), {.condition = "x = 0", .before = number(4), .most_parts = 8});
        decided += found.missing ? 0 : 1;
        for (int sample = -2; sample <= 2 && !found.missing; ++sample) {
            const rational s = width * sample / 2;
            long changes = 0;
            int last = 0;
            for (long i = 0; i <= 512; ++i) {
                const int here = value(s, rational(i, 128)).sign();
                changes += here * last < 0 ? 1 : 0;
                last = here == 0 ? last : here;
            }
            INFO(s.str() << ": " << changes);
            CHECK(std::ranges::find(found.counts, changes) != found.counts.end());
        }
    }
    CHECK(decided > 7);
}

}  // namespace query_sets_event_counts_test
