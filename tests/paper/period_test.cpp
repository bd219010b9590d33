// The claims about section V. Numbers in quotes: tests/paper/claims_numbers.py (mpmath).
#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/periodic_extension.hpp"
#include "paper/judged.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace paper_period_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

std::string three_digits(const finding& f) { return to_decimal(f.number, 3); }

mpfr error_of(const energy_level<mpfr>& o, const period_rule& rule) {
    return abs(effective_period_by(rule, o) - effective_period(o));
}

}  // namespace

TEST_CASE("claim Kold_converges: holds, within the bound of its remainder", "[paper][claims]") {
    const finding f = measured("Kold_converges");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "0.948");
    // k^2 = 1/2: K = Gamma(1/4)^2/(4 sqrt pi).
    const precision_scope precision(50);
    const mpfr quarter = tgamma(mpfr(mpfr(1) / 4));
    CHECK_THAT(effective_period_series(energy_level_of<mpfr>(with_energy("1")), 200),
               near<mpfr>(mpfr(quarter * quarter / (4 * sqrt(pi<mpfr>()))), 200));
}

TEST_CASE("claim Kold_domain: holds with correction, because k = 1 on the separatrix", "[paper][claims]") {
    const finding f = measured("Kold_domain");
    CHECK(f.verdict == verdict::corrected);
    CHECK(f.number == 1);
    const precision_scope precision(50);
    CHECK_THROWS_AS(energy_level_of<mpfr>(with_energy("2")), libration::error);
}

TEST_CASE("claim Kold_towards_separatrix: holds, every term left out grows with k", "[paper][claims]") {
    const finding f = measured("Kold_towards_separatrix");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "1.64");
}

TEST_CASE("claim period_grows: holds, like ln(32/|2-E|)/2", "[paper][claims]") {
    const finding f = measured("period_grows");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "2.97e-20");
}

TEST_CASE("claim Kold_hundred_terms: holds, 65148 of them for four decimals", "[paper][claims]") {
    const finding f = measured("Kold_hundred_terms");
    CHECK(f.verdict == verdict::holds);
    CHECK(f.number == 65148);
    const precision_scope precision(50);
    const auto o = energy_level_of<mpfr>(with_state("0", "1.9999"));
    CHECK(to_decimal(error_of(o, {period_method::series, 100}), 3) == "2.02");
}

TEST_CASE("claim K2_equals_K: holds, v = sin phi", "[paper][claims]") {
    const finding f = measured("K2_equals_K");
    CHECK(f.verdict == verdict::holds);
    CHECK(f.number > 45);
}

TEST_CASE("claim split_of_K: holds, the integrands add up", "[paper][claims]") {
    const finding f = measured("split_of_K");
    CHECK(f.verdict == verdict::holds);
    CHECK(f.number > 45);
    // At one v by hand: k^2 = 3/4, v^2 = 3/4, so 1-k^2v^2 = 7/16 and 1-v^2 = 1/4; both sides are 8/sqrt 7 there.
    const precision_scope precision(50);
    const mpfr inner = mpfr(7) / 16;
    const mpfr outer = mpfr(1) / 2;
    CHECK_THAT(mpfr((sqrt(inner) - outer) / (inner * outer) + 1 / inner), near<mpfr>(mpfr(8 / sqrt(mpfr(7))), 10));
}

TEST_CASE("claim I2_closed_form: holds, partial fractions and term by term", "[paper][claims]") {
    const finding f = measured("I2_closed_form");
    CHECK(f.verdict == verdict::holds);
    CHECK(f.number > 45);
    const precision_scope precision(50);
    const auto m = modulus<mpfr>::from_modulus(mpfr(mpfr(1) / 2));
    CHECK_THAT(artanh_over_modulus(m), near<mpfr>(mpfr(log(mpfr(3))), 10));
}

TEST_CASE("claim Knew_converges: holds, with brackets near 1/(8 n^2)", "[paper][claims]") {
    const finding f = measured("Knew_converges");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "0.894");
    const precision_scope precision(50);
    const auto o = energy_level_of<mpfr>(with_energy("1"));
    CHECK_THAT(effective_period_resummed(o, 200), near<mpfr>(effective_period(o), 200));
}

TEST_CASE("claim Knew_better: holds, by a factor 6.6 at least", "[paper][claims]") {
    const finding f = measured("Knew_better");
    CHECK(f.verdict == verdict::holds);
    // The limit k -> 0 at N = 0: (pi/8)/(pi/8 - 1/3) = 6.6149.
    CHECK(three_digits(f) == "6.61");
}

TEST_CASE("claim Knew_rapid: holds with correction, because next to E = 2 its error is 1/(8N)", "[paper][claims]") {
    const finding f = measured("Knew_rapid");
    CHECK(f.verdict == verdict::corrected);
    CHECK(three_digits(f) == "0.501");
    const precision_scope precision(50);
    const auto o = energy_level_of<mpfr>(with_gap("1e-12"));
    // 0.0114193 and 0.00123838.
    CHECK(to_decimal(error_of(o, {period_method::resummed, 10}), 3) == "0.0114");
    CHECK(to_decimal(error_of(o, {period_method::resummed, 100}), 3) == "0.00124");
}

TEST_CASE("claim Knew_limit: holds with correction, because k'^2 ln k' is left", "[paper][claims]") {
    const finding f = measured("Knew_limit");
    CHECK(f.verdict == verdict::corrected);
    // K = ln(4/k') + (k'^2/4)(ln(4/k') - 1) + ..., artanh(k)/k = ln(2/k')(1 + k'^2/2) + ...: -1/4 + 1/2.
    CHECK(three_digits(f) == "0.250");
    const precision_scope precision(50);
    const auto o = energy_level_of<mpfr>(with_gap("1e-30"));
    CHECK(to_decimal(error_of(o, {period_method::resummed, 0}), 3) == "0.122");
}

TEST_CASE("claim Knew_tail: holds, though the sum alone converges at k = 1", "[paper][claims]") {
    const finding f = measured("Knew_tail");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "0.999");
}

TEST_CASE("claim figure_period: holds, 178 times better with a tenth of the terms", "[paper][claims]") {
    const finding f = measured("figure_period");
    CHECK(f.verdict == verdict::holds);
    CHECK(three_digits(f) == "178");
}

TEST_CASE("claim figure_period_drift: holds with correction, because a wrong period adds up", "[paper][claims]") {
    const finding f = measured("figure_period_drift");
    CHECK(f.verdict == verdict::corrected);
    CHECK(three_digits(f) == "0.0755");
    const precision_scope precision(50);
    const auto o = energy_level_of<mpfr>(with_state("0", "1.9999"));
    // 400 times 0.0113293 is three quarters of 5.99160.
    const mpfr shift = error_of(o, {period_method::resummed, 10}) * 400 / effective_period(o);
    CHECK(to_decimal(shift, 3) == "0.756");
}

TEST_CASE("claim period_analyticity: holds with correction, because a truncation joins pieces with a jump in theta''",
          "[paper][claims]") {
    const finding f = measured("period_analyticity");
    CHECK(f.verdict == verdict::corrected);
    CHECK(three_digits(f) == "0.0809");
    // The extension itself, omega on both sides of the bottom: its slope jumps by the same amount.
    const precision_scope precision(50);
    const motion m = with_energy("1.71");
    const periodic_extension<mpfr, endpoint_approximant<mpfr>> extended(m, resummation_from_top(arc_of<mpfr>(m), 10));
    const mpfr step("1e-12");
    const auto speed = [&](int side) { return extended.at({integer(2), step * side, side}).slope; };
    const mpfr middle = extended.at({integer(2), mpfr(0), 0}).slope;
    const mpfr jump = (speed(1) - middle) / step - (middle - speed(-1)) / step;
    CHECK(to_decimal(mpfr(abs(jump)), 3) == "0.0809");
}

}  // namespace paper_period_test
