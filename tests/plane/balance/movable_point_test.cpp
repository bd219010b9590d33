// Expansions at movable singularities compared with closed forms.
#include "libration/plane/balance/movable_point.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"

namespace plane_balance_movable_point_test {

using namespace libration;
using namespace libration::ode;

namespace {

movable_point point_of(const std::string& text, std::size_t shown, std::complex<double> near) {
    const explicit_system system{parse(text)};
    const chart_atlas atlas(system, 1.6, shown);
    return movable_point_near(system, atlas, shown, exact_point(near));
}

std::string reason_of(const std::string& text, std::complex<double> near) {
    try {
        point_of(text, 0, near);
    } catch (const error& problem) {
        CHECK(problem.kind() == error_kind::undecided);
        return problem.reason();
    }
    return "";
}

bool has(const complex_ball& z, const ball& re) {
    const bool narrow = certainly_less(radius_of(z.re), pow(ball(10), -30L));
    return overlaps(z.re, re) && contains_zero(z.im) && narrow;
}

}  // namespace

// x = -u'/u, u = 1 - t - t^2/2: the pole sqrt 3 - 1 with the residue -1, x = 1/(t* x) + ..
TEST_CASE("the pole of two coupled Riccati equations", "[plane][proved]") {
    const precision_scope scope(40);
    const movable_point at = point_of("x' = x^2 + y; y' = x*y; x(0) = 1; y(0) = 1", 0, {0.7320508075688773, 0});
    const ball place = sqrt(ball(3)) - 1;
    CHECK(at.real);
    CHECK(has(at.place, place));
    CHECK(at.single_valued);
    CHECK(*at.terms[0].exact == -1);
    CHECK(has(at.terms[0].by_logarithm[0], ball(ball(1) / place)));
    // -1/(t - t_2) at t*, t_2 = -1 - sqrt 3
    CHECK(*at.terms[1].exact == 0);
    CHECK(has(at.terms[1].by_logarithm[0], ball(ball(-1) / (sqrt(ball(3)) * 2))));
}

// y = (1 - 2 t)^(-1/2), whose scale is free at the singularity.
TEST_CASE("a branch point with a free leading coefficient", "[plane][proved]") {
    const precision_scope scope(40);
    const movable_point at = point_of("y' = y*w; w' = 2*w^2; y(0) = 3; w(0) = 1", 0, {0.5, 0});
    CHECK(has(at.place, ball(1) / 2));
    CHECK(*at.terms[0].exact == rational(-1, 2));
    CHECK(has(at.terms[0].by_logarithm[0], ball(3)));
    CHECK_FALSE(at.single_valued);
    CHECK(at.without_logarithms);
    const ball x = ball(1) / 7;
    CHECK(certainly_less(ball(ball(3) / sqrt(x) * ball(rational(999, 1000) == 0 ? 1 : 1)),
                         ball(at.bound_over(x).exact() * 2)));
    CHECK_FALSE(certainly_less(at.bound_over(x).exact(), ball(ball(3) / sqrt(x))));
    CHECK_FALSE(at.bound_over(ball(1)).is_finite());
}

// x'' = 2 x^3 + c x' has the resonance 4, compatible only without damping, or with c^2 = -9 b/2, b the coefficient of x.
TEST_CASE("logarithms are decided by exact arithmetic", "[plane][proved]") {
    const precision_scope scope(30);
    // K(1/sqrt 2)/sqrt 2
    CHECK(point_of("x' = z; z' = 2*x^3; x(0) = 1; z(0) = 0", 0, {1.311028777146059905, 0}).single_valued);
    const movable_point damped =
        point_of("x'' = -x'/5 - x - x^3; x(0) = 1; x'(0) = 0", 0, {-0.03313079179087377, 1.524389600812954});
    CHECK_FALSE(damped.without_logarithms);
    bool proved = false;
    for (const movable_term& each : damped.terms) {
        if (each.by_logarithm.size() > 1 && *each.exact == 3) {
            proved = !contains_zero(each.by_logarithm[1].re) || !contains_zero(each.by_logarithm[1].im);
        }
    }
    CHECK(proved);
    CHECK(*damped.terms[0].exact == -1);
}

TEST_CASE("what is not a balance of powers is rejected with its reason", "[plane]") {
    const precision_scope scope(30);
    // y ~ (t* - t)^(-1/sqrt 2)
    CHECK(reason_of("x' = sqrt(2)*x^2; y' = x*y; x(0) = 1; y(0) = 1", {1 / std::sqrt(2.0), 0})
              .find("does not behave like a power") != std::string::npos);
    // x = -log(1 - t)
    CHECK(reason_of("x' = y; y' = y^2; x(0) = 0; y(0) = 1", {1, 0}) != "");
}

}  // namespace plane_balance_movable_point_test
