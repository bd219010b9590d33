// Cases in which proofs of solutions end or take special branches: sets about 0, infinite maps, events between steps,
// limits.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/event/zero_search.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/integration/lohner_set.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/integration/singular_step.hpp"
#include "libration/plane/radius_bound.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/known/falkner_skan.hpp"
#include "libration/problem/known/painleve_1.hpp"
#include "libration/problem/known/sir.hpp"
#include "libration/query/condition_numbers.hpp"
#include "libration/query/shooting/proved_unknowns.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace integration_ways_out_test {

using namespace libration;
using namespace libration::ode;

namespace {

explicit_system typed(const std::string& text) { return explicit_system(parse(text)); }

number time_of(const std::string& text) { return parse_constant(text).constant(); }

ball about(const ball& x, long exponent) { return widened(x, magnitude::of(1, exponent)); }

constexpr long bits_of_flows = 100;

// Two flows with z w = 1.
explicit_system flows() { return typed("z' = -z; w' = w; z(0) = 1; w(0) = 1"); }

// The end of a quarter of the first step of a search for events of the flows, exactly.
rational part_of_first_step(int quarters) {
    integration along(start_of(flows(), bits_of_flows), rule_for(flows(), {bits_of_flows}), infinite_distance(1),
                      bits_of_flows);
    const step* const first = along[0];
    REQUIRE(first != nullptr);
    const precision_scope scope(decimal_digits(bits_of_flows));
    const mpfr distance = midpoint_of(exact_multiple(first->length(), static_cast<unsigned long>(quarters), -2));
    rational time;
    mpfr_get_q(time.backend().data(), handle(distance));
    return time;
}

rational before_by_70_bits(const rational& time) { return time * (1 - rational(1, pow(integer(2), 70U))); }

}  // namespace

// y' = y from the box 0 +- 2^-50: e times it at t = 1, and at most twice that.
TEST_CASE("a set about 0 is marched", "[ode][proved]") {
    const precision_scope scope(40);
    proved_march march(typed("y' = y; y(0) = 0"), {about(ball(0), -50)}, 120);
    const auto state = march.at(ball(1));
    REQUIRE(state);
    const ball edge = exp(ball(1)) * pow(ball(2), -50);
    CHECK(certainly_less(abs((*state)[0]), edge * 2));
    CHECK(arb_contains((*state)[0].handle(), exact_midpoint(edge * 99 / 100).handle()) != 0);
}

// Where the flow contracts the set, by exp(-80), the centre gains bits again: of 2^-40 2^-155 are left.
TEST_CASE("precision rises where a set shrinks", "[ode][proved]") {
    const precision_scope scope(80);
    proved_march march(typed("y' = 20 - 20*y; y(0) = 2"), {about(ball(2), -40)}, 200);
    const auto state = march.at(ball(4));
    REQUIRE(state);
    CHECK(overlaps((*state)[0], ball(1) + exp(ball(-80))));
    CHECK(certainly_less(radius_of((*state)[0]), pow(ball(2), -150)));
}

TEST_CASE("a march says how far it is", "[ode][proved]") {
    long calls = 0;
    proved_march march(typed("y'' = -y; y(0) = 1; y'(0) = 0"), 80, [&](const ball&, long) { ++calls; });
    REQUIRE(march.at(time_of("300")));
    CHECK(march.steps() / 64 == calls);
    CHECK(calls > 0);
}

TEST_CASE("a march with many bits says how far it is after every step", "[ode][proved]") {
    long calls = 0;
    proved_march march(typed("y' = -y^2; y(0) = 1"), 4200, [&](const ball&, long) { ++calls; });
    REQUIRE(march.at(time_of("2")));
    CHECK(march.steps() == calls);
    CHECK(calls > 0);
}

// y = 0 at all times, beside a z that may be 0.
TEST_CASE("an equilibrium is not marched in a set where its equation has no value", "[ode][proved]") {
    proved_march march(typed("y' = y/z; z' = 0; y(0) = 0; z(0) = 1"), {ball(0), about(ball(1), 1)}, 120);
    CHECK_FALSE(march.at(ball(1)));
    CHECK(march.end() == stop::precision);
}

// x' = 1/y at y = 0, about it, and so near that the set reaches 0.
TEST_CASE("a march ends where a quotient has no value", "[ode][proved]") {
    const auto system = typed("y' = 1/y; x' = 0; y(0) = 1; x(0) = 1");
    const auto end_from = [&](const ball& y) {
        proved_march march(system, {y, ball(1)}, 120);
        CHECK_FALSE(march.at(ball(1)));
        return march.end();
    };
    CHECK(end_from(ball(0)) == stop::step_too_small);
    CHECK(end_from(about(ball(0), -60)) == stop::precision);
    CHECK(end_from(about(pow(ball(2), -40), -39)) == stop::precision);
    CHECK(end_from(about(pow(ball(2), -60), -59)) == stop::precision);
}

// t = c with c at the end of a quarter of the first step: it is on both sides of it, and counted once.
TEST_CASE("an event between two pieces of a step is one", "[ode][proved]") {
    for (const int part : {1, 2, 3, 4}) {
        const rational time = part_of_first_step(part);
        zero_search search(flows(), variable() - ode::expression(time), bits_of_flows);
        const precision_scope scope(decimal_digits(bits_of_flows));
        const auto first = search.next(crossing::any, std::nullopt);
        REQUIRE(first);
        CHECK(contains(first->time, from_rational<ball>(time)));
        CHECK_FALSE(search.next(crossing::any, number(rational(time * 8))));
        CHECK(search.end() == search_end::time);
    }
}

// The same with z w - 1 = 0 added, which is known to the working precision alone, and c moved by less and more than that.
TEST_CASE("an event next to the end of a piece is one", "[ode][proved]") {
    const auto noise = unknown("z") * unknown("w") - ode::expression(1);
    for (const int part : {1, 4}) {
        const rational time = part_of_first_step(part);
        for (const unsigned exponent : {80U, 96U, 100U, 104U, 108U, 112U, 120U, 140U}) {
            for (const int side : {-1, 1}) {
                CAPTURE(part, exponent, side);
                const rational moved = time * (1 + rational(side, pow(integer(2), exponent)));
                const precision_scope scope(100);  // in which the truth is exact
                zero_search search(flows(), variable() - ode::expression(moved) + noise, bits_of_flows);
                const auto first = search.next(crossing::any, std::nullopt);
                REQUIRE(first);
                CHECK(contains(first->time, from_rational<ball>(moved)));
                CHECK(first->way == crossing::up);
                CHECK_FALSE(search.next(crossing::any, number(rational(time * 8))));
                CHECK(search.end() == search_end::time);
                // Searched to c alone, it is none if it certainly comes later.
                zero_search until(flows(), variable() - ode::expression(moved) + noise, bits_of_flows);
                const auto before = until.next(crossing::any, number(time));
                CHECK((before || side > 0));
                CHECK((!before || overlaps(before->time, first->time)));
            }
        }
    }
}

// (t - c)^2 = d^2 about a turn c at the end of a quarter of the first step, and before it by less than 20 digits tell.
TEST_CASE("a condition turns between two pieces of a step", "[ode][proved]") {
    for (const int part : {1, 4}) {
        for (const rational& turn : {part_of_first_step(part), before_by_70_bits(part_of_first_step(part))}) {
            for (const unsigned exponent : {20U, 60U}) {
                CAPTURE(part, turn, exponent);
                const rational away = turn / pow(integer(2), exponent);
                const auto from_turn = variable() - ode::expression(turn);
                zero_search search(flows(), from_turn * from_turn - ode::expression(rational(away * away)),
                                   bits_of_flows);
                const precision_scope scope(100);  // in which the truth is exact
                for (const int side : {-1, 1}) {
                    const auto found = search.next(crossing::any, std::nullopt);
                    REQUIRE(found);
                    CHECK(contains(found->time, from_rational<ball>(rational(turn + side * away))));
                    CHECK(found->way == (side < 0 ? crossing::down : crossing::up));
                }
            }
        }
    }
}

TEST_CASE("a search ends at the end of its first step", "[ode][proved]") {
    const rational time = part_of_first_step(4);
    zero_search search(flows(), variable() - ode::expression(rational(time * 2)), bits_of_flows);
    CHECK_FALSE(search.next(crossing::any, number(time)));
    CHECK(search.end() == search_end::time);
}

// y = (a - b) t with a - b of about 1e-64: 100 bits do not tell its sign after the start, 400 bits do.
TEST_CASE("a slope that is not told from 0 leaves what follows a start undecided", "[ode][proved]") {
    const auto system = typed(
        "y' = a - b; a' = 0; b' = 0; y(0) = 0; a(0) = pi; "
        "b(0) = 3.141592653589793238462643383279502884197169399375105820974944592");
    const auto end = [&](long bits) {
        zero_search search(system, unknown("y"), bits);
        CHECK_FALSE(search.next(crossing::any, number(rational(1))));
        return search.end();
    };
    CHECK(end(100) == search_end::undecided);
    CHECK(end(400) == search_end::time);
}

TEST_CASE("events about a singular start", "[ode][proved][singular]") {
    const auto system = parse(std::string(problem_text("lane_emden")));
    const auto first_zero = [&](const std::string& condition, int direction) {
        zero_search search(explicit_system(system), parse_condition(system, condition), 100, direction);
        return search.next(crossing::any, std::nullopt);
    };
    CHECK(first_zero("y = 1/2", 1));
    CHECK_THROWS_WITH(first_zero("y = 1/2", -1), Catch::Contains("only after it"));
    CHECK_THROWS_WITH(first_zero("y = 1", 1), Catch::Contains("within the first step"));
}

TEST_CASE("frames of flat maps, and no frame of an infinite one", "[ode][proved]") {
    const lohner_set box({magnitude(1U), magnitude(1U)});
    const lohner_set flat = box.moved({{ball(1), ball(0)}, {ball(0), ball(0)}}, {magnitude(), magnitude()});
    CHECK(certainly_less(abs(flat.reach(0).exact() - 1), pow(ball(2), -20)));
    CHECK(flat.radii()[1].is_zero());
    const ball infinite = ball(1) / 0;
    CHECK_THROWS_AS(box.moved({{infinite, ball(0)}, {ball(0), ball(1)}}, {magnitude(), magnitude()}),
                    precision_exhausted);
}

TEST_CASE("unknowns that conditions do not hold, or whose solutions end", "[ode][proved]") {
    const auto find = [](const std::string& text, const std::string& name, const std::string& unknown) {
        return proved_unknowns(parse(text), {name}, {{unknown, 0, time_of("1"), time_of("2")}}, 10);
    };
    CHECK_THROWS_WITH(find("y' = y; x' = k; y(0) = 1; x(0) = 0; k = 1", "k", "y"), Catch::Contains("not isolated"));
    CHECK_THROWS_WITH(find("y' = k*y^2; y(0) = 1; k = 3", "k", "y"), Catch::Contains("better initial guess"));
}

// With y = 0 the effect of its initial value is 0, which no width conceals.
TEST_CASE("an unknown that is 0 has no relative condition", "[ode][proved][condition]") {
    const auto found = proved_conditions(parse("y' = y*sin(z); z' = z; y(0) = 0; z(0) = 1/3"), {time_of("1")}, 10);
    CHECK(found.front().moved[0].by_start == 0);
    CHECK(found.front().moved[0].by_parameters == 0);
    CHECK(found.front().moved[1].by_start > 0);
}

TEST_CASE("coverings that are small, and that have a limit", "[ode][proved][singularity]") {
    const precision_scope scope(40);
    const complex_flow flow(typed("y' = y^2; y(0) = 1"), 100);
    const covering small = covered_disc(flow, exact_midpoint(ball(1) / 8), {1}, {});
    CHECK(small.complete);
    CHECK(small.discs.size() == 1);
    // A narrow sector, whose first cell is longer than wide.
    CHECK(covered_disc(flow, exact_midpoint(ball(99) / 100), {48}, {}).complete);
    for (const int percent : {101, 150}) {
        const covering beyond = covered_disc(flow, exact_midpoint(ball(percent) / 100), {48}, {.finest_bits = 16});
        CHECK_FALSE(beyond.complete);
        CHECK(certainly_less(beyond.covered, ball(1)));
    }
    const covering limited = covered_disc(flow, exact_midpoint(ball(99) / 100), {1}, {.most_discs = 3});
    CHECK_FALSE(limited.complete);
    CHECK(limited.reason.find("more than 3 discs") != std::string::npos);
    // A path that begins with a stationary segment, and one whose discs become too small.
    CHECK(loop_about(flow, {complex_ball(0)}, complex_ball(1), magnitude::of(1, -8), 0, {0}).evidence ==
          loop_evidence::integral);
    const complex_flow kepler(typed("x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2); x(0) = 2/5; x'(0) = 0; "
                                    "y(0) = 0; y'(0) = 2"),
                              64);
    const mpfr collision("0.29861228866811");
    CHECK_THROWS(
        loop_about(kepler, {}, exact_midpoint(complex_ball(ball(0), ball(collision))), magnitude::of(1, -30), 0, {0}));
}

// About an equilibrium, y = 0 and z = t, only the variations determine the step: v' = t v.
TEST_CASE("discs about equilibria", "[ode][proved][singularity]") {
    const precision_scope scope(40);
    const complex_flow flow(typed("y' = y*z + y^2; z' = 1; y(0) = 0; z(0) = 0"), 100);
    const complex_disc disc(flow);
    CHECK(certainly_less(ball(1), disc.radius().exact()));
    const auto values = values_of(disc.moved_to(complex_ball(1)));
    CHECK(contains_zero(values[0].re));
    CHECK(overlaps(values[1].re, ball(1)));
    CHECK_THROWS_AS(disc.moved_to(complex_ball(disc.radius().exact() * 2)), error);
    CHECK_THROWS_AS(disc.values_over(complex_ball(disc.radius().exact() * 2)), error);
}

// 1/y over a set that contains 0.
TEST_CASE("a set over which a quotient has no value has no disc", "[ode][proved][singularity]") {
    const complex_flow flow(typed("y' = 1/y; y(0) = 1"), 100);
    const complex_set wide{complex_ball(0), {complex_ball(1)}, {0}, lohner_set({magnitude(2U), magnitude(2U)})};
    CHECK_THROWS_AS(complex_disc(flow, wide), precision_exhausted);
}

TEST_CASE("singular starts with a difference, third order, and 0", "[ode][proved][singular]") {
    const precision_scope scope(40);
    // w = sin(t)/t + t^2/6 - 1 of w'' + 2 w'/t = -sin(t)/t + 1 by s = sin(t)/t as a second unknown.
    const auto step = proved_singular_step(
        typed("t*w'' + 2*w' = t - t*s; t*s'' + 2*s' = -t*s; w(0) = 0; w'(0) = 0; s(0) = 1; s'(0) = 0"), 80);
    const ball t = constant_value<ball>::of(step.beyond.point());
    CHECK(overlaps(step.state[0], sin(t) / t + t * t / 6 - 1));
    // y = t/2.
    const auto line = proved_singular_step(typed("t*y' = t - y; y(0) = 0"), 80);
    CHECK(overlaps(line.state[0], constant_value<ball>::of(line.beyond.point()) / 2));
    CHECK_THROWS_WITH(proved_singular_step(typed("t*y''' + 3*y'' = -y''^2; y(0) = 1; y'(0) = 0; y''(0) = 0"), 80),
                      Catch::Contains("second derivatives"));
    // n + 100 is at least n - |100|, by which powers from 100 on alone are known to be determined.
    const tape of = tape::about_start(typed("t*y' = t - 100*y; y(0) = 0"));
    taylor_expansion<ball> expansion(of, 48);
    expansion.about_start();
    CHECK_FALSE(bounded_singular_tail(of, expansion, 40, magnitude(1U)));
}

TEST_CASE("conditions at infinity without what they need", "[ode][proved]") {
    CHECK_THROWS_WITH(falkner_skan_shear(parse("f''' + f*f'' + 1 - f'^2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 1")),
                      Catch::Contains("no parameter"));
    const precision_scope scope(30);
    CHECK_THROWS_AS(tritronquee_far_out(0, 3), precision_exhausted);
    CHECK_THROWS_AS(tritronquee_far_out(6, 0), precision_exhausted);  // s = 5/8
    // S - r log S is the same at the initial and the final time.
    const ball s(100);
    const ball i(3);
    const ball rho(60);
    const ball left = epidemic_remainder(s, i, rho);
    CHECK(overlaps(left - rho * log(left), s + i - rho * log(s)));
    CHECK_THROWS_AS(epidemic_remainder(about(s, 7), i, rho), precision_exhausted);
}

}  // namespace integration_ways_out_test
