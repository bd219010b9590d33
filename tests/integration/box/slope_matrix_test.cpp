// The growth of radii by a comparison system, against closed forms of the exponential of its matrix, and bounds of slopes
// against ranges by hand.
#include "libration/integration/box/slope_matrix.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/box/slope_bounds.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace integration_box_slope_matrix_test {

using namespace libration;
using namespace libration::ode;

namespace {

// A matrix of integers, by its rows.
slope_matrix matrix_of(const std::vector<std::vector<int>>& rows) {
    slope_matrix made;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        made.diagonal.emplace_back(rows[i][i]);
        for (std::size_t j = 0; j < rows.size(); ++j) {
            if (j != i && rows[i][j] != 0) {
                made.columns.push_back(j);
                made.beside.emplace_back(ball(rows[i][j]));
            }
        }
        made.first.push_back(made.columns.size());
    }
    return made;
}

std::vector<magnitude> whole_numbers(const std::vector<unsigned long>& all) {
    std::vector<magnitude> result;
    for (const unsigned long each : all) {
        result.emplace_back(each);
    }
    return result;
}

std::vector<magnitude> ones(std::size_t size) { return std::vector<magnitude>(size, magnitude(1U)); }

// At least the value, and at most 0.1 % more.
void check_bound(const magnitude& bound, double value) {
    CAPTURE(bound.above(), value);
    CHECK(bound.above() >= value * (1 - 1e-15));
    CHECK(bound.above() <= value * (1 + 1e-3));
}

}  // namespace

TEST_CASE("box: radii grow as the exponential of the comparison system") {
    const auto of = matrix_of({{-10, 40}, {0, -10}});
    const auto radii = grown(of, whole_numbers({0, 10}), magnitude(1U), ones(2));
    REQUIRE(radii);
    check_bound(radii->last[0], 400 * std::exp(-10.0));
    check_bound(radii->last[1], 10 * std::exp(-10.0));
    // r_1(t) = 400 t exp(-10 t) is largest at t = 1/10, within the interval.
    CHECK(radii->most[0].above() >= 40 / std::exp(1.0));
    CHECK(radii->most[1].above() >= 10);
}

TEST_CASE("box: unknowns that decay and grow keep their rates") {
    const auto radii = grown(matrix_of({{-10, 0}, {0, 1}}), whole_numbers({1, 1}), magnitude(1U), ones(2));
    REQUIRE(radii);
    check_bound(radii->last[0], std::exp(-10.0));
    check_bound(radii->last[1], std::exp(1.0));
}

TEST_CASE("box: a rotation grows as a hyperbolic rotation") {
    const auto of = matrix_of({{0, 1}, {1, 0}});
    for (const unsigned long length : {1UL, 3UL, 20UL}) {
        const auto radii = grown(of, whole_numbers({1, 0}), magnitude(length), ones(2));
        REQUIRE(radii);
        check_bound(radii->last[0], std::cosh(static_cast<double>(length)));
        check_bound(radii->last[1], std::sinh(static_cast<double>(length)));
    }
}

TEST_CASE("box: a chain of unknowns passes an error on, and nothing is passed back") {
    // r_k' = r_(k-1): r_k(t) = t^(k-3)/(k-3)! from the third one on; the first two are exact.
    const std::size_t size = 12;
    std::vector<std::vector<int>> rows(size, std::vector<int>(size, 0));
    for (std::size_t k = 1; k < size; ++k) {
        rows[k][k - 1] = 1;
    }
    std::vector<unsigned long> start(size, 0);
    start[2] = 1;
    const auto radii = grown(matrix_of(rows), whole_numbers(start), magnitude(2U), ones(size));
    REQUIRE(radii);
    CHECK(radii->most[0].is_zero());
    CHECK(radii->most[1].is_zero());
    double term = 1;
    for (std::size_t k = 2; k < size; ++k) {
        check_bound(radii->last[k], term);
        term *= 2.0 / static_cast<double>(k - 1);
    }
}

TEST_CASE("box: weights of different sizes leave the smaller errors small") {
    // Two unknowns of sizes 1 and 2^-200 that do not influence each other.
    const std::vector<magnitude> weights{magnitude(1U), magnitude::of(1, -200)};
    const std::vector<magnitude> start{magnitude::of(1, -50), magnitude::of(1, -300)};
    const auto radii = grown(matrix_of({{1, 0}, {0, 1}}), start, magnitude(1U), weights);
    REQUIRE(radii);
    check_bound(radii->last[0].shifted(50), std::exp(1.0));
    CHECK(radii->last[1].shifted(300).above() < 2 * std::exp(1.0));
    CHECK(radii->last[1].shifted(300).above() >= std::exp(1.0));
}

TEST_CASE("box: bounds that are not finite, and intervals that are too long, have no radii") {
    auto of = matrix_of({{0, 1}, {1, 0}});
    CHECK_FALSE(grown(of, ones(2), magnitude(1000U), ones(2)));
    of.beside[0] = magnitude(1U) / magnitude();
    CHECK_FALSE(grown(of, ones(2), magnitude(1U), ones(2)));
    CHECK_FALSE(
        grown(matrix_of({{0, 1}, {1, 0}}), {magnitude(1U) / magnitude(), magnitude(1U)}, magnitude(1U), ones(2)));
}

TEST_CASE("box: slopes have the upper ends of the diagonal, backwards of its negative") {
    const explicit_system system(parse("x' = -x^2 + 3*y; y' = x*y - z; z' = 5; x(0) = 1; y(0) = 0; z(0) = 0"));
    slope_bounds slopes(system);
    const precision_scope scope(20);
    const ball x = hull(ball(1), ball(3));
    const ball y = hull(ball(-2), ball(1));
    const auto at = [&](int direction) {
        const auto found = slopes.over(ball(0), {x, y, ball(0)}, direction);
        REQUIRE(found);
        return *found;
    };
    // d(-x^2 + 3y)/dx = -2x in [-6, -2], d(x y)/dy = x in [1, 3].
    const slope_matrix forward = at(1);
    CHECK(midpoint_of(forward.diagonal[0]).convert_to<double>() == Approx(-2).epsilon(1e-8));
    CHECK(midpoint_of(forward.diagonal[1]).convert_to<double>() == Approx(3).epsilon(1e-8));
    CHECK(arb_is_zero(forward.diagonal[2].handle()) != 0);
    const slope_matrix backward = at(-1);
    CHECK(midpoint_of(backward.diagonal[0]).convert_to<double>() == Approx(6).epsilon(1e-8));
    CHECK(midpoint_of(backward.diagonal[1]).convert_to<double>() == Approx(-1).epsilon(1e-8));
    // Beside it: 3; |y| <= 2 and 1; nothing for the constant slope.
    CHECK(forward.first == std::vector<std::size_t>{0, 1, 3, 3});
    CHECK(forward.columns == std::vector<std::size_t>{1, 0, 2});
    CHECK(forward.beside[0].above() == Approx(3).epsilon(1e-8));
    CHECK(forward.beside[1].above() == Approx(2).epsilon(1e-8));
    CHECK(forward.beside[2].above() == Approx(1).epsilon(1e-8));
}

TEST_CASE("box: slopes outside of the domain of a function are not bounded") {
    const explicit_system system(parse("x' = sqrt(x); y' = 1/y; x(0) = 1; y(0) = 1"));
    slope_bounds slopes(system);
    const precision_scope scope(20);
    CHECK(slopes.over(ball(0), {hull(ball(1), ball(2)), ball(1)}, 1));
    CHECK_FALSE(slopes.over(ball(0), {hull(ball(0), ball(2)), ball(1)}, 1));
    CHECK_FALSE(slopes.over(ball(0), {ball(1), hull(ball(-1), ball(1))}, 1));
}

}  // namespace integration_box_slope_matrix_test
