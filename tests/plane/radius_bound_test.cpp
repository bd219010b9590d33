// Loops and coverings compared with closed forms, and what must not be proved: a loop that misses the singularity, a
// disc that is too large, a covering with a hole.
#include "libration/plane/radius_bound.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/closed_form/constant_solution.hpp"
#include "libration/pendulum/singularities.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "pendulum/typed.hpp"
#include "proved.hpp"

namespace plane_radius_bound_test {

using namespace libration;
using namespace libration::ode;

namespace {

explicit_system typed(const std::string& text) { return explicit_system(parse(text)); }

ball tenth_to(int n) { return pow(ball(10), -n); }

ball exact_near(const ball& x) { return exact_midpoint(x); }

// Whether every point of a fan of |z| < rho lies in a disc whose centre is no farther from 0, or in the first one.
bool covers(const std::vector<covering_disc>& discs, double rho, double angle) {
    for (int i = 1; i <= 120; ++i) {
        for (int j = 0; j <= 120; ++j) {
            // More points towards the rim.
            const double r = rho * (1 - std::pow(1 - i / 120.0, 3));
            const auto z = std::polar(r, angle * j / 120);
            bool held = false;
            for (const covering_disc& each : discs) {
                held = held || (std::abs(z - each.centre) < each.radius && std::abs(each.centre) <= std::abs(z));
            }
            if (!held) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

// The residue of 1/(7/3 - t) is -1.
TEST_CASE("a loop round a simple pole, and one that misses it", "[ode][proved][singularity]") {
    const precision_scope scope(50);
    const complex_flow flow(typed("y' = y^2; y(0) = 3/7"), 150);
    const complex_ball pole(exact_near(ball(7) / 3));
    const auto loop = loop_about(flow, {}, pole, magnitude::of(1, -20), 0, {0});
    CHECK(loop.evidence == loop_evidence::integral);
    CHECK(overlaps(loop.value.im, ball(-2) * pi<ball>()));
    CHECK(contains_zero(loop.value.re));
    CHECK(certainly_less(loop.farthest, ball(7) / 3 + pow(ball(2), -19)));
    const complex_ball beside = pole - complex_ball(pow(ball(2), -17));
    CHECK(loop_about(flow, {}, beside, magnitude::of(1, -20), 2, {0}).evidence == loop_evidence::none);
}

// Double poles have neither residue nor change: the first weight detects them, with 2 pi i/d.
TEST_CASE("loops round double poles and branch points", "[ode][proved][singularity]") {
    const precision_scope scope(50);
    const complex_flow wp(typed("u'' = 6*u^2; u(0) = 1; u'(0) = 2"), 150);  // u = 1/(1 - t)^2
    const auto plain = loop_about(wp, {}, complex_ball(1), magnitude::of(1, -10), 0, {0});
    CHECK(plain.evidence == loop_evidence::none);
    const auto weighted = loop_about(wp, {}, complex_ball(1), magnitude::of(1, -10), 1, {0});
    CHECK(weighted.evidence == loop_evidence::integral);
    CHECK(weighted.power == 1);
    CHECK(overlaps(weighted.value.im, pi<ball>() * 2048));
    // y = sqrt(1 - t): the sum of both roots is 0, so that the change is 2 y.
    const complex_flow root(typed("y' = -1/(2*y); y(0) = 1"), 150);
    CHECK(loop_about(root, {}, complex_ball(1), magnitude::of(1, -10), 0, {0}).evidence != loop_evidence::none);
}

TEST_CASE("coverings end below the radius and are refused beyond it", "[ode][proved][singularity]") {
    const precision_scope scope(40);
    const complex_flow flow(typed("y' = 1 + y^2; y(0) = 0"), 120);
    const ball quarter = pi<ball>() / 2;
    const ball below = exact_near(quarter * (ball(1) - tenth_to(6)));
    covering_limits limits;
    limits.finest_bits = 26;
    const covering found = covered_disc(flow, below, {2}, limits);
    CHECK(found.complete);
    CHECK(covers(found.discs, 1.5707, std::numbers::pi / 2));
    // Without any single disc there is a hole.
    const covering near = covered_disc(flow, exact_near(quarter * 99 / 100), {2}, {});
    CHECK(near.complete);
    CHECK(covers(near.discs, 1.555, std::numbers::pi / 2));
    bool holed = false;
    for (std::size_t i = 1; i < near.discs.size(); ++i) {
        auto fewer = near.discs;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        holed = holed || !covers(fewer, 1.555, std::numbers::pi / 2);
    }
    CHECK(holed);
    // Beyond the radius, slightly and far.
    CHECK_FALSE(covered_disc(flow, exact_near(quarter * (ball(1) + tenth_to(6))), {2}, limits).complete);
    CHECK_FALSE(covered_disc(flow, exact_near(quarter * 2), {2}, limits).complete);
    CHECK_FALSE(covered_disc(flow, exact_near(quarter * (ball(1) + tenth_to(3))), {1}, limits).complete);
}

// Radii in closed form: 1/y(0), pi/2, sqrt(pi/6) Gamma(5/6)/Gamma(4/3) [PROBLEMS], and Blasius' of tests/reference.
TEST_CASE("proved radii hold closed forms", "[ode][proved][singularity]") {
    const auto holds = [](const std::string& text, const ball& radius, long digits) {
        const proved_radius found = prove_radius(typed(text), digits);
        const bool between = !certainly_less(radius, found.lower) && !certainly_less(found.upper, radius);
        return between && certainly_less(found.upper - found.lower, found.lower * tenth_to(static_cast<int>(digits)));
    };
    const precision_scope scope(60);
    CHECK(holds("y' = y^2; y(0) = 3/7", ball(7) / 3, 20));
    CHECK(holds("y' = 1 + y^2; y(0) = 0", pi<ball>() / 2, 32));  // beyond the least bits of a centre
    const auto gamma = [](const ball& x) {
        ball result;
        arb_gamma(result.handle(), x.handle(), ball::working_bits());
        return result;
    };
    const ball collapse = sqrt(pi<ball>() / 6) * gamma(ball(5) / 6) / gamma(ball(4) / 3);
    CHECK(holds(std::string(problem_text("rayleigh")), collapse, 8));
    CHECK(holds("y' = exp(y); y(0) = 0", ball(1), 10));    // -log(1 - t)
    CHECK(holds("y' = -1/(2*y); y(1) = 2", ball(4), 10));  // sqrt(5 - t) about 1
    CHECK(prove_radius(typed("y'' = -cos(t)*y + exp(t); y(0) = 1; y'(0) = 0"), 10).infinite);
}

// The lattice of the pendulum is known: top, bottom, and in between.
TEST_CASE("the general way proves the pendulum's radius", "[ode][proved][singularity]") {
    const precision_scope scope(50);
    const auto radius_of_motion = [](const pendulum::motion& m) {
        const auto lattice = pendulum::singularities<ball>(m);
        return lattice->radius(pendulum::phase_map<ball>(m).at(read_exact("0")));
    };
    const struct {
        const char* theta0;
        const char* omega0;
    } motions[] = {{"2", "0"}, {"1/2", "9/4"}};
    for (const auto& each : motions) {
        const auto found = prove_radius(
            typed("theta'' = -sin(theta); theta(0) = " + std::string(each.theta0) + "; theta'(0) = " + each.omega0),
            10);
        const ball exact = radius_of_motion(tests::with_state(each.theta0, each.omega0));
        CHECK_FALSE(certainly_less(exact, found.lower));
        CHECK_FALSE(certainly_less(found.upper, exact));
    }
}

// f ~ 6/(t - p) with exponents -1/2 +- i sqrt(23)/2 beside it: poles of other sheets spiral towards p, and a loop of
// the size of eight digits shows nothing. p by a Runge-Kutta method along the ray, from f = 6/(t - p) to within |t -
// p|^(3/2).
TEST_CASE("a pole with complex exponents is shown by a smaller loop", "[ode][proved][singularity]") {
    auto equations = changed(parse(std::string(problem_text("falkner_skan"))), "b = 1");
    equations = changed(equations, "s = 1.232587656820281");
    const proved_radius found = prove_radius(explicit_system(equations), 8);
    const precision_scope scope(30);
    CHECK(certainly_less(found.upper - found.lower, found.lower * tenth_to(8)));

    using plane = std::complex<double>;
    using state = std::array<plane, 3>;
    const plane end{found.nearest->offset.re.convert_to<double>(), found.nearest->offset.im.convert_to<double>()};
    const plane direction = end / std::abs(end);
    const auto slope = [](const state& f) { return state{f[1], f[2], -f[0] * f[2] - (1.0 - f[1] * f[1])}; };
    const auto moved = [](const state& f, const state& by, const plane& h) {
        return state{f[0] + h * by[0], f[1] + h * by[1], f[2] + h * by[2]};
    };
    state f{0, 0, 1.232587656820281};
    double t = 0;
    while (std::abs(end) - t > 1e-6) {
        const double step = 0.005 * (std::abs(end) - t);
        const plane h = step * direction;
        const state a = slope(f);
        const state b = slope(moved(f, a, h / 2.0));
        const state c = slope(moved(f, b, h / 2.0));
        const state d = slope(moved(f, c, h));
        for (std::size_t k = 0; k < 3; ++k) {
            f[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
        }
        t += step;
    }
    const double radius = std::abs(t * direction - 6.0 / f[0]);
    // Steps twice as long change it by 5e-9, and its error falls with their fourth power; the bounds are 2e-8 apart.
    CHECK(midpoint_of(found.lower).convert_to<double>() < radius + 5e-9);
    CHECK(radius < midpoint_of(found.upper).convert_to<double>() + 5e-9);
}

// y = (1 + t^2/3)^(-1/2): R = sqrt(3), from a singular initial point. A covering of more is rejected.
TEST_CASE("the radius about a singular start", "[ode][proved][singularity]") {
    const auto star = [](const std::string& n) {
        return explicit_system(changed(parse(std::string(problem_text("lane_emden"))), "n = " + n));
    };
    const precision_scope scope(60);
    const proved_radius plummer = prove_radius(star("5"), 25);
    const ball exact = sqrt(ball(3));
    CHECK(certainly_less(plummer.lower, exact));
    CHECK(certainly_less(exact, plummer.upper));
    CHECK(certainly_less(plummer.upper - plummer.lower, exact * tenth_to(25)));
    CHECK(plummer.rotation == 2);
    CHECK(covers(plummer.cover.discs, std::sqrt(3.0) * (1 - 1e-12), std::numbers::pi / 2));
    const complex_flow flow(star("5"), 120);
    const covering more = covered_disc(flow, exact_near(exact * (ball(1) + tenth_to(6))), {2}, {.finest_bits = 24});
    CHECK_FALSE(more.complete);
    // sin(t)/t is entire: there is no upper bound.
    CHECK_THROWS_AS(prove_radius(star("1"), 10), error);
    CHECK_THROWS_AS(prove_radius(explicit_system(parse(std::string(problem_text("thomas_fermi")))), 10), error);
}

// 1/(7/3 - t), the tangent, 1/(1 - t)^2, and Painleve's second equation at a complex pole; not a nearby point, nor a
// branch point.
TEST_CASE("poles are zeros in regular coordinates", "[ode][proved][singularity]") {
    const precision_scope scope(60);
    const auto is_pole = [](const std::string& text, const complex_ball& offset, int exponent) {
        return is_pole_near(typed(text), {}, exact_midpoint(offset), magnitude(tenth_to(exponent)), 160);
    };
    const complex_ball third(ball(7) / 3);
    CHECK(is_pole("y' = y^2; y(0) = 3/7", third, 30));
    CHECK_FALSE(is_pole("y' = y^2; y(0) = 3/7", third + complex_ball(tenth_to(20)), 30));
    CHECK(is_pole("y' = 1 + y^2; y(0) = 0", complex_ball(pi<ball>() / 2), 30));
    CHECK(is_pole("u'' = 6*u^2; u(0) = 1; u'(0) = 2", complex_ball(1), 30));
    CHECK_FALSE(is_pole("u'' = 6*u^2; u(0) = 1; u'(0) = 2", complex_ball(ball(1) + tenth_to(25)), 30));
    CHECK_FALSE(is_pole("y' = -1/(2*y); y(0) = 1", complex_ball(1), 20));
    // y = (sqrt(3) tan(sqrt(3) t/2 + pi/6) - 1)/2 is 0 at 0, half way from minus its pole to it: 1/y has no value
    // there.
    const complex_ball pole = exact_midpoint(complex_ball(pi<ball>() * 2 / (sqrt(ball(3)) * 3)));
    const explicit_system shifted = typed("y' = 1 + y + y^2; y(0) = 0");
    CHECK(is_pole_near(shifted, {}, pole, magnitude(tenth_to(30)), 160));
    CHECK_FALSE(is_pole_near(shifted, {complex_ball(0) - pole}, pole, magnitude(tenth_to(30)), 160));
    // From -2.3, next to the pole before, the zero lies behind half of the way.
    CHECK_FALSE(
        is_pole_near(shifted, {exact_midpoint(complex_ball(ball(-23) / 10))}, pole, magnitude(tenth_to(9)), 64));
    for (const std::string name : {"weierstrass", "painleve_1", "painleve_2", "duffing", "riccati", "logistic"}) {
        INFO(name);
        const explicit_system system(parse(std::string(problem_text(name))));
        singularity_request request;
        request.nearest_alone = true;
        request.digits = 24;
        const auto map = singularities_of(system, request);
        REQUIRE_FALSE(map.all.empty());
        const auto& found = map.all.front();
        const auto proved = prove_singularity(system, found, mpfr("1e-18"));
        CHECK(proved.pole_order == (name == "weierstrass" || name == "painleve_1" ? 2 : 1));
    }
}

// The tangent from the initial point -1: poles at 3 pi/4 and -pi/4, which are not symmetric to each other.
TEST_CASE("all singularities of a map are proved, mirror images once", "[ode][proved][singularity]") {
    const precision_scope scope(40);
    const explicit_system system = typed("y' = 1 + y^2; y(0) = -1");
    singularity_request request;
    request.within = 3;
    request.digits = 20;
    const auto map = singularities_of(system, request);
    long calls = 0;
    const auto proved = prove_singularities(system, map.all, 12, [&] { ++calls; });
    REQUIRE(proved.size() == 2);
    CHECK(calls == 2);
    const ball quarter = pi<ball>() / 4;
    for (const auto& each : proved) {
        CHECK(each.pole_order == 1);
        const ball at(each.centre.re);
        const ball away = std::min(magnitude(at - quarter * 3), magnitude(at + quarter)).exact();
        CHECK(certainly_less(away, tenth_to(12)));
    }
    // 1/(1 + c exp(-t)): poles 2 pi i apart, and the points symmetric to them, which are proved by them.
    const explicit_system growth(parse(std::string(problem_text("logistic"))));
    const auto column = singularities_of(growth, {.within = 10, .digits = 20});
    REQUIRE(column.all.size() == 4);
    const auto poles = prove_singularities(growth, column.all, 12);
    CHECK(poles.size() == 4);
    CHECK(std::ranges::all_of(poles, [](const auto& each) { return each.pole_order == 1; }));
    // Of a different kind than in the search: the position alone. No position: nothing.
    auto doubted = map.all.front();
    doubted.kind = singularity_kind::branch_pole;
    CHECK(prove_singularity(system, doubted, mpfr("1e-10")).pole_order == 0);
    doubted.offset.re += 1;
    CHECK_THROWS_WITH(prove_singularity(system, doubted, mpfr("1e-3")), Catch::Contains("no change or integral"));
}

// y' = (1/(1 - t/25) - (1 - t/25))/2: the reciprocal of a function that vanishes at 25, next to a root of it.
TEST_CASE("the radius of a linear pursuit is that of its closed form", "[ode][proved][singularity]") {
    const explicit_system pursuit(parse(std::string(problem_text("detest_e5"))));
    const precision_scope scope(40);
    const auto bounds = outward_decimals(prove_radius(pursuit, 1), 1);
    CHECK(mpfr(bounds.lower) <= 25);
    CHECK(25 <= mpfr(bounds.upper));
}

TEST_CASE("bounds that no covering reaches are told", "[ode][proved][singularity]") {
    const explicit_system stiff(parse(std::string(problem_text("stiff_d6"))));
    CHECK_THROWS_WITH(prove_radius(stiff, 4), Catch::Contains("both proved; more is not"));
    const precision_scope scope(40);
    const auto entire = outward_decimals(prove_radius(typed("y' = y; y(0) = 1"), 5), 5);
    CHECK(entire.lower == "inf");
    const auto bounds = outward_decimals(prove_radius(typed("y' = y^2; y(0) = 3/7"), 10), 10);
    CHECK(mpfr(bounds.lower) <= mpfr(7) / 3);
    CHECK(mpfr(7) / 3 <= mpfr(bounds.upper));
    CHECK(mpfr(bounds.upper) - mpfr(bounds.lower) < mpfr("1e-9"));
    // More digits than are proved: still rounded outwards.
    const auto fine = outward_decimals(prove_radius(typed("y' = y^2; y(0) = 3/7"), 4), 12);
    CHECK(mpfr(fine.lower) <= mpfr(7) / 3);
    CHECK(mpfr(7) / 3 <= mpfr(fine.upper));
}

TEST_CASE("a constant solution has an infinite radius", "[ode][proved][singularity]") {
    for (const char* text : {"x'' = -sin(x); x(0) = 0; x'(0) = 0", "x'' = -sin(x); x(0) = pi; x'(0) = 0",
                             "x' = y^2 - 1; y' = t*x; x(0) = 0; y(0) = 1"}) {
        CAPTURE(text);
        const proved_radius radius = prove_radius(typed(text), 5);
        CHECK((radius.infinite && radius.constant));
    }
    CHECK(constancy_of(typed("x'' = -sin(x); x(0) = 0; x'(0) = 1")) == constancy::none);
    CHECK(constancy_of(typed("y' = t*y^2; y(0) = 1")) == constancy::none);
    CHECK(constancy_of(typed("y' = y^2; y(0) = 1e-300")) == constancy::none);
}

// The watch hears of points and discs; one that ends the covering leaves the upper bound.
TEST_CASE("a proof of a radius that is ended keeps its upper bound", "[ode][proved][singularity]") {
    long points = 0;
    long discs = 0;
    proof_route route;
    route.watch = [&](plane_step step) { ++(step == plane_step::point ? points : discs); };
    const auto tangent = typed("x' = 1 + x^2; x(0) = 0");
    const proved_radius whole = prove_radius(tangent, 8, route);
    CHECK(points > 0);
    CHECK(discs > static_cast<long>(whole.cover.discs.size()));
    long left = discs - 3;
    route.watch = [&](plane_step step) {
        if (step == plane_step::disc && --left == 0) {
            throw error(error_kind::undecided, "the time", "", "is up");
        }
    };
    CHECK_THROWS_WITH(prove_radius(tangent, 8, route),
                      Catch::Contains("a radius of at most 1.5707963") && Catch::Contains("is not: the time is up"));
}

}  // namespace plane_radius_bound_test
