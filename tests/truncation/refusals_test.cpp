// Inputs that the proofs reject, and branches taken by few inputs: near zeros, for wide balls, for many digits.
#include <optional>
#include <vector>

#include "libration/digits/proved_decimals.hpp"
#include "libration/elliptic/real_parameter.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/landen_motion.hpp"
#include "libration/pendulum/proved_libration.hpp"
#include "libration/pendulum/separatrix_sum.hpp"
#include "pendulum/typed.hpp"
#include "truncation/stopped_early.hpp"

namespace truncation_refusals_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("a descent refuses what is not positive and what is too wide", "[truncation][landen_nome]") {
    const precision_scope scope(30);
    const ball quarter = ball(1) / 4;
    CHECK_THROWS_AS(landen_nome(ball(1), ball(0), quarter), libration::error);
    CHECK_THROWS_AS(landen_nome(ball(-1), ball(1), quarter), libration::error);
    CHECK_THROWS_AS(landen_nome(enclose(ball(1), ball(1) / 2), ball(ball(1) / 2), quarter), precision_exhausted);
    // No descent is needed if a_0 = b_0.
    CHECK(contains(landen_nome(ball(1), ball(1), ball(0)).mean(), ball(1)));
}

TEST_CASE("theta by division and next to its zeros is that of both parts together", "[truncation][landen_motion]") {
    // 6100 digits take three terms of the theta series; from 400 digits the divisions use fewer bits.
    for (const long count : {30L, 400L, 1500L, 6100L}) {
        const precision_scope scope(count);
        const landen_motion motion(rational(171, 100), rational(29, 100));
        const ball quarter = pi<ball>() / 2;
        for (const ball& z : {motion.phase_at(rational(7, 10)), quarter, ball(quarter + ldexp(ball(1), -20))}) {
            const ball theta = motion.theta_at(z);
            CHECK(overlaps(theta, motion.state_at(z).theta));
            CHECK(certainly_less(radius_of(theta), ldexp(ball(1), 16 - ball::working_bits())));
        }
        CHECK(contains_zero(motion.theta_at(quarter)));
        CHECK(contains_zero(motion.theta_at(enclose(quarter, ldexp(ball(1), -5)))));
        const auto truth = exact_solution<ball>(with_energy("1.71"))(read_exact("0.7"));
        CHECK(overlaps(motion.theta_at(motion.phase_at(rational(7, 10))), truth.theta));
    }
}

TEST_CASE("fixed point leaves out what it cannot serve", "[truncation][proved_libration]") {
    const precision_scope scope(60);
    CHECK(proved_libration::serves(rational(1), rational(1), 1200));
    CHECK_FALSE(proved_libration::serves(rational(1), rational(1), 1201));
    CHECK_FALSE(proved_libration::serves(rational(1, 200), rational(399, 200), 200));
    CHECK_FALSE(proved_libration::serves(rational(399, 200), rational(1, 200), 200));
    const proved_libration motion(rational(1), rational(1), 200);
    CHECK_FALSE(motion.theta_at(ball(pi<ball>() / 2)));
    CHECK_FALSE(motion.state_at(ball(pi<ball>() / 2)));
    CHECK_FALSE(motion.theta_at(enclose(ball(1), ldexp(ball(1), -6))));
    CHECK_THROWS_AS(proved_libration(rational(19, 10), rational(1, 10), 64, 0), precision_exhausted);
    const fixed_ball zero(2, mp_limb_t{0});
    CHECK(zero.is_zero());
    CHECK(zero.smallness() >= 100);
    fixed_ball wide(2, mp_limb_t{1});
    wide.widen_by(1e15);
    CHECK_THROWS_AS(fixed_ball(2, mp_limb_t{1}) / wide, precision_exhausted);
}

TEST_CASE("angles of wide points are enclosed", "[truncation][ball_arctangent]") {
    const slong bits = 2000;
    const precision_scope scope(600);
    const ball third = ball(1) / 3;
    const ball wide = enclose(third, ldexp(ball(1), -8));
    CHECK(contains(arctangent_of_quotient(wide, ball(1), bits), atan(third)));
    const ball around = enclose(ball(0), ldexp(ball(1), -30));
    CHECK(contains(angle_of_point(around, ball(1), bits), ball(0)));
    CHECK(contains(angle_of_point(ball(1), around, bits), ball(pi<ball>() / 2)));
    CHECK(contains(angle_of_point(around, around, bits), ball(3)));
    for (const int quarter : {0, 1, 2, 3}) {
        const ball angle = ball(1) / 3 + pi<ball>() / 2 * (quarter - 2);
        const ball found = angle_of_point(sin(angle), cos(angle), bits);
        CHECK(overlaps(found, angle));
        CHECK(certainly_less(radius_of(found), ldexp(ball(1), -1900)));
    }
}

TEST_CASE("decimals before the point and zeros that are known are printed", "[truncation][ball]") {
    const precision_scope scope(30);
    CHECK(to_proved_decimal(ball(123'456'789), 3).value().text == "1.23e8");
    CHECK_FALSE(to_proved_decimal(ball(ball(1) / ball(0)), 3));
    const auto noise = [] { return std::vector<ball>{enclose(ball(0), epsilon<ball>()), ball(2)}; };
    const auto printed = proved_decimals(5, noise, [] { return std::vector<bool>{true}; });
    CHECK(printed[0].text == "0");
    CHECK(printed[1].text == "2.0000");
    // A first run with too few digits, and a value that is nonzero in the second.
    const auto loss = [] { return std::vector<ball>{enclose(ball(2), pow(ball(10), 22 - working_digits()))}; };
    CHECK(proved_decimals(5, loss, [] { return std::vector<bool>{true}; })[0].text == "2.0000");
    CHECK_THROWS_AS(proved_decimals(5, noise, [] { return std::vector<bool>{false, true}; }), libration::error);
}

TEST_CASE("a coefficient that symmetry takes away is 0, and one without any pole is its bound",
          "[truncation][lattice_coefficients]") {
    const precision_scope scope(40);
    const motion m = with_energy("1.71");
    const exact_solution<ball> solution(m);
    const auto truth = expand_by(recurrence::sine_cosine, solution, {}, 9);
    CHECK(is_exact(lattice_coefficients<ball>(m, {}, truth.scale, 9).between(7, 7).front()));
    const ball bound = lattice_coefficients<ball>(m, {}, truth.scale, 9, -40).between(8, 8).front();
    CHECK(contains(bound, truth.scaled[8]));
    CHECK(contains_zero(bound));
}

TEST_CASE("the sum over columns holds before and behind every quarter", "[truncation][separatrix_sum]") {
    const precision_scope scope(40);
    for (const auto& m : {with_energy("0.5"), with_energy("3"), with_energy("3", -1)}) {
        const exact_solution<ball> solution(m);
        const separatrix_sum<ball> sum(m);
        for (const std::string time :
             {"-0.3", "0.3", "T/4-0.1", "T/4+0.1", "T/2-0.3", "T/2+0.3", "3T/4+0.1", "T-0.3"}) {
            INFO(time);
            const auto found = sum(read_exact(time));
            const auto truth = solution(read_exact(time));
            CHECK(overlaps(found.value, truth.theta));
            CHECK(overlaps(found.slope, truth.omega));
        }
    }
}

TEST_CASE("motions by formulas are those by fractions", "[truncation][motion]") {
    const auto regime_of = [](const char* energy, const char* theta0) {
        return motion::of_energy_from(read_exact(energy), read_exact(theta0)).regime();
    };
    CHECK(regime_of("sqrt(2)", "pi/3") == regime::libration);
    CHECK(regime_of("1.5", "1/3+pi/7") == regime::libration);
    CHECK(regime_of("1+sqrt(2)", "1") == regime::rotation);
    CHECK(regime_of("2", "1") == regime::separatrix);
    CHECK_THROWS_AS(regime_of("sqrt(2)/10", "2"), libration::error);
    CHECK_FALSE(motion::of_energy_from(rational(3, 2), read_exact("1")).omega0_squared());
    const motion rest = with_state("0", "0");
    CHECK(rest.omega0_squared() == rational(0));
    CHECK_FALSE(motion::of_state(read_exact("1"), read_exact("sqrt(2)+1/3")).omega0_squared());
    // A rotation through the top, from each side.
    CHECK(with_state("pi", "1").start_quarter() == 1);
    CHECK(with_state("-pi", "-1").start_quarter() == 1);
    CHECK(with_state("3pi", "-1").start_quarter().has_value());
}

TEST_CASE("a parameter keeps the one of m and 1 - m that was given, and no modulus is negative",
          "[truncation][modulus]") {
    CHECK_THROWS_AS(real_parameter::from_modulus(read_exact("-1/2")), libration::error);
    CHECK(real_parameter::from_modulus(read_exact("1/2")).m().coefficient == rational(1, 4));
    const precision_scope scope(30);
    // 30 digits do not distinguish 1 - 1e-40 from 1.
    const auto m = real_parameter::from_complement(read_exact("1e-40")).reduced();
    CHECK(overlaps(m.complement, pow(ball(10), -20)));
    CHECK_NOTHROW(real_parameter::from_complement(read_exact("1e-40")).within());
    CHECK_NOTHROW(real_parameter::from_parameter(read_exact("1e-40")).within());
}

TEST_CASE("the turns of a formula next to an odd multiple of pi are decided", "[truncation][motion]") {
    // In 64 bits these round to pi and 3 pi, in the next turn.
    CHECK(wind(read_exact("pi+1e-30")).turns == 1);
    CHECK(wind(read_exact("pi+1e-30")).rest.sign == -1);
    CHECK(wind(read_exact("pi-1e-30")).turns == 0);
    CHECK(wind(read_exact("3*pi-1e-30")).turns == 1);
    CHECK(wind(read_exact("3*pi-1e-30")).rest.sign == 1);
    CHECK(wind(read_exact("3*pi+1e-30")).turns == 2);
}

}  // namespace truncation_refusals_test
