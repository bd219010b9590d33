// Claims of the abstract and of sections I and II: the equation, its energy, its limits. The period is in
// exact_period.cpp.
#include <algorithm>
#include <array>
#include <utility>

#include "libration/pendulum/resummation.hpp"
#include "sampled_arc.hpp"

namespace libration {

using namespace pendulum;

namespace {

using namespace judging;

claim dimensionless_equation() {
    return {"dimensionless_equation",
            "pendeqnd",
            "In the time t sqrt(g/l), with omega in units of sqrt(g/l), every simple pendulum obeys theta'' + sin "
            "theta = 0.",
            "largest |theta'' + (g/l) sin theta| at 10 times, theta scaled from the dimensionless motion, theta'' by "
            "differences of step 1e-12, (theta0, omega0) = (1, 1/2 rad/s), l = 1/4 m, g = 9.81 m/s^2",
            "",
            "./run trajectory --theta0 1 --omega0 1/2 --length 1/4 --gravity 9.81 --times 0:2:5",
            [] {
                const mpfr squared_frequency = number("9.81") * 4;
                const mpfr rate = sqrt(squared_frequency);
                const mpfr step = pow(mpfr(10), -12);
                mpfr largest(0);
                for (int i = 1; i <= 10; ++i) {
                    const auto theta = [&](int j) {
                        return by_flow(mpfr(1), 1 / (rate * 2), (mpfr(i) / 5 + step * j) * rate).value;
                    };
                    const mpfr acceleration = (theta(1) - theta(0) * 2 + theta(-1)) / (step * step);
                    largest = std::max(largest, mpfr(abs(acceleration + squared_frequency * sin(theta(0)))));
                }
                return by_test(largest < pow(mpfr(10), -18), largest);  // the differences leave theta'''' step^2/12
            }};
}

claim energy_conservation() {
    return {"energy_conservation",
            "energynd",
            "omega^2/2 + 1 - cos theta keeps its initial value along every motion.",
            "largest |E(t) - E(0)| at 20 times up to 20 of motions integrated from the top, E = 0.5, 1.71, 2.02",
            "",
            "./run trajectory --energy 1.71 --times 0:20:21",
            [] {
                mpfr largest(0);
                for (const char* energy : {"0.5", "1.71", "2.02"}) {
                    const auto top = top_of(number(energy));
                    flow<mpfr> along(top.value, top.slope);
                    for (int t = 1; t <= 20; ++t) {
                        const auto& at = along.advance_to(mpfr(t));
                        const mpfr now = at.omega.re * at.omega.re / 2 + 1 - cos(at.theta.re);
                        largest = std::max(largest, mpfr(abs(now - number(energy))));
                    }
                }
                return by_error(largest);
            }};
}

claim energy_is_not_negative() {
    return {"energy_is_not_negative",
            "energynd, text",
            "E is never negative, and 0 only at rest at the bottom.",
            "smallest E/(2 (theta/pi)^2 + omega^2/2) over 20 x 21 states with 0 < |theta| <= pi, which is 1 or more if "
            "E vanishes nowhere else",
            "",
            "./run period --energy 0",
            [] {
                mpfr smallest(10);
                for (int i = 1; i <= 20; ++i) {
                    for (int j = 0; j <= 20; ++j) {
                        const mpfr share = mpfr(i) / 20;
                        const mpfr kinetic = mpfr(j * j) / 50;
                        const mpfr energy = kinetic + 1 - cos(share * pi<mpfr>());
                        smallest = std::min(smallest, mpfr(energy / (share * share * 2 + kinetic)));
                    }
                }
                return by_test(smallest > 1 - negligible(), smallest);
            }};
}

claim harmonic_limit() {
    return {
        "harmonic_limit",
        "sec:background, text",
        "As E goes to 0, the motion becomes theta0 cos t + omega0 sin t.",
        "order in the amplitude a of the largest difference over 0 < t <= 10, from (a, a), a = 1e-4 and 1e-6: above 1 "
        "for a limit relative to theta",
        "",
        "./run trajectory --theta0 1e-4 --omega0 1e-4 --times 0:10:11 --digits 12",
        [] {
            const auto difference = [](const mpfr& a) {
                flow<mpfr> along(a, a);
                mpfr largest(0);
                for (int t = 1; t <= 10; ++t) {
                    const mpfr time(t);
                    const mpfr linear = a * cos(time) + a * sin(time);
                    largest = std::max(largest, mpfr(abs(along.advance_to(time).theta.re - linear)));
                }
                return largest;
            };
            const mpfr fine = difference(number("1e-6"));
            const mpfr order = log(difference(number("1e-4")) / fine) / log(mpfr(100));
            return by_test(order > 2, order);
        }};
}

claim uniform_rotation_limit() {
    return {
        "uniform_rotation_limit",
        "sec:background, text",
        "As E goes to infinity, the motion becomes theta = omega0 t, whatever the initial angle.",
        "largest |theta - omega0 t| for 0 < t <= 1 from (1, 1000), where E is about 5e5",
        "theta = theta0 + omega0 t: from (1, 1000) the printed form is off by theta0 = 1 at every time, the one with "
        "theta0 by 2t/omega0 at most.",
        "./run trajectory --theta0 1 --omega0 1000 --times 0:1:5 --digits 12",
        [] {
            const mpfr speed(1000);
            flow<mpfr> along(mpfr(1), speed);
            mpfr printed(0);
            mpfr corrected(0);
            for (int i = 1; i <= 4; ++i) {
                const mpfr time = mpfr(i) / 4;
                const mpfr away = along.advance_to(time).theta.re - speed * time;
                printed = std::max(printed, mpfr(abs(away)));
                corrected = std::max(corrected, mpfr(abs(away - 1)));
            }
            return by_tests(printed < mpfr(1) / 100, corrected <= 2 / speed, printed);
        }};
}

claim turning_points() {
    return {
        "turning_points",
        "sec:background, text",
        "Below E = 2 the pendulum swings back at arccos(1-E); above it passes the top, slowest there, with omega^2 = "
        "2E - 4.",
        "largest error of (theta, omega) after T* from the bottom against these values, E = 0.5, 1.71, 1.99, 2.01, "
        "2.02, 8",
        "",
        "./run trajectory --theta0 0 --omega0 1 --times T/4",
        [] {
            mpfr largest(0);
            for (const char* energy : {"0.5", "1.71", "1.99", "2.01", "2.02", "8"}) {
                const auto there = by_flow(mpfr(0), sqrt(number(energy) * 2), effective_period_of(energy));
                const auto top = top_of(number(energy));
                largest = std::max({largest, mpfr(abs(there.value - top.value)), mpfr(abs(there.slope - top.slope))});
            }
            return by_error(largest);
        }};
}

claim separatrix_never_arrives() {
    return {
        "separatrix_never_arrives",
        "sec:background, text",
        "At E = 2 the pendulum rises towards the top for ever: it neither arrives nor falls back.",
        "(pi - theta) e^t at t = 40, from the bottom with omega0 = 2: positive, so not arrived, and bounded, so rising",
        "",
        "./run trajectory --energy 2 --times 0:40:5",
        [] {
            const auto late = by_flow(mpfr(0), mpfr(2), mpfr(40));
            const mpfr left = (pi<mpfr>() - late.value) * exp(mpfr(40));
            return by_test(abs(left - 4) < 1 && late.slope > 0, left);
        }};
}

claim all_motions_pass_the_bottom() {
    return {
        "all_motions_pass_the_bottom",
        "sec:background, text",
        "Every moving pendulum passes the bottom, so motions from (0, omega0) are all there are, up to the origin of "
        "time.",
        "largest distance of 6 states (theta0, omega0) of all three kinds from the motion that leaves the bottom with "
        "the same energy and direction",
        "",
        "./run trajectory --theta0 2.5 --omega0 -0.3 --times 0:10:11",
        [] {
            mpfr largest(0);
            const std::array<std::pair<const char*, const char*>, 6> states{
                {{"1", "1/2"}, {"2.5", "-0.3"}, {"-3", "0.1"}, {"3", "1"}, {"-1", "-4"}, {"120deg", "-1"}}};
            for (const auto& [theta0, omega0] : states) {
                const motion m = of_state(theta0, omega0);
                const auto p = phase_map<mpfr>(m).at(exact{});
                const auto pair = energies<mpfr>(m);
                const bool free = at_critical_energy(m.regime());
                const mpfr since = free ? p.offset
                                        : mpfr(p.offset + from_rational<mpfr>(rational(p.quarter)) *
                                                              effective_period(energy_level_of<mpfr>(m)));
                const int d = m.regime() == regime::libration ? 1 : m.direction();
                const auto there = by_flow(mpfr(0), sqrt(pair.energy * 2) * d, since);
                largest = std::max({largest, mpfr(abs(there.value - from_exact<mpfr>(read_exact(theta0)))),
                                    mpfr(abs(there.slope - number(omega0)))});
            }
            return by_error(largest);
        }};
}

claim reflection_of_direction() {
    return {"reflection_of_direction",
            "fig:surf, caption",
            "From the bottom, the motion with -omega0 is the reflection of the one with omega0.",
            "largest |theta(t; 0, -omega0) + theta(t; 0, omega0)| at t = 1 .. 5, omega0 = 1, 2, 3",
            "",
            "./run trajectory --theta0 0 --omega0 -1 --times 0:5:6",
            [] {
                mpfr largest(0);
                for (int speed = 1; speed <= 3; ++speed) {
                    for (int t = 1; t <= 5; ++t) {
                        const mpfr up = by_flow(mpfr(0), mpfr(speed), mpfr(t)).value;
                        const mpfr down = by_flow(mpfr(0), mpfr(-speed), mpfr(t)).value;
                        largest = std::max(largest, mpfr(abs(up + down)));
                    }
                }
                return by_error(largest);
            }};
}

claim one_series_for_all_time() {
    return {
        "one_series_for_all_time",
        "abstract",
        "One infinite power series describes the motion at all times.",
        "largest |a_n| (3T/8)^n over n = 200 .. 203, E = 1, expanded at the top",
        "It converges for |t| < R only, at E = 1 for |t| < 0.354 T; the other times follow by symmetry (newseries). At "
        "E = 1 the terms at t = 3T/8 grow without end.",
        "./run coefficients --energy 1 --order 20",
        [] {
            const auto arc = arc_of<mpfr>(of_energy("1"));
            const auto a = arc_series(arc, 203);  // a_n T*^n
            mpfr largest(0);
            mpfr inside(0);
            for (int n = 200; n <= 203; ++n) {
                largest = std::max(largest, mpfr(abs(a[n]) * pow(mpfr(3) / 2, n)));
                inside = std::max(inside, mpfr(abs(a[n])));
            }
            return by_tests(largest < 1, inside < number("1e-20"), largest);
        }};
}

claim abstract_uniform_acceleration() {
    return {"abstract_uniform_acceleration",
            "abstract",
            "The resummation accelerates the convergence of the series uniformly from the top to the bottom.",
            "error of the resummation over that of the series at t = T*/10, N = 10, E = 1.71",
            "In the maximum over [0, T*], not at every time: next to the top the error of the resummation begins with "
            "t^(N+1), that of the series with t^(N+2). At E = 1.71, N = 10 and t = T*/10 it is 2.7 times as large.",
            "./run study error_norm --energies 1.71 --orders 10",
            [] {
                const auto arc = arc_of<mpfr>(of_energy("1.71"));
                const auto top = top_of(number("1.71"));
                const auto ratio_at = [&](const mpfr& x) {
                    const mpfr theta = by_flow(top.value, top.slope, x * arc.effective_period()).value;
                    return mpfr(abs(resummation_from_top(arc, 10)(x).value - theta) /
                                abs(series_from_top(arc, 10)(x).value - theta));
                };
                const mpfr early = ratio_at(mpfr(1) / 10);
                const sampled_arc sampled(of_energy("1.71"));
                const bool in_the_norm = sampled.error_norm(sampled.resummed(10)) < sampled.error_norm(sampled.cut(10));
                return by_tests(early < 1, in_the_norm, early);
            }};
}

}  // namespace

std::vector<claim> claims_of_background() {
    return {one_series_for_all_time(), abstract_uniform_acceleration(),
            dimensionless_equation(),  energy_conservation(),
            energy_is_not_negative(),  all_motions_pass_the_bottom(),
            reflection_of_direction(), harmonic_limit(),
            uniform_rotation_limit(),  turning_points(),
            separatrix_never_arrives()};
}

}  // namespace libration
