// The claims of the abstract and of sections I and II, judged once more. Numbers without another source are by mpmath
// 1.3 (mp.dps = 30), by the command in the comment beside them.
#include <catch2/catch.hpp>
#include <string>

#include "libration/elliptic/incomplete_integral.hpp"
#include "libration/pendulum/critical_formula.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/pendulum/separatrix_sum.hpp"
#include "libration/pendulum/singularities.hpp"
#include "paper/verdicts.hpp"
#include "pendulum/typed.hpp"

namespace paper_background_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

mpfr theta_of(const motion& m, const std::string& time) { return exact_solution<mpfr>(m)(read_exact(time)).theta; }

}  // namespace

// |a_n| (3 T*/2)^n with a_n R^n = 8/n at n = 202 and R = sqrt 2 T*: 8/mpf(202)*(mpf(9)/8)**101.
TEST_CASE("claim one_series_for_all_time: corrected, the series stops at R < T and symmetry does the rest",
          "[paper][claims]") {
    check_number("one_series_for_all_time", verdict::corrected, "5809.56");
    const precision_scope precision(50);
    const motion m = with_energy("1");
    const mpfr radius = singularities<mpfr>(m)->radius(phase_map<mpfr>::at_quarter(1));
    CHECK(radius < effective_period(energy_level_of<mpfr>(m)) * 3 / 2);  // 3T/8 is beyond it
}

TEST_CASE("claim abstract_uniform_acceleration: holds in the norm, next to the top the resummation is worse",
          "[paper][claims]") {
    check_claim("abstract_uniform_acceleration", verdict::corrected, "2.6", "2.8");
    const precision_scope precision(50);
    const auto arc = arc_of<mpfr>(with_energy("1.71"));
    const exact_solution<mpfr> truth(with_energy("1.71"));
    const mpfr x = mpfr(1) / 10;
    const mpfr theta = truth.from_top(x).theta;
    CHECK(abs(resummation_from_top(arc, 10)(x).value - theta) > abs(series_from_top(arc, 10)(x).value - theta) * 2);
    // It pays where the series is worst.
    const mpfr late = truth.from_top(mpfr(9) / 10).theta;
    CHECK(abs(resummation_from_top(arc, 10)(mpfr(9) / 10).value - late) * 10 <
          abs(series_from_top(arc, 10)(mpfr(9) / 10).value - late));
}

// Differences of step h leave theta'''' h^2/12: with |theta''''| below (g/l)^2 = 1540 that is 1.3e-22.
TEST_CASE("claim dimensionless_equation: holds, scaled time solves the equation with g/l", "[paper][claims]") {
    check_claim("dimensionless_equation", verdict::holds, "0", "1.3e-22");
}

TEST_CASE("claim energy_conservation: holds, to the last digits of the integration", "[paper][claims]") {
    check_identity("energy_conservation");
    const precision_scope precision(50);
    const auto state = state_of<mpfr>(with_energy("1.71"), "7.3");
    CHECK(abs(state.omega * state.omega / 2 + 1 - cos(state.theta) - mpfr("1.71")) < mpfr("1e-47"));
}

// 1 - cos theta >= 2 (theta/pi)^2 for |theta| <= pi, with equality at pi: Jordan's inequality.
TEST_CASE("claim energy_is_not_negative: holds, E is at least a positive quadratic form", "[paper][claims]") {
    check_claim("energy_is_not_negative", verdict::holds, "0.999999999999", "1.000000000001");
    CHECK(with_state("0", "0").regime() == regime::stable_equilibrium);
    CHECK(with_state("0", "1e-30").regime() == regime::libration);
}

TEST_CASE("claim all_motions_pass_the_bottom: holds, each state lies on a motion from the bottom", "[paper][claims]") {
    check_identity("all_motions_pass_the_bottom");
}

TEST_CASE("claim reflection_of_direction: holds, -omega0 reflects the motion", "[paper][claims]") {
    check_claim("reflection_of_direction", verdict::holds, "0", "1e-45");
    const precision_scope precision(50);
    CHECK(abs(theta_of(with_state("0", "-3"), "5") + theta_of(with_state("0", "3"), "5")) < mpfr("1e-46"));
}

// The first correction of the harmonic motion is of the third order in the amplitude.
TEST_CASE("claim harmonic_limit: holds, the difference is of the third order", "[paper][claims]") {
    check_claim("harmonic_limit", verdict::holds, "2.999", "3.001");
}

TEST_CASE("claim uniform_rotation_limit: corrected, theta0 is missing", "[paper][claims]") {
    check_claim("uniform_rotation_limit", verdict::corrected, "0.99", "1.01");
    const precision_scope precision(50);
    const mpfr theta = theta_of(with_state("1", "1000"), "1/2");
    CHECK(abs(theta - 500) > mpfr("0.99"));
    CHECK(abs(theta - 501) < mpfr("0.001"));
}

TEST_CASE("claim turning_points: holds, arccos(1-E) at rest and 2E-4 at the top", "[paper][claims]") {
    check_identity("turning_points");
}

// pi - theta = 2 arctan(1/sinh t) = 4 e^-t + O(e^-3t).
TEST_CASE("claim separatrix_never_arrives: holds, the rest of the way falls like 4 e^-t", "[paper][claims]") {
    check_number("separatrix_never_arrives", verdict::holds, "4.00000000000");
    const precision_scope precision(80);
    CHECK(theta_of(with_energy("2"), "40") < pi<mpfr>());
    CHECK(theta_of(with_energy("2"), "100") > theta_of(with_energy("2"), "40"));
}

TEST_CASE("claim unwound_period: holds with both signs in both directions", "[paper][claims]") {
    check_identity("unwound_period");
    const precision_scope precision(50);
    const motion clockwise = with_energy("2.02", -1);
    CHECK(abs(theta_of(clockwise, "T") - (theta_of(clockwise, "0") - pi<mpfr>() * 2)) < mpfr("1e-47"));
}

TEST_CASE("claim infinite_period: holds, T* grows like log(32/|2-E|)/2 from both sides", "[paper][claims]") {
    check_claim("infinite_period", verdict::holds, "0.99999999", "1.00000001");
}

// ellipk(mpf('0.855')), sqrt(mpf(2)/mpf('2.02'))*ellipk(mpf(2)/mpf('2.02'))
TEST_CASE("claim period_formula: holds, the equation takes the time that (T) says", "[paper][claims]") {
    check_identity("period_formula");
    const precision_scope precision(50);
    CHECK_THAT(effective_period(energy_level_of<mpfr>(with_energy("1.71"))),
               near<mpfr>(decimal("2.404685550102052437"), 0));
    CHECK_THAT(effective_period(energy_level_of<mpfr>(with_energy("2.02"))),
               near<mpfr>(decimal("3.6821924860914103292"), 0));
}

TEST_CASE("claim period_substitutions: holds, four ways to the quarter agree", "[paper][claims]") {
    check_identity("period_substitutions");
}

TEST_CASE("claim effective_period_suffices: holds, reflections about top and bottom", "[paper][claims]") {
    check_identity("effective_period_suffices");
    const precision_scope precision(50);
    const motion m = with_energy("8");
    CHECK(abs(theta_of(m, "3T/4") - (pi<mpfr>() * 4 - theta_of(m, "T/4"))) < mpfr("1e-47"));
}

// F = lambda p: ellipf(p, 2/mpf('2.02')); (F(3*pi/4)-F(pi/4))/(F(5*pi/4)-F(3*pi/4))
TEST_CASE("claim rotation_halves: corrected, only from the bottom or the top", "[paper][claims]") {
    check_number("rotation_halves", verdict::corrected, "3.20489103906898802");
    const precision_scope precision(50);
    // The clock of the motion says the same: from pi/2 on, 3 pi/2 comes after more than half a period.
    CHECK(theta_of(motion::of_energy_from(fraction("2.02"), read_exact("pi/2")), "T/2") < pi<mpfr>() * 3 / 2);
    CHECK(abs(theta_of(motion::of_energy_from(fraction("2.02"), read_exact("pi")), "T/2") - pi<mpfr>() * 2) <
          mpfr("1e-47"));
}

// 2*(4*atan(e)-pi)
TEST_CASE("claim separatrix_formula: corrected, (critical) is the counterclockwise motion in |theta0| < pi",
          "[paper][claims]") {
    check_number("separatrix_formula", verdict::corrected, "3.46307793295863449");
    const precision_scope precision(50);
    const motion clockwise = with_energy("2", -1);
    const mpfr printed = atan(exp(mpfr(1)) * tan(pi<mpfr>() / 4)) * 4 - pi<mpfr>();
    CHECK(theta_of(clockwise, "1") < 0);
    CHECK(abs(theta_of(clockwise, "1") + printed) < mpfr("1e-47"));
    CHECK(abs(critical_formula(clockwise, mpfr(1)) + printed) < mpfr("1e-47"));
}

TEST_CASE("claim half_angle_substitution: holds, y = sin(theta/2) obeys an elliptic equation", "[paper][claims]") {
    check_identity("half_angle_substitution");
}

// k = mpf(1)/2; 4*asin(k*ellipfun('cd', 1, k=k))
TEST_CASE("claim libration_formula: corrected, for theta0 > 0", "[paper][claims]") {
    check_number("libration_formula", verdict::corrected, "1.26872301345500560");
    const precision_scope precision(50);
    CHECK_THAT(theta_of(with_state("-60deg", "0"), "1"), near<mpfr>(decimal("-0.634361506727502803"), 0));
}

TEST_CASE("claim rotation_formula: corrected, the arcsine folds the angle beyond T*", "[paper][claims]") {
    check_number("rotation_formula", verdict::corrected, "6.28318530717958648");
    const precision_scope precision(50);
    const motion m = motion::of_energy_from(4, exact{});
    CHECK(abs(separatrix_sum<mpfr>(m)(read_exact("T")).value - pi<mpfr>() * 2) < mpfr("1e-47"));
}

// 1 - ellipfun('cd', 1, k=mpf(1)/2)
TEST_CASE("claim cd_initial_value_problem: holds, cd satisfies it", "[paper][claims]") {
    check_identity("cd_initial_value_problem");
    const precision_scope precision(50);
    const auto v = jacobi(mpfr(1), modulus<mpfr>::from_modulus(mpfr(1) / 2));
    const mpfr cd = v.cn / v.dn;
    const mpfr slope = -v.sn * mpfr(3) / 4 / (v.dn * v.dn);  // cd' = -k'^2 sd nd
    CHECK(abs(slope * slope - (1 - cd * cd) * (1 - cd * cd / 4)) < mpfr("1e-47"));
}

// 2*ellipfun('sn', 1, k=mpf(2)/3)
TEST_CASE("claim sn_initial_value_problem: holds, sn satisfies it", "[paper][claims]") {
    check_identity("sn_initial_value_problem");
    const precision_scope precision(50);
    const auto v = jacobi(mpfr(1), modulus<mpfr>::from_modulus(mpfr(2) / 3));
    const mpfr slope = v.cn * v.dn;  // sn' = cn dn
    CHECK(abs(slope * slope - (1 - v.sn * v.sn) * (1 - v.sn * v.sn * 4 / 9)) < mpfr("1e-47"));
}

TEST_CASE("claim one_function_for_all_motion: holds, with moduli on either side of 1", "[paper][claims]") {
    check_identity("one_function_for_all_motion");
}

// k = sqrt(mpf(1)/2); 4*asin(k*ellipfun('sn', 1, k=k))
TEST_CASE("claim one_initial_condition: corrected, the sign of the other one is lost", "[paper][claims]") {
    check_number("one_initial_condition", verdict::corrected, "2.41536215905399295");
    const precision_scope precision(50);
    const motion up = motion::of_energy_from(1, exact{}, 1);
    const motion down = motion::of_energy_from(1, exact{}, -1);
    CHECK(theta_of(up, "1") - theta_of(down, "1") > 2);
}

// 2 + 2*sqrt(mpf(2)): the slowest omega at E = 4 is 2.
TEST_CASE("claim shifts_reach_all_states: corrected, rotation never turns round", "[paper][claims]") {
    check_number("shifts_reach_all_states", verdict::corrected, "4.82842712474619010");
    const precision_scope precision(50);
    for (const std::string time : {"0", "T/8", "T/4", "T/2", "7T/8"}) {
        CHECK(state_of<mpfr>(with_energy("4"), time).omega > 1);
    }
}

}  // namespace paper_background_test
