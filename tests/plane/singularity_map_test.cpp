// The map of singularities compared with lattices, closed forms and published digits.
#include "libration/plane/singularity_map.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"

namespace plane_singularity_map_test {

using namespace libration;
using namespace libration::ode;

namespace {

singularity_map map_of(const std::string& text, std::optional<double> within = {}) {
    singularity_request request;
    request.within = within;
    return singularities_of(explicit_system(parse(text)), request);
}

std::complex<double> place(const found_singularity& each) {
    return {static_cast<double>(each.offset.re), static_cast<double>(each.offset.im)};
}

// 16 units of double: positions are rounded to it.
constexpr double slack = 16 * 2.220446049250313e-16;

}  // namespace

// The poles 1 + 2 w k of wp(z - 1; 0, 2), k in the triangular lattice, 2 w = 2^(-1/6) Gamma(1/3)^3/(2 pi): wp with
// g3 = 1 has Gamma(1/3)^3/(2 pi) [DLMF 23.5.16], and lengths go like g3^(-1/6).
TEST_CASE("the poles of wp are its lattice", "[ode][singularity]") {
    const double period = std::pow(std::tgamma(1.0 / 3), 3) / (2 * std::numbers::pi) * std::pow(2.0, -1.0 / 6);
    const auto map = map_of(std::string(problem_text("weierstrass")), 4);
    REQUIRE(map.complete);
    std::size_t expected = 0;
    for (int a = -4; a <= 4; ++a) {
        for (int b = -4; b <= 4; ++b) {
            const auto pole = 1.0 + period * (std::complex<double>(a, 0) +
                                              static_cast<double>(b) * std::polar(1.0, std::numbers::pi / 3));
            if (std::abs(pole) > 4) {
                continue;
            }
            ++expected;
            CHECK(std::ranges::any_of(map.all, [&](const found_singularity& each) {
                return std::abs(place(each) - pole) < 64 * slack;  // tgamma, pow
            }));
        }
    }
    CHECK(map.all.size() == expected);
    for (const auto& each : map.all) {
        CHECK(words_of(each.kind, each.exponent.real()) == "pole of order 2");
        CHECK(std::abs(each.coefficient - 1.0) < 1e-6);
        CHECK(std::abs(each.resonances.back() - 6.0) < 1e-6);
    }
}

TEST_CASE("kinds and exponents of closed forms", "[ode][singularity]") {
    const auto pole = map_of("y' = y^2; y(0) = 3/7").all;
    REQUIRE(pole.size() == 1);
    CHECK(pole.front().kind == singularity_kind::pole);
    CHECK(std::abs(pole.front().coefficient + 1.0) < 1e-6);  // -1/(t - 7/3)

    const auto root = map_of("y' = -1/(2*y); y(0) = 1").all;  // sqrt(1 - t)
    REQUIRE(root.size() == 1);
    CHECK(root.front().kind == singularity_kind::algebraic);
    CHECK(root.front().exponent == 0.5);
    CHECK(std::abs(root.front().coefficient - 1.0) < 1e-6);
    CHECK_FALSE(root.front().single_valued);

    const auto logarithm = map_of("y' = exp(y); y(0) = 0").all;  // -log(1 - t)
    REQUIRE(logarithm.size() == 1);
    CHECK(logarithm.front().kind == singularity_kind::logarithm);
    CHECK(std::abs(logarithm.front().coefficient + 1.0) < 1e-6);

    CHECK(map_of("y'' = -y; y(0) = 0; y'(0) = 1").entire);
    CHECK_FALSE(map_of("y'' = -y/(1 + t^2); y(0) = 0; y'(0) = 1").entire);
}

// y = 1 + ((1-t)^(1-r) - 1)/(r-1): 1/w, w = (1-t)^r, is computed from w, which is continued.
TEST_CASE("reciprocals of powers are followed to their singularity", "[ode][singularity]") {
    for (const auto& [r, value] : {std::pair{"(5/2)", 2.5}, {"(33/10)", 3.3}, {"pi", std::numbers::pi}}) {
        CAPTURE(r);
        const auto map = map_of(std::string("y' = 1/(1-t)^") + r + "; y(0) = 1", 2).all;
        REQUIRE(map.size() == 1);
        CHECK(std::abs(place(map.front()) - 1.0) <= static_cast<double>(map.front().uncertainty) + slack);
        CHECK(std::abs(map.front().exponent - (1 - value)) < 1e-6);
        CHECK(std::abs(map.front().coefficient - 1 / (value - 1)) < 1e-6);
    }
}

TEST_CASE("kinds in words", "[ode][singularity]") {
    CHECK(words_of(singularity_kind::branch_pole, -2) == "pole of order 2 with branches");
    CHECK(words_of(singularity_kind::complex_power, -1) == "complex power");
    CHECK(words_of(singularity_kind::logarithm, 0) == "logarithm");
}

// No loop closes round the nearest pair for b = 1. From 400 coefficients the radius is 3.7694 +- 0.0112: `radius
// --problem falkner_skan --set b=1 --order 400 --scalar mpfr:40`.
TEST_CASE("a nearest pair round which singularities of other sheets accumulate", "[ode][singularity]") {
    singularity_request request;
    request.within = 3.9;
    request.most_points = 500;
    const explicit_system layer(parse("f''' + f*f'' + 1 - f'^2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 0.927680039837"));
    const auto map = singularities_of(layer, request);
    REQUIRE(map.all.size() >= 2);
    CHECK(map.all[0].kind == singularity_kind::branch_pole);
    CHECK(std::abs(std::abs(place(map.all[0])) - 3.7694) < 0.0112);
    CHECK(place(map.all[0]) == std::conj(place(map.all[1])));
}

// f ~ 6/(t - t*), and powers t^(-1 + r) with r = 2 +- i sqrt 2 [Blasius: u^(1 +- i sqrt 2)]; the cube root of k scales
// Boyd's radius 5.6900380545 of f'(inf) = 1 [Boyd1999], k = 0.332057...
TEST_CASE("the nearest singularities of Blasius", "[ode][singularity]") {
    const auto map = map_of(std::string(problem_text("blasius")), 4.5);
    REQUIRE(map.all.size() == 3);
    const double radius = 5.6900380545 * std::cbrt(0.33205733621519629894);
    for (const auto& each : map.all) {
        CHECK(std::abs(std::abs(place(each)) - radius) < 1e-10);
        CHECK(std::abs(each.coefficient - 6.0) < 1e-6);
        CHECK_FALSE(each.single_valued);
        REQUIRE(each.resonances.size() == 3);
        CHECK(std::abs(each.resonances[0] + 1.0) < 1e-6);
        CHECK(std::abs(each.resonances[2] - std::complex<double>(2, std::numbers::sqrt2)) < 1e-6);
    }
}

// The first strip of the quadrature [THEOREMS_ODE, SIR]: |Im t| = pi/(r S0 e^(u+) - a), u+ the positive zero of J(u) =
// I0 + S0 (1 - e^u) + (a/r) u.
TEST_CASE("the nearest singularities of SIR are those of its quadrature", "[ode][singularity]") {
    const double r = 0.0178;
    const double a = 2.73;
    const double s0 = 254;
    const double i0 = 7;
    double u = 1;
    for (int k = 0; k < 60; ++k) {
        u -= (i0 + s0 * (1 - std::exp(u)) + a / r * u) / (a / r - s0 * std::exp(u));
    }
    const auto map = map_of(std::string(problem_text("sir")), 3);
    REQUIRE(map.all.size() == 2);
    const double height = std::numbers::pi / (r * s0 * std::exp(u) - a);
    CHECK(std::abs(place(map.all[1]).imag() - height) < 64 * slack);
    CHECK(place(map.all[0]) == std::conj(place(map.all[1])));
}

// 2.38416876956881664 by two computations that agree [PROBLEMS].
TEST_CASE("the first pole of the tritronquee solution", "[ode][singularity]") {
    const auto map = map_of(std::string(problem_text("painleve_1")), 3);
    REQUIRE(map.all.size() == 1);
    CHECK(std::abs(place(map.all.front()) - 2.38416876956881664) < slack);
}

// Falkner and Skan's equation with beta = 1/2: places beyond the nearest singularity -3.54573.. that no path reaches.
TEST_CASE("a map ends before the nearest place that cannot be followed", "[.long][plane]") {
    const std::string text = "f''' = -f*f'' - 1/2*(1-f'^2); f(0) = 0; f'(0) = 0; f''(0) = 9/10";
    const auto map = map_of(text);
    REQUIRE_FALSE(map.all.empty());
    CHECK(static_cast<double>(map.all.front().offset.re) == Approx(-3.545731774386213));
    CHECK(map.within < 2 * 3.5457);
    for (const found_singularity& each : map.all) {
        CHECK(static_cast<double>(modulus_of(each.offset)) <= map.within);
    }
}

}  // namespace plane_singularity_map_test
