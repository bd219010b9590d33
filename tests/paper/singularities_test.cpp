// The claims of section III B, judged once more. Numbers without another source are by mpmath 1.3 (mp.dps = 30).
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/expansion.hpp"
#include "paper/verdicts.hpp"
#include "pendulum/typed.hpp"

namespace paper_singularities_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

// R/T* about a point of the motion, by the lattice.
mpfr radius_at(const std::string& energy, const std::string& point) {
    const motion m = with_energy(energy);
    return *expand(exact_solution<mpfr>(m), read_expansion_point(point), 1).radius /
           effective_period(energy_level_of<mpfr>(m));
}

// The terms |a_n| T*^n, n = 198 .. 201: the largest.
mpfr far_term(const std::string& energy, const std::string& point) {
    const auto e = expand(exact_solution<mpfr>(with_energy(energy)), read_expansion_point(point), 201);
    const mpfr ratio = effective_period(energy_level_of<mpfr>(with_energy(energy))) / e.scale;
    mpfr largest(0);
    for (int n = 198; n <= 201; ++n) {
        largest = std::max(largest, mpfr(abs(e.scaled[n]) * pow(ratio, n)));
    }
    return largest;
}

}  // namespace

TEST_CASE("claim separatrix_radius: holds, pi/2 from the coefficients", "[paper][claims]") {
    check_identity("separatrix_radius");
    const precision_scope precision(50);
    // Exactly: theta = 2 gd(t), a_1 = 2, a_3 = -1/3.
    const auto e = expand(exact_solution<mpfr>(with_energy("2")), read_expansion_point("bottom"), 3);
    CHECK(abs(e.scaled[3] / (e.scale * e.scale * e.scale) + mpfr(1) / 3) < mpfr("1e-47"));
    CHECK(abs(e.scale - pi<mpfr>() / 2) < mpfr("1e-48"));
}

// phi = atan(q), q as below; e = [sqrt(abs(sin(n*phi)/n/(sin((n+2)*phi)/(n+2)))) for n in range(300,399,2)];
// max(e)/min(e)
TEST_CASE("claim ratio_test_estimates_radius: corrected, the ratios from the top swing for ever", "[paper][claims]") {
    check_claim("ratio_test_estimates_radius", verdict::corrected, "123.87", "123.88");
}

TEST_CASE("claim arcsine_makes_logarithms: holds, theta gains 4 pi around a pole and nothing elsewhere",
          "[paper][claims]") {
    check_identity("arcsine_makes_logarithms");
}

TEST_CASE("claim libration_singularities: holds, logarithms at odd and odd multiples", "[paper][claims]") {
    check_identity("libration_singularities");
    const precision_scope precision(50);
    // 1/cd vanishes there: cd(K + iK' + z) has a pole, sn(z) = 0 at z = 0, for cd(u + K + iK') = -1/(k sn u).
    CHECK(jacobi(mpfr(0), energy_level_of<mpfr>(with_energy("1.71")).modulus).sn == 0);
}

// ellipk(mpf(1)/2)
TEST_CASE("claim one_figure_for_libration: corrected, the circles change sides at E = 1", "[paper][claims]") {
    check_number("one_figure_for_libration", verdict::corrected, "1.0000000000000000");
    const precision_scope precision(50);
    const energy_level<mpfr> o = energy_level_of<mpfr>(with_energy("1"));
    CHECK(abs(effective_period(o) - singularity_height(o)) < mpfr("1e-48"));
    CHECK_THAT(effective_period(o), near<mpfr>(decimal("1.8540746773013719184"), 0));
    CHECK(far_term("0.5", "bottom") < mpfr("1e-15"));
    CHECK(far_term("1.71", "bottom") > mpfr("1e15"));
}

TEST_CASE("claim nearest_singularity: holds, four share the distance", "[paper][claims]") {
    check_claim("nearest_singularity", verdict::holds, "0.99999999999", "1");
}

// q = ellipk(1-mpf('0.855'))/ellipk(mpf('0.855')); sqrt(1+q*q)
TEST_CASE("claim libration_radius: holds, from four coefficients", "[paper][claims]") {
    check_identity("libration_radius");
    const precision_scope precision(50);
    CHECK_THAT(radius_at("1.71", "top"), near<mpfr>(decimal("1.20876495853"), 0));
    CHECK_THAT(radius_at("0.5", "top"), near<mpfr>(decimal("1.62373340406"), 0));
}

// q = ellipk(1-2/mpf('2.0002'))/ellipk(2/mpf('2.0002')); sqrt(1+q*q)-1
TEST_CASE("claim radius_exceeds_effective_period: holds, K' is never 0", "[paper][claims]") {
    check_number("radius_exceeds_effective_period", verdict::holds, "0.03379580496");
    const precision_scope precision(50);
    // Next to E = 2 the excess is K'^2/(2 T*^2), small but there; K' >= pi/2 for libration.
    const energy_level<mpfr> o = energy_level_of<mpfr>(with_gap("1e-30"));
    CHECK(singularity_height(o) >= pi<mpfr>() / 2);
}

// q = ellipk(1-mpf('0.9999'))/ellipk(mpf('0.9999')); 1/sqrt(1+q*q), less |sin(n phi)|^(1/n)
TEST_CASE("claim unaffected_by_singularities: corrected, they set the rate T*/R", "[paper][claims]") {
    check_claim("unaffected_by_singularities", verdict::corrected, "0.9670", "0.9674");
    const precision_scope precision(50);
    // The same number of powers leaves far more next to E = 2.
    CHECK(far_term("1.9998", "top") > far_term("0.5", "top") * mpfr("1e30"));
}

// q = ellipk(1-mpf('0.25'))/ellipk(mpf('0.25')); sqrt(mpf('0.64')+q*q)/sqrt(1+q*q)
TEST_CASE("claim top_has_the_largest_radius: holds", "[paper][claims]") {
    check_number("top_has_the_largest_radius", verdict::holds, "0.929223259012");
    const precision_scope precision(50);
    CHECK(radius_at("2.02", "T/8") < radius_at("2.02", "top"));
}

// q = ellipk(1-mpf('0.855'))/ellipk(mpf('0.855')); 0.5/sqrt(mpf('0.25')+q*q)*sqrt(1+q*q)
TEST_CASE("claim top_is_the_best_point: corrected, half way covers the descent at a better rate", "[paper][claims]") {
    check_number("top_is_the_best_point", verdict::corrected, "0.716708641358");
    const precision_scope precision(50);
    CHECK(1 / (radius_at("1.71", "T/8") * 2) < 1 / radius_at("1.71", "top"));
    // Per nonzero coefficient, with radii of the lattice in units of T*: mpmath.ellipk(1-m)/mpmath.ellipk(m) is sqrt 2
    // at m = 3 - 2 sqrt 2.
    const auto top_is_better = [](const std::string& energy, const std::string& half_way) {
        return 1 / pow(radius_at(energy, "top"), 2) < 1 / (radius_at(energy, half_way) * 2);
    };
    CHECK(top_is_better("0.343", "T/8"));
    CHECK_FALSE(top_is_better("0.344", "T/8"));
    CHECK_FALSE(top_is_better("11.65", "T/4"));
    CHECK(top_is_better("11.66", "T/4"));
}

// ellipk(mpf(3)/4)/ellipk(mpf(1)/4)
TEST_CASE("claim bottom_radius_of_libration: fails, at E = 1/2 the series from the bottom passes the top",
          "[paper][claims]") {
    check_number("bottom_radius_of_libration", verdict::fails, "1.27926157117");
    const precision_scope precision(50);
    CHECK(far_term("0.5", "bottom") < mpfr("1e-15"));
    CHECK_THAT(singularity_height(energy_level_of<mpfr>(with_energy("0.5"))),
               near<mpfr>(decimal("2.1565156474996432"), 0));
    CHECK_THAT(effective_period(energy_level_of<mpfr>(with_energy("0.5"))),
               near<mpfr>(decimal("1.6857503548125960"), 0));
}

// q = ellipk(mpf(3)/4)/ellipk(mpf(1)/4); sqrt(mpf('0.16')+q*q)... the smallest fall is the last one at E = 1/2:
// q - sqrt(mpf('0.16')+q*q)
TEST_CASE("claim radius_falls_to_the_bottom: holds", "[paper][claims]") {
    check_claim("radius_falls_to_the_bottom", verdict::holds, "-0.06108", "-0.06107");
}

TEST_CASE("claim rotation_singularities: holds, logarithms at even and odd multiples", "[paper][claims]") {
    check_identity("rotation_singularities");
}

// ellipk(mpf(3)/4)/ellipk(mpf(1)/4): sqrt(2/E) = 1/2 as at E = 1/2.
TEST_CASE("claim bottom_radius_of_rotation: corrected, only below E = 4", "[paper][claims]") {
    check_number("bottom_radius_of_rotation", verdict::corrected, "1.27926157117");
    const precision_scope precision(50);
    CHECK(far_term("8", "bottom") < mpfr("1e-15"));
    CHECK(far_term("2.02", "bottom") > mpfr("1e15"));
}

TEST_CASE("claim bottom_radius_footnote: holds, with equality at E = 4", "[paper][claims]") {
    check_identity("bottom_radius_footnote");
    const precision_scope precision(50);
    CHECK(abs(radius_at("4", "bottom") - 1) < mpfr("1e-47"));
}

TEST_CASE("claim bottoms_are_alike: holds", "[paper][claims]") {
    check_identity("bottoms_are_alike");
    const precision_scope precision(50);
    CHECK(abs(radius_at("2.02", "3T/2") - radius_at("2.02", "T/2")) < mpfr("1e-47"));
}

// k2 = 2/mpf('2.02'); q = ellipk(1-k2)/ellipk(k2); sqrt(1+q*q)
TEST_CASE("claim rotation_radius: holds, from four coefficients", "[paper][claims]") {
    check_identity("rotation_radius");
    const precision_scope precision(50);
    CHECK_THAT(radius_at("2.02", "top"), near<mpfr>(decimal("1.08677394515"), 0));
}

}  // namespace paper_singularities_test
