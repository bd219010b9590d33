// The derivative of the flow as a product of the Jacobian matrix, against closed forms, with its tail.
#include "libration/expansion/flow_variations.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/set_values.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace expansion_flow_variations_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long bits = 160;

struct expanded {
    explicit expanded(const std::string& text, int order, const std::vector<ball>& about = {})
        : system(parse(text)),
          form(lifted(system, relative_functions::kept)),
          jacobian(form),
          expansion(jacobian, order) {
        const auto start = about.empty() ? enclosed_start(system, bits) : about;
        expansion.about(ball(0), lifted_values(form, ball(0), start));
        tail = expansion.tail(ball(0), expansion.estimated_radius());
    }

    ball polynomial(std::size_t i, std::size_t j, const ball& distance) const {
        const ball* const first = expansion.coefficients(i, j);
        const series::power_series<ball> values(std::vector<ball>(first, first + expansion.order() + 1));
        return evaluate_value(values, distance);
    }
    // V_ij at a distance, with the tail.
    ball at(std::size_t i, std::size_t j, const ball& distance) const {
        return widened(polynomial(i, j, distance), tail->at(form.given * (j + 1) + i, magnitude(distance)));
    }

    explicit_system system;
    polynomial_form form;
    jacobian_form jacobian;
    flow_variations expansion;
    std::optional<tail_bound> tail;
};

bool overlap(const ball& a, const ball& b) { return arb_overlaps(a.handle(), b.handle()) != 0; }

}  // namespace

// y' = y^2: dy/dy0 = 1/(1 - t y0)^2. z' = y z: z = z0/(1 - t y0), so that dz/dy0 = z0 t/(1 - t y0)^2.
TEST_CASE("the derivative of the flow by the Jacobian matrix contains closed forms at every order") {
    const precision_scope scope(decimal_digits(bits));
    for (const int order : {2, 3, 5, 9, 20, 40}) {
        CAPTURE(order);
        const expanded of("y' = y^2; z' = y*z; y(0) = 1; z(0) = 3", order);
        REQUIRE(of.tail);
        for (const long part : {250L, 500L, 750L, 990L}) {
            const ball t = exact_midpoint(of.tail->radius.exact() * part / 1000);
            const ball flow = 1 / ((1 - t) * (1 - t));
            CHECK(overlap(of.at(0, 0, t), flow));
            CHECK(overlap(of.at(1, 0, t), 3 * t * flow));
            CHECK(overlap(of.at(1, 1, t), 1 / (1 - t)));
            CHECK(arb_is_zero(of.at(0, 1, t).handle()) != 0);
            CHECK_FALSE(overlap(of.polynomial(0, 0, t), flow));  // the tail is needed
        }
    }
}

// y' = sin(z), z' = 1: the form has two more unknowns, the sine and the cosine. dy/dz0 = sin(z0 + t) - sin(z0).
TEST_CASE("the derivative of the flow passes through the unknowns of the polynomial form") {
    const precision_scope scope(decimal_digits(bits));
    const expanded of("y' = sin(z); z' = 1; y(0) = 0; z(0) = 1", 12);
    REQUIRE(of.tail);
    CHECK(of.jacobian.entries().size() == 1);
    for (const long part : {-990L, 500L, 990L}) {
        const ball t = exact_midpoint(of.tail->radius.exact() * part / 1000);
        CHECK(overlap(of.at(0, 1, t), sin(1 + t) - sin(ball(1))));
        CHECK(overlap(of.at(0, 0, t), ball(1)));
    }
}

// Of a set about y0 = 1, the derivative at each of its points.
TEST_CASE("the derivative of the flow is that of every solution from a set") {
    const precision_scope scope(decimal_digits(bits));
    const ball set = widened(ball(1), magnitude::of(1, -6));
    const expanded of("y' = y^2; y(0) = 1", 10, {set});
    REQUIRE(of.tail);
    for (const ball& start : {lower_bound(set), upper_bound(set)}) {
        const ball t = exact_midpoint(of.tail->radius.exact() * 9 / 10);
        CHECK(overlap(of.at(0, 0, t), 1 / ((1 - t * start) * (1 - t * start))));
    }
}

// Theorem V in 8 unknowns, with the Jacobian matrix, and the same motions in 4 each, without it.
TEST_CASE("eight unknowns have the states of two times four") {
    const auto motion = [](const std::string& x, const std::string& y) {
        return x + "'' = -" + x + "/(" + x + "^2 + " + y + "^2)^(3/2); " + y + "'' = -" + y + "/(" + x + "^2 + " + y +
               "^2)^(3/2); ";
    };
    const std::string first = "x(0) = 1; y(0) = 0; x'(0) = 0; y'(0) = 6/5; ";
    const std::string joined = "u(0) = 1/2; v(0) = 0; u'(0) = 1/10; v'(0) = 3/2; w' = x*u - w; w(0) = 1";
    proof_route route;
    route.integrator = integrator_choice::taylor;
    const std::vector<number> times{number(rational(1)), number(rational(5))};
    const auto both = proved_trajectory(explicit_system(parse(motion("x", "y") + motion("u", "v") + first + joined)),
                                        times, 20, {}, route);
    const auto alone = proved_trajectory(explicit_system(parse(motion("x", "y") + first)), times, 20, {}, route);
    for (std::size_t i = 0; i < times.size(); ++i) {
        for (std::size_t k = 0; k < alone[i].size(); ++k) {
            CHECK(both[i][k].text == alone[i][k].text);
        }
    }
}

}  // namespace expansion_flow_variations_test
