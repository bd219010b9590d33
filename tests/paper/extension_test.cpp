// The claims of section III C, judged once more.
#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/periodic_extension.hpp"
#include "paper/verdicts.hpp"
#include "pendulum/typed.hpp"

namespace paper_extension_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

mpfr series_norm(const std::string& energy, int order) {
    return arc_errors(with_energy(energy)).norm(arc_method::series, order).norm;
}

// theta by the extended series of the library against the exact solution.
mpfr extension_error(const motion& m, const std::string& time) {
    const periodic_extension<mpfr, truncated_series<mpfr>> extended(m, series_from_top(arc_of<mpfr>(m), 1400));
    return abs(extended(read_exact(time)).value - exact_solution<mpfr>(m)(read_exact(time)).theta);
}

}  // namespace

TEST_CASE("claim series_is_exact_to_the_bottom: holds on both sides of the top", "[paper][claims]") {
    check_identity("series_is_exact_to_the_bottom");
    const precision_scope precision(50);
    const auto arc = arc_of<mpfr>(with_energy("1.71"));
    CHECK(abs(series_from_top(arc, 600)(mpfr(1)).value) < mpfr("1e-40"));  // the bottom: 0
}

// (T* + R)/(2 R) = 0.960 at E = 2.02: 8/mpf(1001)*mpf('0.96007')**1001/(1-mpf('0.96007')**2) is 2e-19 at most.
TEST_CASE("claim series_passes_the_bottom: holds between T* and R", "[paper][claims]") {
    check_claim("series_passes_the_bottom", verdict::holds, "0", "2e-19");
}

TEST_CASE("claim libration_extension: holds in every branch", "[paper][claims]") {
    check_identity("libration_extension");
    const precision_scope precision(50);
    CHECK(extension_error(with_energy("1.71"), "11T/8") < mpfr("1e-40"));
}

TEST_CASE("claim counterclockwise_extension: holds in both branches", "[paper][claims]") {
    check_identity("counterclockwise_extension");
    const precision_scope precision(50);
    CHECK(extension_error(with_energy("2.02"), "11T/8") < mpfr("1e-40"));
}

TEST_CASE("claim clockwise_extension: holds with the constant 0", "[paper][claims]") {
    check_identity("clockwise_extension");
    const precision_scope precision(50);
    const motion m = with_energy("2.02", -1);
    CHECK(extension_error(m, "11T/8") < mpfr("1e-40"));
    // By hand at t = 3T/4: the second branch is -theta~(T/4), and theta~ descends from pi to 0.
    const exact_solution<mpfr> theta(m);
    CHECK(abs(theta(read_exact("3T/4")).theta + theta(read_exact("T/4")).theta) < mpfr("1e-47"));
}

TEST_CASE("claim branches_join: holds at every multiple of T*", "[paper][claims]") { check_identity("branches_join"); }

TEST_CASE("claim remainder_of_time: corrected, beyond the largest multiple that does not exceed t", "[paper][claims]") {
    check_number("remainder_of_time", verdict::corrected, "1.50000000000");
}

// q = ellipk(1-mpf('0.855'))/ellipk(mpf('0.855')); 1.5/sqrt(1+q*q)
TEST_CASE("claim negative_times: corrected, with a remainder that is never negative", "[paper][claims]") {
    check_number("negative_times", verdict::corrected, "1.24093603922760");
    const precision_scope precision(50);
    CHECK(extension_error(with_energy("1.71"), "-3T/8") < mpfr("1e-40"));
    const auto arc = arc_of<mpfr>(with_energy("1.71"));
    CHECK(abs(series_from_top(arc, 600)(mpfr(-3) / 2).value) > mpfr("1e50"));
}

// E = 1-cos(mpf(1)/2)+mpf(1)/2; 2*pi+mpf(1)/2-acos(1-E)
TEST_CASE("claim origin_shift: corrected, a state in another well needs its whole turns", "[paper][claims]") {
    check_number("origin_shift", verdict::corrected, "5.59957319060201591");
    const precision_scope precision(50);
    const motion there = with_state("6.783185307179586476925286766559005768394338798750211641949889", "1");
    const motion here = with_state("1/2", "1");
    CHECK(there.turns() == 1);
    CHECK(abs(exact_solution<mpfr>(there)(read_exact("1")).theta - exact_solution<mpfr>(here)(read_exact("1")).theta -
              pi<mpfr>() * 2) < mpfr("1e-45"));
}

TEST_CASE("claim error_grows_towards_separatrix: corrected, only as an envelope", "[paper][claims]") {
    check_claim("error_grows_towards_separatrix", verdict::corrected, "0.241", "0.242");
    const precision_scope precision(50);
    // At N = 2 the largest error is at T* for E = 1/2: theta_max - sin(theta_max) K^2/2, at 60 degrees.
    const mpfr at_bottom = pi<mpfr>() / 3 - sin(pi<mpfr>() / 3) * pow(mpfr("1.6857503548125960429"), 2) / 2;
    CHECK(abs(series_norm("0.5", 2) - abs(at_bottom)) < mpfr("1e-18"));
    CHECK(series_norm("1.4", 2) < series_norm("0.5", 2) / 4);
    CHECK(series_norm("1.9", 4) < series_norm("1.8", 4));
}

// By the recurrences in mpmath (mp.dps = 40), in t/T*: the last N with |theta(T*) - sum| > 2^-52, plus 1: 958 at E =
// 1.9998, 68 at E = 1/2.
TEST_CASE("claim machine_precision_is_reached: holds, with 958 powers at E = 1.9998", "[paper][claims]") {
    check_claim("machine_precision_is_reached", verdict::holds, "958", "958");
    const precision_scope precision(50);
    CHECK(series_norm("1.9998", 958) < ldexp(mpfr(1), -52));
}

TEST_CASE("claim disk_is_free_of_singularities: holds, a path around a quarter of it gains nothing",
          "[paper][claims]") {
    check_identity("disk_is_free_of_singularities");
}

TEST_CASE("claim figure_libration_orders: holds, although N = 4 is farther from the motion than N = 2",
          "[paper][claims]") {
    check_claim("figure_libration_orders", verdict::holds, "0.57", "0.58");
    const precision_scope precision(50);
    CHECK(series_norm("1.71", 4) > series_norm("1.71", 2));
    CHECK(series_norm("1.71", 6) < series_norm("1.71", 2));
}

TEST_CASE("claim figure_rotation_orders: corrected, rotation from the top has odd powers only", "[paper][claims]") {
    check_claim("figure_rotation_orders", verdict::corrected, "0", "1e-45");
    const precision_scope precision(50);
    CHECK(arc_series(arc_of<mpfr>(with_energy("2.02")), 36)[36] == 0);
    CHECK(series_norm("2.02", 36) == series_norm("2.02", 35));
}

TEST_CASE("claim figure_near_separatrix_orders: corrected, libration from the top has even powers only",
          "[paper][claims]") {
    check_claim("figure_near_separatrix_orders", verdict::corrected, "0", "1e-45");
    const precision_scope precision(50);
    CHECK(series_norm("1.9998", 5) == series_norm("1.9998", 4));
}

}  // namespace paper_extension_test
