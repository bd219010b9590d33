// Claims of section III B: the singularities of libration, their type, and the resulting radius about the top and the
// bottom.
#include <algorithm>
#include <tuple>

#include "lattice_checks.hpp"

namespace libration {

using namespace series;
using namespace convergence;
using namespace pendulum;

namespace {

using namespace judging;

claim separatrix_radius() {
    return {
        "separatrix_radius",
        "sec:sing, text",
        "At E = 2 and theta0 = 0 the nearest singularities are logarithmic, at t = +-i pi/2, and the radius is pi/2.",
        "largest of |R/(pi/2) - 1| from a_399 and a_401, and of the distance of the circuits around +-i pi/2 from "
        "those of +-2i log",
        "",
        "./run coefficients --energy 2 --order 20",
        [] {
            const mpfr height = pi<mpfr>() / 2;
            const auto a = printed_series({mpfr(0), mpfr(2)}, 401, height);
            const mpfr radius = abs(single_pole_radius(a, 399, 2) - 1);
            const auto up = around({mpfr(0), mpfr(2)}, {mpfr(0), height}, height / 4);
            const auto down = around({mpfr(0), mpfr(2)}, {mpfr(0), mpfr(-height)}, height / 4);
            return by_error(std::max({radius, distance_from_logarithm(up, -1), distance_from_logarithm(down, 1)}));
        }};
}

claim libration_singularities() {
    return {"libration_singularities",
            "libratingpoles",
            "Below E = 2, from rest, theta is singular at odd multiples of T* plus odd multiples of i K'.",
            "largest distance of the circuits around T* +- i K' and 3T* + i K' from those of +-2i log, and of the one "
            "around 2T* + i K' from none, E = 0.5, 1.71",
            "",
            "./run trajectory --energy 1.71 --times T/4",
            [] {
                mpfr largest(0);
                for (const char* energy : {"0.5", "1.71"}) {
                    const lattice_steps step = lattice_of(energy);
                    const auto top = top_of(number(energy));
                    const mpfr half = std::min(step.along, step.up) / 2;
                    const auto sign_at = [&](int right, int above, int sign) {
                        const auto c = around(top, {step.along * right, step.up * above}, half);
                        const mpfr distance = sign == 0 ? modulus_of(c.theta) : distance_from_logarithm(c, sign);
                        largest = std::max(largest, distance);
                    };
                    sign_at(1, 1, 1);
                    sign_at(1, -1, -1);
                    sign_at(3, 1, -1);
                    sign_at(2, 1, 0);
                }
                return by_error(largest);
            }};
}

claim arcsine_makes_logarithms() {
    return {
        "arcsine_makes_logarithms",
        "sec:sing, footnote 6",
        "The arcsine turns the poles of cd and sn into logarithmic branch points of theta (and its own branch points, "
        "where its argument is 1, add none).",
        "largest of | |theta gained|/4 pi - 1 | around T* + i K', and of theta gained around i K', where k cd = 1 (E = "
        "1.71, from the top) and around T*, where sn = 1 (E = 2.02, from the bottom)",
        "",
        "./run trajectory --energy 2.02 --theta0 0 --times T/2",
        [] {
            const auto swing = lattice_of("1.71");
            const auto turn = lattice_of("2.02");
            const auto top = top_of(number("1.71"));
            const mpfr zero(0);
            const auto pole = around(top, {swing.along, swing.up}, swing.up / 2);
            const auto above_top = around(top, {zero, swing.up}, swing.up / 2);
            const auto passage = around(bottom_of("2.02"), {turn.along, zero}, turn.up / 2);
            return by_error(std::max({mpfr(abs(modulus_of(pole.theta) / (pi<mpfr>() * 4) - 1)),
                                      modulus_of(above_top.theta), modulus_of(passage.theta)}));
        }};
}

// R/T* at the time x T* after the top, 0 < x < 1, from the coefficients 297 to 300 alone.
mpfr radius_between(const char* energy, const mpfr& x) {
    const mpfr duration = effective_period_of(energy);
    const auto top = top_of(number(energy));
    const auto a = printed_series(by_flow(top.value, top.slope, x * duration), 300, duration);
    return pole_pair_radius(a, 297, 1);
}

claim libration_radius() {
    return {
        "libration_radius",
        "librationROC",
        "From the top of libration the radius of convergence is sqrt(T*^2 + K'^2).",
        "largest relative difference of the radius from four coefficients, n = 592 .. 598, E = 0.5, 1, 1.71, 1.9998",
        "",
        "./run coefficients --energy 1.71 --order 20",
        [] {
            return radius_formula({"0.5", "1", "1.71", "1.9998"});
        }};
}

claim nearest_singularity() {
    return {"nearest_singularity",
            "librationROC, text",
            "From the top of libration none is nearer than the singularity at T* + i K'.",
            "smallest distance of the singularities p T* + i q K', p, q = +-1, +-3, +-5, over |T* + i K'|, E = 1e-6, "
            "0.5, 1.71, 1.9998: four are at the same distance",
            "",
            "./run coefficients --energy 1.71 --order 20",
            [] {
                mpfr smallest(10);
                for (const char* energy : {"1e-6", "0.5", "1.71", "1.9998"}) {
                    const auto [along, up] = lattice_of(energy);
                    const mpfr first = modulus_of(complex_number<mpfr>{along, up});
                    for (int p = -5; p <= 5; p += 2) {
                        for (int q = -5; q <= 5; q += 2) {
                            const mpfr distance = modulus_of(complex_number<mpfr>{along * p, up * q});
                            smallest = std::min(smallest, mpfr(distance / first));
                        }
                    }
                }
                return by_test(smallest > 1 - negligible(), smallest);
            }};
}

claim radius_exceeds_effective_period() {
    return {"radius_exceeds_effective_period",
            "librationROC, rotationROCgood",
            "From the top R > T* at every energy, because K' and K~' are never 0 for finite E.",
            "smallest R/T* - 1, from coefficients, E = 0.5, 1, 1.9, 1.9998, 2.0002, 2.1, 4, 8",
            "",
            "./run period --energy 1.9998",
            [] {
                mpfr smallest(10);
                for (const char* energy : {"0.5", "1", "1.9", "1.9998", "2.0002", "2.1", "4", "8"}) {
                    smallest = std::min(smallest, mpfr(top_radius(energy) - 1));
                }
                return by_test(smallest > 0, smallest);
            }};
}

// The largest |a_n T*^n n/8|^(1/n), n = 600 .. 616: the rate at which terms decrease between the top and the bottom.
mpfr rate_of_fall(const char* energy) {
    const auto a = arc_series(arc_of<mpfr>(of_energy(energy)), 616, recurrence::sine_cosine);
    mpfr largest(0);
    for (int n = 600; n <= 616; ++n) {
        if (a[n] != 0) {
            largest = std::max(largest, mpfr(exp(log(abs(a[n]) * n / 8) / n)));
        }
    }
    return largest;
}

claim unaffected_by_singularities() {
    return {"unaffected_by_singularities",
            "abstract",
            "From the top the series converges down to the bottom without being affected by the singularities.",
            "largest (|a_n| T*^n n/8)^(1/n), n = 600 .. 616, E = 1.9998: the factor that a power gains at the bottom",
            "It converges, but the nearest singularities set how fast: the factor is T*/R, 0.616 at E = 1/2 and 0.967 "
            "at E = 1.9998, where 958 powers are needed instead of 68 (machine_precision_is_reached).",
            "./run study error_norm --energies 0.5,1.9998 --orders 5,10,20",
            [] {
                const mpfr near = rate_of_fall("1.9998");
                const mpfr far = rate_of_fall("0.5");
                const mpfr near_rate = 1 / lattice_distance("1.9998", mpfr(1));
                const mpfr far_rate = 1 / lattice_distance("0.5", mpfr(1));
                const mpfr tolerance = mpfr(1) / 1000;  // |sin(n phi)|^(1/n)
                const bool as_the_lattice =
                    abs(near / near_rate - 1) < tolerance && abs(far / far_rate - 1) < tolerance;
                return by_tests(abs(near - far) < tolerance, as_the_lattice, near);
            }};
}

claim radius_falls_to_the_bottom() {
    return {
        "radius_falls_to_the_bottom",
        "sec:sing, text",
        "The radius falls monotonically while the expansion point of libration moves from the top to the bottom.",
        "largest (R(next) - R)/T* along x = 0, 0.2, 0.4, 0.6, 1 (times T* from the top), from coefficients, E = 0.5, "
        "1.71: negative where it falls",
        "",
        "./run coefficients --energy 1.71 --at T/8 --order 20",
        [] {
            mpfr largest(-10);
            for (const char* energy : {"0.5", "1.71"}) {
                mpfr before = top_radius(energy);
                for (int fifth = 1; fifth <= 3; ++fifth) {
                    const mpfr radius = radius_between(energy, mpfr(fifth) / 5);
                    largest = std::max(largest, mpfr(radius - before));
                    before = radius;
                }
                largest = std::max(largest, mpfr(bottom_radius(energy) - before));
            }
            return by_test(largest < 0, largest);
        }};
}

claim bottom_radius_of_libration() {
    return {
        "bottom_radius_of_libration",
        "fig:subcrit, text",
        "Expanded at the bottom, the series of every libration converges for less than T*.",
        "R/T* from a_397 and a_399 about the bottom, E = 1/2",
        "Only for 1 < E < 2. At E = 1/2 (released at 60 degrees) R = K' = 2.157 and T* = K = 1.686: the series from "
        "the bottom reaches the top and beyond. At E = 1 both are 1.854.",
        "./run coefficients --energy 0.5 --at bottom --order 20",
        [] {
            const mpfr ratio = bottom_radius("0.5");
            return by_test(ratio < 1, ratio);
        }};
}

claim one_figure_for_libration() {
    return {
        "one_figure_for_libration",
        "fig:subcrit",
        "One figure of the lattice, with the circles about the bottom inside (-T*, T*), serves all E < 2.",
        "R/T* from a_397 and a_399 about the bottom at E = 1, where the circle changes sides: 1.28 at E = 1/2, 0.683 "
        "at E = 1.71",
        "The lattice is a rectangle at every energy, but K' crosses K at E = 1: below, the small circles of the figure "
        "reach past T*, and what is drawn holds for 1 < E < 2.",
        "./run period --energy 1 --digits 20",
        [] {
            const mpfr at_one = bottom_radius("1");
            const bool same = bottom_radius("0.5") < 1 && at_one < 1;
            const bool crosses =
                abs(at_one - 1) < negligible() && bottom_radius("0.99") > 1 && bottom_radius("1.01") < 1;
            return by_tests(same, crosses, at_one);
        }};
}

claim top_has_the_largest_radius() {
    return {"top_has_the_largest_radius",
            "fig:subcrit, fig:supercrit",
            "The top is the expansion point with the largest radius, for libration and for rotation.",
            "largest R(x)/R(top) over x = 0.2, 0.4, 0.6 and 1 (times T* from the top), from coefficients, E = 0.5, "
            "1.71, 2.02, 8",
            "",
            "./run coefficients --energy 2.02 --at T/4 --order 20",
            [] {
                mpfr largest(0);
                for (const char* energy : {"0.5", "1.71", "2.02", "8"}) {
                    const mpfr top = top_radius(energy);
                    largest = std::max(largest, mpfr(bottom_radius(energy) / top));
                    for (int fifth = 1; fifth <= 3; ++fifth) {
                        largest = std::max(largest, mpfr(radius_between(energy, mpfr(fifth) / 5) / top));
                    }
                }
                return by_test(largest < 1, largest);
            }};
}

// Whether the series about the top, which has every second power, has the better rate per nonzero coefficient than the
// one half way.
bool top_is_better_by_coefficient(const char* energy) {
    const mpfr top = top_radius(energy, 300);
    return 1 / (top * top) < 1 / (radius_between(energy, mpfr(1) / 2) * 2);
}

// |K'/K - sqrt 2| at the modulus sqrt 2 - 1, which is that of E = 6 - 4 sqrt 2 and of E = 6 + 4 sqrt 2.
mpfr error_of_turning_modulus() {
    const auto shape = elliptic::modulus<mpfr>::from_modulus(sqrt(mpfr(2)) - 1);
    return abs(elliptic::complete_integral(shape.swapped()) / elliptic::complete_integral(shape) - sqrt(mpfr(2)));
}

claim top_is_the_best_point() {
    return {
        "top_is_the_best_point",
        "sec:sing, text",
        "The top is the optimal place to expand about, to cover the way from the top to the bottom.",
        "rate (T*/2)/R(T*/2) of an expansion half way over the rate T*/R of the one at the top, R from coefficients, E "
        "= 1.71: below 1 where half way is better",
        "It has the largest radius. To cover the way from the top to the bottom, T*/2 is never worse per power: with k "
        "= K~'/T* its rate is 1/sqrt(1 + 4k^2), that of the top 1/sqrt(1 + k^2), at E = 1.71 0.593 and 0.827. The top "
        "has every second power only, so that its rate per nonzero coefficient is (T*/R)^2 = 1/(1 + k^2), 0.684 at "
        "E = 1.71. This is the better one where (1 + k^2)^2 > 1 + 4k^2, k > sqrt 2: for E < 6 - 4 sqrt 2 = 0.343 and "
        "E > 6 + 4 sqrt 2 = 11.7 only, for K'/K = sqrt 2 at the modulus sqrt 2 - 1 of both.",
        "./run coefficients --energy 1.71 --at T/8 --order 20",
        [] {
            const mpfr half_way = 1 / (radius_between("1.71", mpfr(1) / 2) * 2);
            const mpfr from_top = 1 / top_radius("1.71");
            const bool outside = top_is_better_by_coefficient("0.33") && top_is_better_by_coefficient("12");
            const bool inside = top_is_better_by_coefficient("0.36") || top_is_better_by_coefficient("11.3");
            const bool senses = outside && !inside && error_of_turning_modulus() < negligible();
            return by_tests(half_way >= from_top, half_way < from_top && senses, half_way / from_top);
        }};
}

claim ratio_test_estimates_radius() {
    return {
        "ratio_test_estimates_radius",
        "sec:sing, text",
        "Where singularities are not known, the ratio test on the coefficients estimates the radius.",
        "largest over smallest estimate sqrt|a_n/a_(n+2)|, n = 300 .. 398, E = 1.71 from the top",
        "Not from the top: four singularities at one distance make the ratios swing for ever, by a factor of 124 in "
        "these hundred powers. Four coefficients together give R (librationROC); at the bottom, where two opposite "
        "ones are nearest, the ratio is right to 0.3%.",
        "./run radius --energy 1.71 --order 400",
        [] {
            const auto arc = arc_of<mpfr>(of_energy("1.71"));
            const auto a = arc_series(arc, 400, recurrence::sine_cosine);
            mpfr largest(0);
            mpfr smallest(1000);
            for (int n = 300; n <= 398; n += 2) {
                const mpfr estimate = sqrt(abs(a[n] / a[n + 2]));
                largest = std::max(largest, estimate);
                smallest = std::min(smallest, estimate);
            }
            const auto b = printed_series(bottom_of("1.71"), 399, arc.effective_period());
            const mpfr at_bottom = sqrt(abs(b[397] / b[399])) / lattice_distance("1.71", mpfr(0));
            const mpfr spread = largest / smallest;
            return by_tests(spread < mpfr(101) / 100, abs(at_bottom - 1) < mpfr(1) / 100, spread);
        }};
}

}  // namespace

std::vector<claim> claims_of_singularities() {
    return {separatrix_radius(),          ratio_test_estimates_radius(),     arcsine_makes_logarithms(),
            libration_singularities(),    one_figure_for_libration(),        nearest_singularity(),
            libration_radius(),           radius_exceeds_effective_period(), unaffected_by_singularities(),
            top_has_the_largest_radius(), top_is_the_best_point(),           bottom_radius_of_libration(),
            radius_falls_to_the_bottom()};
}

}  // namespace libration
