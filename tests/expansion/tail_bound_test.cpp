// Theorem T compared with closed forms: the bound holds at every distance, is not much larger than the true error, and
// never reaches a singularity.
#include "libration/expansion/tail_bound.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "proved.hpp"

namespace expansion_tail_bound_test {

using namespace libration;
using namespace libration::ode;

namespace {

magnitude part(unsigned long hundredths) { return magnitude::of(hundredths * 10486, -20); }

struct bounded {
    bounded(const std::string& text, int order, const std::vector<ball>& start)
        : system(parse(text)),
          polynomial(lifted(system)),
          made(tape::about_points(polynomial.system)),
          expansion(made, order) {
        expression_values<ball> values(polynomial.leaves, ball(0));
        for (const ball& each : start) {
            values.push_back(each);
        }
        for (const ode::expression& each : polynomial.added) {
            values.push_back(values.of(each));
        }
        solution_state<ball> state;
        for (const ball& each : values.values()) {
            state.push_back({each});
        }
        expansion.about(ball(0), state);
    }
    std::optional<tail_bound> within(const magnitude& radius) const {
        return bounded_tail(made, expansion, ball(0), radius);
    }
    explicit_system system;
    polynomial_form polynomial;
    tape made;
    taylor_expansion<ball> expansion;
};

// |y(t) - p(t)| <= bound for t = +-rho, +-rho/2, rho/10, and at most `loose` times as large at one of them.
void check_bound(const bounded& of, const magnitude& radius, const std::function<ball(const ball&)>& solution,
                 long loose) {
    const auto bound = of.within(radius);
    REQUIRE(bound.has_value());
    bool near = false;
    for (const ball& part_of : {ball(1), ball(-1), ball(1) / 2, ball(-1) / 2, ball(1) / 10}) {
        const ball t = radius.exact() * part_of;
        const ball error = abs(solution(t) - of.expansion.at(t)[0][0]);
        const ball allowed = bound->at(0, magnitude(t)).exact();
        INFO(tests::text_of(t) << "  " << tests::text_of(error) << "  " << tests::text_of(allowed));
        CHECK(!certainly_less(allowed, error));
        near = near || !certainly_less(error * loose, allowed);
    }
    CHECK(near);
}

}  // namespace

// u_1' = u_1 and u_i' = u_(i-1) from 1, 0, .., 0: u_i = sum_(k >= i-1) t^k/k!. Beyond u_(N+1) all coefficients up to
// t^N vanish, and so do the first defects.
TEST_CASE("theorem T bounds long chains of unknowns", "[ode][proved]") {
    constexpr int size = 100;
    const precision_scope scope(60);
    std::string text = "u1' = u1; u1(0) = 1";
    std::vector<ball> start{ball(1)};
    for (int i = 2; i <= size; ++i) {
        text += "; u" + std::to_string(i) + "' = u" + std::to_string(i - 1) + "; u" + std::to_string(i) + "(0) = 0";
        start.emplace_back(0);
    }
    const bounded chain(text, 10, start);
    const magnitude radius = part(50);
    const auto bound = chain.within(radius);
    REQUIRE(bound.has_value());
    ball term = ball(1);
    for (int i = 2; i <= size; ++i) {
        term = term * radius.exact() / (i - 1);
        if (i > 12) {  // the first term of u_i is below its sum
            CHECK(!certainly_less(bound->at(static_cast<std::size_t>(i - 1), radius).exact(), term));
        }
    }
}

// All coefficients are positive, so that at t = +rho nothing cancels; the first error is rho^(N+1)/(N+1)! (1 +
// rho/(N+2) + ..), and the bound has rho/(N+2) in each term: for rho much below N it is the truth up to (rho/N)^2,
// which shows any other denominator.
TEST_CASE("theorem T is sharp for the exponential", "[ode][proved]") {
    const int order = GENERATE(1, 2, 3, 8, 20);
    const precision_scope scope(60);
    const bounded growth("y' = y; y(0) = 1", order, {ball(1)});
    const magnitude radius = part(10);
    const auto bound = growth.within(radius);
    REQUIRE(bound.has_value());
    const ball t = radius.exact();
    const ball error = exp(t) - growth.expansion.at(t)[0][0];
    const ball ratio = bound->error[0].exact() / error;
    CAPTURE(order, tests::text_of(ratio));
    CHECK(!certainly_less(ratio, ball(1)));
    // 1/(1 - r) - (1 + r + r^2 (N+2)/(N+3)) < r^2/2, r = rho/(N+2) <= 1/30, and 2^-20 for the roundings of 30 bits.
    CHECK(certainly_less(ratio, ball(1) + ball(1) / 1000));
}

TEST_CASE("theorem T holds for closed forms, near their radius and far from it", "[ode][proved]") {
    const int order = GENERATE(5, 20, 60);
    const unsigned long hundredths = GENERATE(20UL, 50UL, 70UL);
    const precision_scope scope(80);
    CAPTURE(order, hundredths);
    const magnitude rho = part(hundredths);
    if (order >= 20 || hundredths <= 20) {
        check_bound(
            {"y' = y^2; y(0) = 1", order, {ball(1)}}, rho, [](const ball& t) { return ball(1) / (ball(1) - t); }, 200);
        check_bound(
            {"y' = 1 + y^2; y(0) = 0", order, {ball(0)}}, rho, [](const ball& t) { return tan(t); }, 200);
        check_bound(
            {"y' = -y^3; y(0) = 1", order, {ball(1)}}, rho * magnitude::of(1, -1),
            [](const ball& t) { return ball(1) / sqrt(ball(1) + t * 2); }, 200);
        check_bound(
            {"y' = exp(-y); y(0) = 0", order, {ball(0)}}, rho * magnitude::of(1, -1),
            [](const ball& t) { return log(ball(1) + t); }, 1000);
        check_bound(
            {"y' = y*t; y(0) = 1", order, {ball(1)}}, rho, [](const ball& t) { return exp(t * t / 2); }, 1000);
    }
    check_bound(
        {"y'' = -y; y(0) = 0; y'(0) = 1", order, {ball(0), ball(1)}}, rho, [](const ball& t) { return sin(t); }, 200);
    check_bound(
        {"y' = cos(y); y(0) = 0", order, {ball(0)}}, rho * magnitude::of(1, -1),
        [](const ball& t) { return atan(sinh(t)); }, 10'000);
}

TEST_CASE("nothing is proved at a radius that a singularity is inside of", "[ode][proved]") {
    const int order = GENERATE(1, 4, 20, 60, 120);
    const precision_scope scope(80);
    CAPTURE(order);
    const bounded pole("y' = y^2; y(0) = 1", order, {ball(1)});
    CHECK_FALSE(pole.within(magnitude(1U)).has_value());
    CHECK_FALSE(pole.within(part(101)).has_value());
    const bounded branch("y' = -y^3; y(0) = 1", order, {ball(1)});
    CHECK_FALSE(branch.within(part(51)).has_value());
    if (order >= 20) {  // Lifted and given have the same radius here, of which this share is proved.
        CHECK(pole.within(part(order == 20 ? 80 : 90)).has_value());
    }
}

// x = t^2/2 and y = t^2 are only in the error at order 1, and z = t^5/10 comes from the product of both.
TEST_CASE("the product of two errors is an error", "[ode][proved]") {
    const precision_scope scope(40);
    const bounded all("x' = t; y' = 2*t; z' = x*y; x(0) = 0; y(0) = 0; z(0) = 0", 1, {ball(0), ball(0), ball(0)});
    const magnitude radius = part(50);
    const auto bound = all.within(radius);
    REQUIRE(bound.has_value());
    const ball t = radius.exact();
    CHECK(!certainly_less(bound->error[0].exact(), t * t / 2));
    CHECK(!certainly_less(bound->error[2].exact(), t * t * t * t * t / 10));
}

// y = c/(1 - c t) for every c of the ball, at its ends too.
TEST_CASE("the bound holds for every start of a wide ball", "[ode][proved]") {
    const precision_scope scope(60);
    const ball start = widened(ball(1), part(5));
    const bounded all("y' = y^2; y(0) = 1", 20, {start});
    const auto bound = all.within(part(60));
    REQUIRE(bound.has_value());
    for (const ball& c : {lower_bound(start), ball(1), upper_bound(start)}) {
        const bounded one("y' = y^2; y(0) = 1", 20, {c});
        const ball t = part(60).exact();
        const ball error = abs(c / (ball(1) - c * t) - one.expansion.at(t)[0][0]);
        CHECK(!certainly_less(bound->error[0].exact(), error));
    }
}

}  // namespace expansion_tail_bound_test
