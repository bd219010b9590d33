// Stable manifolds compared with their closed forms: a soliton, a resonance, a conjugated linear field.
#include "../../src/libration/manifold/invariant_manifold.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "../../src/libration/algebra/dense_matrix.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace manifold_invariant_manifold_test {

using namespace libration;
using namespace libration::ode;

namespace {

// The manifold of an equilibrium at 0.
struct manifold_at_zero {
    polynomial_form lifted;
    tape steps;
    field_at_rest field;
    frame_plan plan;

    explicit manifold_at_zero(const std::string& text, long scale = 0)
        : lifted(lifted_about_points(explicit_system(parse(text)))), steps(tape::about_points(lifted.system)) {
        const std::size_t n = lifted.leaves.size();
        field = {&steps, std::vector<complex_jet>(n), std::vector<std::size_t>(n), 1};
        std::iota(field.moving.begin(), field.moving.end(), std::size_t{0});
        plan = stable_plan(linear_part(field));
        plan.log2_scale = scale;
    }
    invariant_manifold to(int degree) const { return {field, *enclosed_frame(linear_part(field), plan), plan, degree}; }
};

complex_ball theta_of(const rational& x) { return {from_rational<ball>(x), ball(0)}; }

}  // namespace

// y'' = y - y^3 has y = sqrt 2 sech t = 2 sqrt 2 q/(1 + q^2), q = exp(-t); the largest entry of the eigenvector (1, -1)
// is 1, so that |theta| = 2 sqrt 2 q to first order.
TEST_CASE("the manifold of a soliton is enclosed with its tail", "[ode][proved]") {
    const precision_scope scope(60);
    const manifold_at_zero at("y'' = y - y^3; y(0) = 0; y'(0) = 0");
    for (const int degree : {6, 11, 20}) {
        const auto manifold = at.to(degree);
        const auto tails = manifold.tails();
        REQUIRE(tails);
        const auto point = manifold.at({theta_of(rational(1, 2))});
        const ball sign = decided_sign(point.value[0].value.re) > 0 ? ball(1) : ball(-1);
        const ball q = ball(1) / (sqrt(ball(2)) * 4);
        const ball y = sqrt(ball(2)) * 2 * q / (ball(1) + q * q) * sign;
        const magnitude bound = (*tails)[0] * pow(magnitude::of(1, -1), static_cast<unsigned long>(degree) + 1);
        CHECK(contains(widened(point.value[0].value.re, bound), y));
        // The tail is that of the series: the first omitted term is nonzero for odd degrees beyond.
        if (degree == 6) {
            const auto longer = manifold_at_zero("y'' = y - y^3; y(0) = 0; y'(0) = 0").to(40);
            const auto better = longer.at({theta_of(rational(1, 2))});
            const double error = std::fabs(as_double(better.value[0].value.re - point.value[0].value.re));
            CHECK(error > 0);
            CHECK(bound.above() < 100 * error);
        }
    }
}

// x' = -x, y' = -2 y + x^2 is resonant: h_y = -2 theta_2 + theta_1^2. z' = z + x y has the graph z = -x y/4 - x^3/16.
TEST_CASE("a resonance is in the normal form, and the graph beside it is exact", "[ode][proved]") {
    const precision_scope scope(40);
    const manifold_at_zero at("x' = -x; y' = -2*y + x^2; z' = z + x*y; x(0) = 0; y(0) = 0; z(0) = 0", -3);
    REQUIRE(at.plan.size() == 2);
    const auto manifold = at.to(6);
    const auto tails = manifold.tails();
    REQUIRE(tails);
    const auto point = manifold.at({theta_of(rational(1, 5)), theta_of(rational(-1, 3))});
    const auto& value = point.value;
    const ball& x = value[0].value.re;
    const ball& y = value[1].value.re;
    const ball z = value[2].value.re;
    CHECK(overlaps(z, -x * y / 4 - x * x * x / 16));
    for (const magnitude& each : *tails) {
        CHECK(each.above() < 1e-30);  // polynomials of degree 3 in all
    }
}

// x' = -x + x^2/4 has theta = x/(1 - x/4): with a linear field in (theta, u), u = w - x^2, u' = u + theta ..: w = x^2 on the manifold
// of w' = w - x^2 + 2 x (-x + x^2/4).
TEST_CASE("a manifold that is the graph of a parabola", "[ode][proved]") {
    const precision_scope scope(40);
    const manifold_at_zero at("x' = -x + x^2/4; w' = w - x^2 + 2*x*(-x + x^2/4); x(0) = 0; w(0) = 0");
    const auto manifold = at.to(25);
    const auto tails = manifold.tails();
    REQUIRE(tails);
    const auto point = manifold.at({theta_of(rational(1, 3))});
    const magnitude power = pow(magnitude(from_rational<ball>(rational(1, 3))), 26);
    const ball x = widened(point.value[0].value.re, (*tails)[0] * power);
    const ball w = widened(point.value[1].value.re, (*tails)[1] * power);
    CHECK(overlaps(w, x * x));
    CHECK(magnitude::radius_of(w).above() < 1e-10);
    const ball theta = from_rational<ball>(rational(1, 3));
    CHECK(contains(x, theta / (ball(1) + theta / 4)));
    // dP/dtheta of x.
    const ball slope = ball(1) / pow(ball(1) + theta / 4, ball(2));
    CHECK(magnitude(point.by_theta[0][0].value.re - slope).above() < 1e-9);
}

// A pair of conjugate eigenvalues -1 +- 2 i, and a graph u = x^2 + y^2 beside it.
TEST_CASE("a complex pair gives a real manifold", "[ode][proved]") {
    const precision_scope scope(40);
    const manifold_at_zero at("x' = -x - 2*y; y' = 2*x - y; u' = 3*u - 5*(x^2 + y^2); x(0) = 0; y(0) = 0; u(0) = 0",
                              -2);
    REQUIRE(at.plan.size() == 2);
    REQUIRE(at.plan.begins_pair(0));
    const auto manifold = at.to(5);
    REQUIRE(manifold.tails());
    const complex_ball theta{from_rational<ball>(rational(1, 3)), from_rational<ball>(rational(1, 4))};
    const auto point = manifold.at({theta, conjugate(theta)});
    for (const complex_jet& each : point.value) {
        CHECK(contains_zero(each.value.im));
    }
    const ball& x = point.value[0].value.re;
    const ball& y = point.value[1].value.re;
    CHECK(overlaps(point.value[2].value.re, x * x + y * y));
}

// A Jordan block, nearly equal rates and equal ones beside the graph u = x y + y^3.
TEST_CASE("multiple and nearly equal eigenvalues share a block", "[ode][proved]") {
    const precision_scope scope(40);
    for (const std::string rows : {"-x + y|-y", "-x|-y", "-x + y|-(1001/1000)*y", "-x + y/100|-y - x/100000",
                                   "-x + y|-y - x/100000", "-(1001/1000)*x|-y"}) {
        const std::string x = rows.substr(0, rows.find('|'));
        const std::string y = rows.substr(rows.find('|') + 1);
        const manifold_at_zero at("x' = " + x + "; y' = " + y + "; u' = 3*(u - x*y - y^3) + (" + x +
                                      ")*y + (x + 3*y^2)*(" + y + "); x(0) = 0; y(0) = 0; u(0) = 0",
                                  -2);
        REQUIRE(at.plan.size() == 2);
        REQUIRE(at.plan.blocks.size() == 1);
        INFO(rows);
        const auto manifold = at.to(7);
        const auto tails = manifold.tails();
        REQUIRE(tails);
        const auto point = manifold.at({theta_of(rational(1, 3)), theta_of(rational(-1, 5))});
        const ball& first = point.value[0].value.re;
        const ball& second = point.value[1].value.re;
        CHECK(overlaps(point.value[2].value.re, first * second + second * second * second));
        CHECK(magnitude::radius_of(point.value[2].value.re).above() < 1e-30);
        CHECK((*tails)[2].above() < 1e-30);
    }
}

// Two equal pairs -1 +- 2 i, of which one drives the other.
TEST_CASE("a double pair of complex eigenvalues gives a real manifold", "[ode][proved]") {
    const precision_scope scope(40);
    const manifold_at_zero at(
        "x' = -x - 2*y + v; y' = 2*x - y; v' = -v - 2*w; w' = 2*v - w; u' = 3*u - 5*(v^2 + w^2); x(0) = 0; y(0) = 0; "
        "v(0) = 0; "
        "w(0) = 0; u(0) = 0",
        -2);
    REQUIRE(at.plan.size() == 4);
    REQUIRE(at.plan.blocks.size() == 1);
    REQUIRE(at.plan.begins_pair(2));
    const auto manifold = at.to(4);
    REQUIRE(manifold.tails());
    const complex_ball first{from_rational<ball>(rational(1, 3)), from_rational<ball>(rational(1, 4))};
    const complex_ball second{from_rational<ball>(rational(-1, 7)), from_rational<ball>(rational(1, 2))};
    const auto point = manifold.at({first, conjugate(first), second, conjugate(second)});
    for (const complex_jet& each : point.value) {
        CHECK(contains_zero(each.value.im));
    }
    const ball& v = point.value[2].value.re;
    const ball& w = point.value[3].value.re;
    CHECK(overlaps(point.value[4].value.re, v * v + w * w));
}

// The hypothesis eta < alpha of theorem W: with a Jordan block whose entry is larger than the rate the motion in theta may grow first.
TEST_CASE("no tail is proved for a block with large entries", "[ode][proved]") {
    const precision_scope scope(40);
    manifold_at_zero at("x' = -x + y; y' = -y; u' = u - x^2*y; x(0) = 0; y(0) = 0; u(0) = 0", -2);
    REQUIRE(at.plan.blocks.size() == 1);
    CHECK(at.to(12).tails());
    at.plan.blocks[0].mixture = {{{0.5, 0}, {0, 0}}, {{0, 0}, {0.5, 0}}};  // the entry 1 again
    CHECK_FALSE(at.to(12).tails());
}

// Outside of a domain of convergence no tail is proved: the columns are too long.
TEST_CASE("no tail is proved where the series does not converge", "[ode][proved]") {
    const precision_scope scope(40);
    const manifold_at_zero at("y'' = y - y^3; y(0) = 0; y'(0) = 0", 4);
    CHECK_FALSE(at.to(20).tails());
}

}  // namespace manifold_invariant_manifold_test
