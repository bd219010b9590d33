// The claims about section VI. Numbers in quotes: tests/paper/claims_numbers.py (mpmath).
#include <catch2/catch.hpp>
#include <string>

#include "libration/convergence/test/pole_pair.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/expansion.hpp"
#include "paper/verdicts.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_conclusions_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

std::string three_digits(const finding& f) { return to_decimal(f.number, 3); }

}  // namespace

TEST_CASE("claim converges_beyond_bottom: holds, R^2 = T*^2 + K~'^2", "[paper][claims]") {
    const finding f = measured("converges_beyond_bottom");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "0.0000903");
    // The terms at 1.1 T* fall where R = 1.21 T*.
    const precision_scope precision(50);
    const auto series = arc_series(arc_of<mpfr>(with_energy("1.71")), 400);
    CHECK(abs(series[400]) * pow(mpfr("1.1"), 400) < abs(series[200]) * pow(mpfr("1.1"), 200) / 1000);
}

TEST_CASE("claim optimal_at_top: holds with correction, because the way to the bottom is shorter from its middle",
          "[paper][claims]") {
    const finding f = measured("optimal_at_top");
    CHECK(f.verdict == verdict::corrected);
    CHECK(three_digits(f) == "0.717");
    const precision_scope precision(50);
    const motion m = with_energy("1.71");
    const auto lattice = singularities<mpfr>(m);
    const mpfr middle = lattice->radius(phase_map<mpfr>(m).at(read_exact("T/8")));
    const mpfr top = lattice->radius(phase_map<mpfr>(m).at(read_exact("0")));
    CHECK(middle < top);
    CHECK(to_decimal(mpfr(lattice->effective_period / 2 / middle), 3) == "0.593");
    CHECK(to_decimal(mpfr(lattice->effective_period / top), 3) == "0.827");
}

TEST_CASE("claim better_at_every_truncation: fails, because at a fixed N the resummation grows with T*",
          "[paper][claims]") {
    const finding f = measured("better_at_every_truncation");
    CHECK(f.verdict == verdict::fails);
    CHECK(three_digits(f) == "0.965");
    const precision_scope precision(50);
    const auto loses = [](const std::string& gap, int order) {
        arc_errors errors(with_gap(gap));
        return errors.norm(arc_method::resummed, order).norm > errors.norm(arc_method::series, order).norm;
    };
    CHECK(loses("1.59e-8", 0));
    CHECK(loses("-1.59e-8", 0));
    CHECK_FALSE(loses("1.6e-8", 0));
    CHECK(loses("7e-15", 1));
    CHECK_FALSE(loses("9e-15", 1));
}

TEST_CASE("claim better_at_every_time: holds with correction, because the resummation has a power N+1 more",
          "[paper][claims]") {
    const finding f = measured("better_at_every_time");
    CHECK(f.verdict == verdict::corrected);
    CHECK(three_digits(f) == "93.4");
    // N = 0 at T*/100: 2.7405e-3 against 2.0361e-4.
    const precision_scope precision(50);
    const auto d = arc_of<mpfr>(with_energy("1.71"));
    const mpfr x = mpfr(1) / 100;
    const mpfr theta = exact_solution<mpfr>(with_energy("1.71")).from_top(x).theta;
    CHECK(to_decimal(mpfr(abs(resummation_from_top(d, 0)(x).value - theta)), 3) == "0.00274");
    CHECK(to_decimal(mpfr(abs(series_from_top(d, 0)(x).value - theta)), 3) == "0.000204");
}

TEST_CASE("claim all_times: holds, by reflections and whole periods", "[paper][claims]") {
    const finding f = measured("all_times");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "1.46e-7");
}

// sqrt(pi/6)*gamma(mpf(5)/6)/gamma(mpf(4)/3) = 0.91468135650...; the radius from the list alone.
TEST_CASE("claim rayleigh_scenario: holds, the bubble collapses at the radius", "[paper][claims]") {
    check_claim("rayleigh_scenario", verdict::holds, "0", "1e-8");
}

// The study approximants: below 1e-8 at N = 50 and above 1e-4 at N = 160.
TEST_CASE("claim approximants_continue: corrected, the norms of Blasius grow beyond a moderate order",
          "[paper][claims]") {
    check_claim("approximants_continue", verdict::corrected, "1e4", "1e8");
}

TEST_CASE("claim blasius_scenario: holds, the radius is 5.69", "[paper][claims]") {
    const finding f = measured("blasius_scenario");
    CHECK(f.verdict == verdict::holds);
    // 5.6900380545 in the literature on the Blasius series.
    CHECK(abs(f.number - mpfr("5.69004")) < mpfr("0.0001"));
}

TEST_CASE("claim domb_sykes: holds with correction, because four singularities are equally near", "[paper][claims]") {
    const finding f = measured("domb_sykes");
    CHECK(f.verdict == verdict::corrected);
    // 123.87 from a_n ~ sin(n phi)/(n R^n) alone.
    CHECK(three_digits(f) == "124");
    const precision_scope precision(50);
    const auto e = expand(exact_solution<mpfr>(with_energy("1.71")), read_expansion_point("top"), 5);
    CHECK(e.scaled[1] == 0);
    CHECK(e.scaled[3] == 0);
    // Three terms at n = 100 and 140: their error falls by 0.53264 a power, R/|T* + 3i K'| by mpmath.
    const auto long_list = expand(exact_solution<mpfr>(with_energy("1.71")), read_expansion_point("top"), 144);
    const auto error_at = [&](int n) {
        const auto c = [&](int k) { return mpfr(long_list.scaled[k] * k); };
        const mpfr quotient = (c(n + 2) * c(n - 2) - c(n) * c(n)) / (c(n) * c(n - 4) - c(n - 2) * c(n - 2));
        return mpfr(abs(sqrt(sqrt(quotient)) - 1));
    };
    CHECK(error_at(100) < mpfr("1e-24"));
    CHECK(error_at(140) < error_at(100) * mpfr("1e-9"));
}

TEST_CASE("claim root_test: holds, within 1% at n = 400", "[paper][claims]") {
    const finding f = measured("root_test");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "1.01");
}

TEST_CASE("claim expansion_point_deduced: holds, radii from coefficients alone are largest at the top",
          "[paper][claims]") {
    const finding f = measured("expansion_point_deduced");
    CHECK(f.verdict == verdict::holds);
    CHECK(f.number < pow(mpfr(10), -10));
    // The radii themselves, by another route: four coefficients at E = 4 about the bottom and the top.
    const precision_scope precision(50);
    const auto bottom = expand(exact_solution<mpfr>(with_energy("4")), read_expansion_point("bottom"), 101);
    const auto top = expand(exact_solution<mpfr>(with_energy("4")), read_expansion_point("top"), 101);
    CHECK(abs(single_pole_radius(bottom.scaled, 97, 2) - 1) < mpfr(1) / 1'000'000);
    CHECK(abs(pole_pair_radius(top.scaled, 93, 2) - 1) < mpfr(1) / 1'000'000);
    CHECK(bottom.scale < top.scale);
}

}  // namespace paper_conclusions_test
