// Claims of section II about the exact period, and the symmetries that reduce it to T*.
#include <algorithm>
#include <vector>

#include "judging.hpp"
#include "libration/elliptic/incomplete_integral.hpp"
#include "libration/pendulum/exact_solution.hpp"

namespace libration {

using namespace elliptic;
using namespace pendulum;

namespace {

using namespace judging;

claim unwound_period() {
    return {
        "unwound_period",
        "sec:background, text",
        "theta(t) = theta(t +- T) below E = 2; above, theta(t) = theta(t +- T) -+ 2 pi for counterclockwise rotation "
        "and with the other sign for clockwise.",
        "largest error of these identities with both signs at t = 0 and 1, E = 0.5, 1.71, 2.02, 8, both directions",
        "",
        "./run trajectory --energy 2.02 --direction - --times 0,T,-T",
        [] {
            mpfr largest(0);
            for (const char* energy : {"0.5", "1.71", "2.02", "8"}) {
                const bool rotates = number(energy) > 2;
                const mpfr period = effective_period_of(energy) * (rotates ? 2 : 4);
                for (const int d : {1, -1}) {
                    const auto top = top_of(number(energy), d);
                    const mpfr turn = rotates ? mpfr(pi<mpfr>() * 2 * d) : mpfr(0);
                    for (const int t : {0, 1}) {
                        const auto theta = [&](const mpfr& time) { return by_flow(top.value, top.slope, time).value; };
                        const mpfr here = theta(mpfr(t));
                        const mpfr later = abs(theta(t + period) - turn - here);
                        const mpfr before = abs(theta(t - period) + turn - here);
                        largest = std::max({largest, later, before});
                    }
                }
            }
            return by_error(largest);
        }};
}

claim period_formula() {
    return {"period_formula",
            "T",
            "T = 4 K(sqrt(E/2)) below E = 2 and 2 sqrt(2/E) K(sqrt(2/E)) above.",
            "largest relative difference from the time that the integrated equation takes from the top to the bottom, "
            "times 4 or 2, E = 1e-6, 0.5, 1.71, 1.9998, 2.02, 8",
            "",
            "./run period --energy 1.71 --digits 30",
            [] {
                mpfr largest(0);
                for (const char* energy : {"1e-6", "0.5", "1.71", "1.9998", "2.02", "8"}) {
                    const mpfr formula = effective_period_of(energy);
                    const auto top = top_of(number(energy));
                    const mpfr bottom = number(energy) > 2 ? mpfr(pi<mpfr>() * 2) : mpfr(0);
                    const auto there = by_flow(top.value, top.slope, formula);
                    // theta'' = 0 at the bottom, so one Newton step finds the passage to the cube of the difference.
                    largest = std::max(largest, mpfr(abs((there.value - bottom) / there.slope) / formula));
                }
                return by_error(largest);
            }};
}

// int_0^{theta0} dtheta/sqrt(2(cos theta - cos theta0)) with theta = theta0 sin x, or int_0^pi dtheta/sqrt(2(E-1+cos
// theta)): smooth and even about both ends, so the midpoint rule converges geometrically.
mpfr time_by_angle(const mpfr& energy, int points) {
    const bool rotates = energy > 2;
    const mpfr top = rotates ? pi<mpfr>() : mpfr(acos(1 - energy));
    const mpfr width = pi<mpfr>() / (rotates ? 1 : 2) / points;
    mpfr sum(0);
    for (int i = 0; i < points; ++i) {
        const mpfr x = width * (2 * i + 1) / 2;
        const mpfr theta = rotates ? x : mpfr(top * sin(x));
        const mpfr weight = rotates ? mpfr(1) : mpfr(top * cos(x));
        sum += weight / sqrt((energy - 1 + cos(theta)) * 2);
    }
    return sum * width;
}

// K(k) as defined by (K), by the same rule.
mpfr integral_of_modulus(const mpfr& k_squared, int points) {
    const mpfr width = pi<mpfr>() / 2 / points;
    mpfr sum(0);
    for (int i = 0; i < points; ++i) {
        const mpfr s = sin(width * (2 * i + 1) / 2);
        sum += 1 / sqrt(1 - k_squared * s * s);
    }
    return sum * width;
}

claim period_substitutions() {
    return {
        "period_substitutions",
        "sec:background, footnote 3",
        "With sin(theta0/2) sin u = sin(theta/2) below E = 2, and u = theta/2 above, the time from the bottom to the "
        "top becomes K(sqrt(E/2)), and sqrt(2/E) K(sqrt(2/E)).",
        "largest relative difference of the integral over the angle and the one over u, both by the midpoint rule with "
        "250 points, and of the arithmetic-geometric mean, E = 0.5, 1, 1.71, 2.5, 8",
        "",
        "./run period --energy 2.5 --digits 30",
        [] {
            constexpr int points = 250;
            mpfr largest(0);
            for (const char* energy : {"0.5", "1", "1.71", "2.5", "8"}) {
                const mpfr e = number(energy);
                const mpfr mean = effective_period_of(energy);
                const mpfr modulus =
                    e > 2 ? mpfr(sqrt(2 / e) * integral_of_modulus(2 / e, points)) : integral_of_modulus(e / 2, points);
                const mpfr angle = time_by_angle(e, points);
                largest = std::max({largest, mpfr(abs(angle / mean - 1)), mpfr(abs(modulus / mean - 1))});
            }
            return by_error(largest);
        }};
}

claim infinite_period() {
    return {"infinite_period",
            "sec:background, text",
            "At E = 2 the period is infinite and the motion is not periodic.",
            "smallest T*/(ln(32/|2-E|)/2) at 2 - E = 1e-10, -1e-10, 1e-30, -1e-30: 1 if T grows without end from both "
            "sides",
            "",
            "./run period --gap 1e-30",
            [] {
                mpfr smallest(10);
                for (const char* gap : {"1e-10", "-1e-10", "1e-30", "-1e-30"}) {
                    const rational g = fraction(gap);
                    const mpfr time = effective_period(energy_level_of<mpfr>(motion::of_energy(rational(2 - g))));
                    const mpfr growth = log(32 / abs(from_rational<mpfr>(g))) / 2;
                    smallest = std::min(smallest, mpfr(time / growth));
                }
                return by_test(abs(smallest - 1) < number("1e-9"), smallest);
            }};
}

// Largest error of the two reflections of the interval [0, T*], about the top and about the bottom.
claim effective_period_suffices() {
    return {
        "effective_period_suffices",
        "Tstar",
        "A quarter of the period of libration, half of that of rotation, gives the whole motion by reflections and "
        "shifts.",
        "largest error of theta(-t) and theta(2T* - t) as reflections of theta(t), at 4 times from the top, E = 0.5, "
        "1.71, 2.02, 8",
        "",
        "./run trajectory --energy 1.71 --times T/8,3T/8,5T/8,7T/8",
        [] {
            mpfr largest(0);
            for (const char* energy : {"0.5", "1.71", "2.02", "8"}) {
                const mpfr duration = effective_period_of(energy);
                const auto top = top_of(number(energy));
                const bool rotates = number(energy) > 2;
                for (int i = 1; i <= 4; ++i) {
                    const mpfr t = duration * i / 5;
                    const auto theta = [&](const mpfr& time) { return by_flow(top.value, top.slope, time).value; };
                    const mpfr here = theta(t);
                    // Even about the top or odd about pi; odd about the bottom, which is 0 or 2 pi.
                    const mpfr about_top = rotates ? mpfr(pi<mpfr>() * 2 - here) : here;
                    const mpfr about_bottom = rotates ? mpfr(pi<mpfr>() * 4 - here) : mpfr(-here);
                    largest = std::max(
                        {largest, mpfr(abs(theta(-t) - about_top)), mpfr(abs(theta(duration * 2 - t) - about_bottom))});
                }
            }
            return by_error(largest);
        }};
}

claim rotation_halves() {
    return {"rotation_halves",
            "sec:background, text",
            "A rotating pendulum passes from any theta0 to theta0 + pi as it passes from theta0 + pi to theta0 + 2 pi.",
            "time from theta0 to theta0 + pi over the time from there to theta0 + 2 pi, E = 2.02, theta0 = pi/2",
            "Only from the bottom or the top, and there in reverse order: theta(T - t) = 2 pi - theta(t). From theta0 "
            "= pi/2 the half through the top takes 3.2 times as long as the half through the bottom, at E = 2.02.",
            "./run trajectory --energy 2.02 --times T/4,3T/4",
            [] {
                const auto time_to = [](const mpfr& theta) {
                    const mpfr k = sqrt(2 / number("2.02"));
                    return mpfr(incomplete_integral(mpfr(theta / 2), modulus<mpfr>::from_modulus(k)) * k);
                };
                const mpfr half = pi<mpfr>();
                const auto ratio_from = [&](const mpfr& theta0) {
                    return mpfr((time_to(theta0 + half) - time_to(theta0)) /
                                (time_to(theta0 + half * 2) - time_to(theta0 + half)));
                };
                const mpfr ratio = ratio_from(half / 2);
                const mpfr symmetric = std::max(mpfr(abs(ratio_from(mpfr(0)) - 1)), mpfr(abs(ratio_from(half) - 1)));
                return by_tests(abs(ratio - 1) < negligible(), symmetric < negligible(), ratio);
            }};
}

}  // namespace

std::vector<claim> claims_of_exact_period() {
    return {unwound_period(),       infinite_period(),           period_formula(),
            period_substitutions(), effective_period_suffices(), rotation_halves()};
}

}  // namespace libration
