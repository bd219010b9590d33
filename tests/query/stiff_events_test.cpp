// Events on steps of collocation: closed forms, the contract of the search, and the enclosures of values and
// derivatives along a tube on which it relies.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/collocation/tube_proof.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace query_stiff_events_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long digits = 20;

// u = 1/(1 + t), and v tends to u^2 like exp(-1e8 t).
const std::string decay = "u' = -u^2; v' = -1e8*(v - u^2) - 2*u^3; u(0) = 1; v(0) = 2";
// y tends to cos t like exp(-1e6 t).
const std::string wave = "y' = -1e6*(y - cos(t)) - sin(t); y(0) = 2";

event_report search(const std::string& text, const std::string& condition, event_request request,
                    integrator_choice integrator = integrator_choice::automatic) {
    const equation_system equations = parse(text);
    request.g = parse_condition(equations, condition);
    proof_route route;
    route.integrator = integrator;
    return searched_events(explicit_system(equations), request, digits, route);
}

bool is_near(const proved_decimal& found, const ball& truth) {
    const precision_scope scope(60);
    const ball most = abs(truth) * pow(ball(10), 1 - digits);
    return certainly_less(abs(constant_value<ball>::of(parse_constant(found.text).constant()) - truth), most);
}

}  // namespace

TEST_CASE("events of stiff solutions are those of their closed forms", "[ode][proved]") {
    const precision_scope scope(60);
    for (const auto integrator : {integrator_choice::automatic, integrator_choice::collocation}) {
        const auto thousandth = search(decay, "u = 1/1000", {}, integrator);
        REQUIRE(thousandth.events.size() == 1);
        CHECK(thousandth.events.front().time.decimal.value().text == "999.00000000000000000");
        CHECK(thousandth.collocation.size() == 1);
    }
    const auto small = search(decay, "v = 1e-10", {});
    REQUIRE(small.events.size() == 1);
    CHECK(is_near(small.events.front().time.decimal.value(), ball(99'999)));
    CHECK(is_near(small.events.front().values[0].decimal.value(), ball(1) / ball(100'000)));
}

TEST_CASE("every crossing of a stiff solution is found once, in its order and direction", "[ode][proved]") {
    const precision_scope scope(60);
    const ball half_turn = pi<ball>() / 2L;
    const auto all = search(wave, "y = 0", {.g = {}, .count = 4});
    REQUIRE(all.events.size() == 4);
    CHECK(all.collocation.size() == 1);
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(is_near(all.events[k].time.decimal.value(), half_turn * static_cast<long>(2 * k + 1)));
    }
    const auto up = search(wave, "y = 0", {.g = {}, .way = crossing::up, .count = 2});
    REQUIRE(up.events.size() == 2);
    CHECK(up.events[0].time.decimal.value().text == all.events[1].time.decimal.value().text);
    CHECK(up.events[1].time.decimal.value().text == all.events[3].time.decimal.value().text);
    const auto before = search(wave, "y = 0", {.g = {}, .count = 9, .before = number(rational(6))});
    CHECK(before.events.size() == 2);
    REQUIRE(before.missing);
    const auto never = search(wave, "y = -2", {.g = {}, .before = number(rational(20))});
    CHECK(never.events.empty());
    CHECK(never.collocation.size() == 1);
}

// The curves x = (1 + e) t and y = e/1024 near x = t and solutions of y' = -1024 y with |y(0) - e/1024| <= e: the
// derivative 1 of x differs by e from that of the curve, and -1024 e of y = e exp(-1024 t) at the start by as much.
TEST_CASE("derivatives along a tube are enclosed by its defect and its width", "[ode][proved]") {
    const precision_scope scope(60);
    const auto form = lifted(explicit_system(parse("x' = 1; y' = -1024*y; x(0) = 0; y(0) = 0")));
    const polynomial_map map(form);
    const ball e = pow(ball(2), -60L);
    const ball half = (ball(1) + e) * pow(ball(2), -1L);
    const std::vector<ball_polynomial> unit{{ball(1)}, {}, {}, {ball(1)}};
    const tube_candidate neighbour{
        {ball(0), ball(1)}, {0, 0}, {{half, half}, {e * pow(ball(2), -10L)}}, {unit, unit, {1, 1}, 1}};
    const tube_set start{{{ball(0), ball(0)}, lohner_set({}, {}, {}, {magnitude(), magnitude(e)})}, 0};
    tube_proof proof(map, 200, 200, 200);
    const auto tube = proof.tube(neighbour, start, supremum_rule::coefficients);
    REQUIRE(tube);
    const auto errors = proof.slope_errors(*tube);
    for (const ball& place : {ball(0), ball(1) / 2L, enclose(ball(1) / 2L, ball(1) / 2L)}) {
        const auto slopes = tube->slopes_at(place, errors);
        CHECK(arb_contains_si(slopes[0].handle(), 1) != 0);
        CHECK(certainly_less(radius_of(slopes[0]), e * 2L));
        CHECK(arb_contains((slopes[1]).handle(), (e * ball(-1024)).handle()) != 0);
        CHECK(certainly_less(radius_of(slopes[1]), e * 4096L));
    }
}

// T_60 is between -1 and 1, while the powers in it are up to 10^22.
TEST_CASE("a polynomial is enclosed closely over wide parts of a step", "[ode][proved]") {
    const precision_scope scope(80);
    std::vector<ball> coefficients(61);
    coefficients.back() = ball(1);
    const ball_polynomial chebyshev = chebyshev_form::in_powers(coefficients);
    for (const long part : {0L, 3L, 32L, 63L}) {
        const ball middle = ball(2 * part - 64) / 64L;
        const ball wide = enclose(middle, ball(1) / 1'000'000L);
        const ball value = value_over(chebyshev, wide);
        for (const long side : {-1L, 0L, 1L}) {
            const ball here = middle + ball(side) / 1'000'000L;
            CHECK(overlaps(value, value_of(chebyshev, here)));
        }
        CHECK(certainly_less(radius_of(value), ball(1) / 200L));  // |T_60'| <= 3600
    }
}

}  // namespace query_stiff_events_test
