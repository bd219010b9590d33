
#include <algorithm>

#include "judging.hpp"
#include "libration/elliptic/named_function.hpp"
#include "libration/pendulum/critical_formula.hpp"

namespace libration {

using namespace series;
using namespace elliptic;
using namespace pendulum;

namespace {

using namespace judging;

// (critical) as printed.
mpfr printed_separatrix(const mpfr& theta0, const mpfr& t) {
    return atan(exp(t) * tan((theta0 + pi<mpfr>()) / 4)) * 4 - pi<mpfr>();
}

claim separatrix_formula() {
    return {"separatrix_formula",
            "critical",
            "theta = -pi + 4 arctan(e^t tan((theta0 + pi)/4)) is the solution at E = 2, for every theta0.",
            "|printed - integrated| at t = 1 from (0, -2)",
            "For omega0 = +2 cos(theta0/2) and |theta0| < pi. The clockwise motion from (0, -2) is the reflection: at "
            "t = 1 it is at -1.73, the formula at +1.73. From theta0 = 2 pi the formula starts at -2 pi.",
            "./run trajectory --energy 2 --direction - --times 0,1",
            [] {
                mpfr counterclockwise(0);
                mpfr corrected(0);
                for (const char* angle : {"0", "1", "-2", "5pi/2", "-9"}) {
                    for (const int d : {1, -1}) {
                        const motion m = motion::of_energy_from(2, read_exact(angle), d);
                        const mpfr theta0 = from_exact<mpfr>(read_exact(angle));
                        const mpfr theta = by_flow(theta0, abs(cos(theta0 / 2)) * (2 * d), mpfr(1)).value;
                        corrected = std::max(corrected, mpfr(abs(critical_formula(m, mpfr(1)) - theta)));
                        if (d > 0 && abs(theta0) < pi<mpfr>()) {
                            const mpfr error = abs(printed_separatrix(theta0, mpfr(1)) - theta);
                            counterclockwise = std::max(counterclockwise, error);
                        }
                    }
                }
                const mpfr clockwise = by_flow(mpfr(0), mpfr(-2), mpfr(1)).value;
                return by_errors(abs(printed_separatrix(mpfr(0), mpfr(1)) - clockwise),
                                 std::max(corrected, counterclockwise));
            }};
}

claim half_angle_substitution() {
    return {
        "half_angle_substitution",
        "sec:background, text",
        "y = sin(theta/2) turns the energy equation into y'^2 = (1 - y^2)(E/2 - y^2), that of an elliptic function.",
        "largest residual of this equation along integrated motions at t = 0.5, 1 .. 5, E = 0.5, 1.71, 2.02, 8",
        "",
        "./run trajectory --energy 8 --times 0:5:11",
        [] {
            mpfr largest(0);
            for (const char* energy : {"0.5", "1.71", "2.02", "8"}) {
                const mpfr e = number(energy);
                const auto top = top_of(e);
                flow<mpfr> along(top.value, top.slope);
                for (int i = 1; i <= 10; ++i) {
                    const auto& at = along.advance_to(mpfr(i) / 2);
                    const mpfr y = sin(at.theta.re / 2);
                    const mpfr slope = cos(at.theta.re / 2) * at.omega.re / 2;
                    const mpfr square = (1 - y * y) * (e / 2 - y * y);
                    largest = std::max(largest, mpfr(abs(slope * slope - square)));
                }
            }
            return by_error(largest);
        }};
}

// (subcritical) as printed, with this sign in front.
mpfr printed_libration(const mpfr& k, const mpfr& t) {
    const auto v = jacobi(t, modulus<mpfr>::from_modulus(k));
    return asin(k * v.cn / v.dn) * 2;
}

claim libration_formula() {
    return {
        "libration_formula",
        "subcritical",
        "theta = 2 arcsin(k cd(t, k)), k = sqrt(E/2), is every libration from rest.",
        "|printed - integrated| at t = 1, released at -60 degrees (E = 1/2)",
        "For theta0 > 0; released at theta0 < 0 the sign is the other one: from -60 degrees theta(1) = -0.634, printed "
        "+0.634.",
        "./run trajectory --theta0 -60deg --omega0 0 --times 0,1",
        [] {
            mpfr corrected(0);
            for (const char* energy : {"0.5", "1.71"}) {
                const mpfr k = sqrt(number(energy) / 2);
                const mpfr start = top_of(number(energy)).value;
                for (const int t : {1, 2, 5, 9}) {
                    const mpfr theta = printed_libration(k, mpfr(t));
                    const mpfr right = abs(by_flow(start, mpfr(0), mpfr(t)).value - theta);
                    const mpfr left = abs(by_flow(-start, mpfr(0), mpfr(t)).value + theta);
                    corrected = std::max({corrected, right, left});
                }
            }
            const mpfr printed = printed_libration(mpfr(1) / 2, mpfr(1));
            return by_errors(abs(printed - by_flow(-pi<mpfr>() / 3, mpfr(0), mpfr(1)).value), corrected);
        }};
}

claim rotation_formula() {
    return {
        "rotation_formula",
        "supercritical",
        "theta = 2 arcsin(sn(t sqrt(E/2), sqrt(2/E))) is the rotation from theta0 = 0.",
        "|printed - integrated| after one period T, E = 4, theta0 = 0, omega0 > 0",
        "For |t| <= T* and omega0 > 0: beyond, the arcsine folds the angle into [-pi, pi] and turns back. Unwrapped it "
        "is 2 am(t sqrt(E/2), sqrt(2/E)); after a turn theta = 2 pi and the printed form is back at 0.",
        "./run trajectory --energy 4 --theta0 0 --times 0,T/4,3T/4,T",
        [] {
            const mpfr rate = sqrt(mpfr(2));
            const auto shape = modulus<mpfr>::from_modulus(1 / rate);
            const mpfr half = complete_integral(shape) / rate;
            const auto printed = [&](const mpfr& t) { return mpfr(asin(jacobi(mpfr(t * rate), shape).sn) * 2); };
            mpfr corrected(0);
            for (int i = 1; i <= 8; ++i) {
                const mpfr t = half * i / 2;
                const mpfr theta = by_flow(mpfr(0), rate * 2, t).value;
                const mpfr unwrapped = amplitude(mpfr(t * rate), shape) * 2;
                corrected = std::max(corrected, mpfr(abs(unwrapped - theta)));
                if (i < 2) {
                    corrected = std::max(corrected, mpfr(abs(printed(t) - theta)));
                }
            }
            return by_errors(abs(printed(half * 2) - by_flow(mpfr(0), rate * 2, half * 2).value), corrected);
        }};
}

// y = scale sin(theta/2) as a function of u = rate t, with y' and y''.
struct elliptic_motion {
    mpfr y;
    mpfr first;
    mpfr second;
};

elliptic_motion elliptic_motion_at(const jet<mpfr>& start, const mpfr& rate, const mpfr& scale, const mpfr& u) {
    const auto at = by_flow(start.value, start.slope, u / rate);
    const mpfr s = sin(at.value / 2);
    const mpfr c = cos(at.value / 2);
    const mpfr acceleration = -s * at.slope * at.slope / 4 - c * sin(at.value) / 2;
    return {s * scale, c * at.slope / 2 * scale / rate, acceleration * scale / (rate * rate)};
}

// Largest residual of y'^2 = (1 - y^2)(1 - k^2 y^2) and of y'' = -(1 + k^2) y + 2 k^2 y^3, which fixes the solution.
mpfr elliptic_residual(const elliptic_motion& m, const mpfr& k_squared) {
    const mpfr square = m.y * m.y;
    const mpfr first = abs(m.first * m.first - (1 - square) * (1 - k_squared * square));
    const mpfr second = abs(m.second + m.y * (1 + k_squared - k_squared * square * 2));
    return std::max(first, second);
}

claim cd_initial_value_problem() {
    return {
        "cd_initial_value_problem",
        "sec:background, text",
        "cd satisfies (y')^2 = (1 - y^2)(1 - k^2 y^2), y(0) = 1.",
        "largest residual of this equation and of y'' = -(1 + k^2) y + 2 k^2 y^3 at u = 0 .. 4, and |cd(0) - 1|, k = "
        "1/2, from the integrated motion",
        "",
        "./run trajectory --energy 0.5 --times 0,1",
        [] {
            const mpfr k = mpfr(1) / 2;
            const jet<mpfr> start{pi<mpfr>() / 3, mpfr(0)};
            mpfr residual = abs(elliptic_motion_at(start, mpfr(1), 1 / k, mpfr(0)).y - 1);
            for (int u = 0; u <= 4; ++u) {
                const auto at = elliptic_motion_at(start, mpfr(1), 1 / k, mpfr(u));
                residual = std::max(residual, elliptic_residual(at, k * k));
            }
            return by_error(residual);
        }};
}

claim sn_initial_value_problem() {
    return {
        "sn_initial_value_problem",
        "sec:background, text",
        "sn satisfies (y')^2 = (1 - y^2)(1 - k^2 y^2), y(0) = 0.",
        "largest residual of this equation and of y'' = -(1 + k^2) y + 2 k^2 y^3 at u = 0 .. 4, and |sn(0)|, k = 2/3, "
        "from the integrated motion",
        "",
        "./run trajectory --theta0 0 --omega0 3 --times 0,2/3",
        [] {
            const mpfr k = mpfr(2) / 3;
            const jet<mpfr> start{mpfr(0), mpfr(3)};
            mpfr residual = abs(elliptic_motion_at(start, 1 / k, mpfr(1), mpfr(0)).y);
            for (int u = 0; u <= 4; ++u) {
                const auto at = elliptic_motion_at(start, 1 / k, mpfr(1), mpfr(u));
                residual = std::max(residual, elliptic_residual(at, k * k));
            }
            return by_error(residual);
        }};
}

// 2 am(t sqrt(E/2), sqrt(2/E)) in balls, at energies whose sqrt(E/2) is this fraction.
mpfr by_one_function(const rational& rate, const rational& time) {
    const exact argument = exactly(rational(rate * time));
    const function_arguments at{argument, real_parameter::from_parameter(exactly(rational(1 / (rate * rate))))};
    return midpoint_of((*find_function("am"))(at).value()) * 2;
}

claim one_function_for_all_motion() {
    return {"one_function_for_all_motion",
            "sec:background, text",
            "The solution can be expressed as a single elliptic function that governs all motion of the pendulum.",
            "largest |theta - 2 am(t sqrt(E/2), sqrt(2/E))| from the bottom at t = 1, 2, 7, E = 1/2, 9/8, 2, 9/2, 8: "
            "moduli "
            "above, at and below 1",
            "",
            "./run elliptic am --u 1/2 --m 4 --digits 20",
            [] {
                mpfr largest(0);
                for (const auto& rate : {rational(1, 2), rational(3, 4), rational(1), rational(3, 2), rational(2)}) {
                    for (const long time : {1L, 2L, 7L}) {
                        const mpfr theta = by_flow(mpfr(0), from_rational<mpfr>(rational(rate * 2)), mpfr(time)).value;
                        largest = std::max(largest, mpfr(abs(theta - by_one_function(rate, rational(time)))));
                    }
                }
                return by_error(largest);
            }};
}

claim one_initial_condition() {
    return {
        "one_initial_condition",
        "sec:background, text",
        "Beside the energy one initial condition specifies the solution, theta0 or omega0; the other follows from E.",
        "distance at t = 1 of two motions with E = 1 and theta0 = 0",
        "The other follows up to its sign: E = 1 and theta0 = 0 leave omega0 = +sqrt 2 and -sqrt 2, which are 2.42 "
        "apart at t = 1; E = 1 and omega0 = 0 leave theta0 = +-90 degrees.",
        "./run trajectory --energy 1 --theta0 0 --direction - --times 0,1",
        [] {
            const mpfr rising = by_flow(mpfr(0), sqrt(mpfr(2)), mpfr(1)).value;
            const mpfr falling = by_flow(mpfr(0), -sqrt(mpfr(2)), mpfr(1)).value;
            return by_errors(abs(rising - falling), abs(rising + falling));
        }};
}

claim shifts_reach_all_states() {
    return {
        "shifts_reach_all_states",
        "sec:background, text",
        "Every initial condition is reached by shifting in time the solution of the same energy.",
        "smallest |omega(t) - omega0| over 41 times of a period of counterclockwise rotation, E = 4, for the state (0, "
        "-2 sqrt 2) of the same energy",
        "For libration about theta = 0. Rotation never turns round: at E = 4 omega stays between 2 and 2.83, so the "
        "state (0, -2.83) is not on the counterclockwise motion but on its reflection. States around theta = 2 pi n "
        "need 2 pi n added.",
        "./run trajectory --energy 4 --times 0:2.7:10",
        [] {
            const mpfr wanted = -sqrt(mpfr(8));
            const mpfr period = effective_period_of("4") * 2;
            const auto top = top_of(mpfr(4));
            mpfr smallest(10);
            flow<mpfr> along(top.value, top.slope);
            for (int i = 0; i <= 40; ++i) {
                smallest = std::min(smallest, mpfr(abs(along.advance_to(period * i / 40).omega.re - wanted)));
            }
            const auto reflected = by_flow(-top.value, -top.slope, period / 2);
            const mpfr corrected =
                std::max(mpfr(abs(reflected.slope - wanted)), mpfr(abs(reflected.value + pi<mpfr>() * 2)));
            return by_errors(smallest, corrected);
        }};
}

}  // namespace

std::vector<claim> claims_of_closed_solutions() {
    return {
        separatrix_formula(),       half_angle_substitution(),  libration_formula(),           rotation_formula(),
        cd_initial_value_problem(), sn_initial_value_problem(), one_function_for_all_motion(), one_initial_condition(),
        shifts_reach_all_states()};
}

}  // namespace libration
