// Claims of section III B: the singularities of rotation, and the resulting radius about the top and the bottom.
#include <algorithm>
#include <tuple>

#include "lattice_checks.hpp"

namespace libration {

using namespace series;
using namespace convergence;
using namespace pendulum;

namespace {

using namespace judging;

claim rotation_singularities() {
    return {"rotation_singularities",
            "rotatingpoles",
            "Above E = 2, from the bottom, theta is singular at even multiples of T* plus odd multiples of i K~'.",
            "largest distance of the circuits around i K~', -i K~', 2T* + i K~' from those of +-2i log, and of the one "
            "around T* + i K~' from none, E = 2.02, 8",
            "",
            "./run trajectory --energy 8 --theta0 0 --times T/2",
            [] {
                mpfr largest(0);
                for (const char* energy : {"2.02", "8"}) {
                    const auto [along, up] = lattice_of(energy);
                    const auto start = bottom_of(energy);
                    const mpfr half = std::min(along, up) / 2;
                    for (const auto& [right, above, sign] : {std::tuple{0, 1, -1}, {0, -1, 1}, {2, 1, -1}}) {
                        const auto c = around(start, {along * right, up * above}, half);
                        largest = std::max(largest, distance_from_logarithm(c, sign));
                    }
                    largest = std::max(largest, modulus_of(around(start, {along, up}, half).theta));
                }
                return by_error(largest);
            }};
}

claim bottom_radius_of_rotation() {
    return {"bottom_radius_of_rotation",
            "fig:supercrit, text",
            "Expanded at the bottom, the series of every rotation diverges before T*: one figure serves all E > 2.",
            "R/T* from a_397 and a_399 about the bottom, E = 8",
            "Only for 2 < E < 4, as footnote 7 says itself. At E = 8 R = K~' = 1.08 and T* = 0.843.",
            "./run coefficients --energy 8 --at bottom --order 20",
            [] {
                const mpfr ratio = bottom_radius("8");
                return by_tests(ratio < 1, bottom_radius("3.9") < 1 && bottom_radius("4.1") > 1, ratio);
            }};
}

claim bottom_radius_footnote() {
    return {"bottom_radius_footnote",
            "sec:sing, footnote 7",
            "For rotation the radius about the bottom is K~', and it exceeds T* only for E > 4.",
            "largest of |R/K~' - 1| at E = 2.02, 3.9, 4.1, 8 and |R/T* - 1| at E = 4, R from a_397 and a_399",
            "",
            "./run period --energy 4 --digits 20",
            [] {
                mpfr largest = abs(bottom_radius("4") - 1);
                for (const char* energy : {"2.02", "3.9", "4.1", "8"}) {
                    const mpfr ratio = bottom_radius(energy) / lattice_distance(energy, mpfr(0));
                    largest = std::max(largest, mpfr(abs(ratio - 1)));
                }
                const bool sides = bottom_radius("3.9") < 1 && bottom_radius("4.1") > 1;
                return by_test(sides && largest < negligible(), largest);
            }};
}

claim bottoms_are_alike() {
    return {"bottoms_are_alike",
            "fig:supercrit, text",
            "Every passage of a rotation through the bottom, theta0 = 2 pi n, has the same radius.",
            "largest |R(2 pi n)/R(0) - 1|, n = 1, -1, 3, E = 2.02, R from a_397 and a_399",
            "",
            "./run coefficients --theta0 2pi --omega0 2.01 --order 9",
            [] {
                const mpfr first = bottom_radius("2.02");
                mpfr largest(0);
                for (const int turns : {1, -1, 3}) {
                    const mpfr ratio = bottom_radius("2.02", pi<mpfr>() * (2 * turns)) / first;
                    largest = std::max(largest, mpfr(abs(ratio - 1)));
                }
                return by_error(largest);
            }};
}

claim rotation_radius() {
    return {"rotation_radius",
            "rotationROCgood",
            "From the top of rotation the radius of convergence is sqrt(T*^2 + K~'^2).",
            "largest relative difference of the radius from four coefficients, n = 593 .. 599, E = 2.02, 2.5, 4, 8",
            "",
            "./run coefficients --energy 2.02 --order 20",
            [] {
                return radius_formula({"2.02", "2.5", "4", "8"});
            }};
}

}  // namespace

std::vector<claim> claims_of_singularities_of_rotation() {
    return {rotation_singularities(), bottom_radius_of_rotation(), bottom_radius_footnote(), bottoms_are_alike(),
            rotation_radius()};
}

}  // namespace libration
