// Products in double contain the products of all matrices of their operands; the matrix of Newton's method is
// inverted.
#include "libration/algebra/rounded_matrix.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "libration/integration/collocation/collocation_matrix.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace algebra_rounded_matrix_test {

using namespace libration;
using namespace libration::ode;

namespace {

ball power_of_2(long e) {
    ball result(1);
    arb_mul_2exp_si(result.handle(), result.handle(), e);
    return result;
}

// Half of them corner cases: runs of ones that double holds or does not hold, powers of two far apart, and zeros.
ball any_entry(std::mt19937_64& random) {
    const long sign = random() % 2 == 0 ? 1 : -1;
    switch (random() % 10) {
        case 0: return power_of_2(53) - ball(1);
        case 1: return (ball(1) - power_of_2(-200)) * sign;
        case 2: return (power_of_2(54) - ball(1)) * power_of_2(-54) * sign;
        case 3: return power_of_2(static_cast<long>(random() % 200) - 100) * sign;
        case 4: return ball(0);
        default:
            return ball(static_cast<long>(random() >> 2)) * power_of_2(-62) * ball(static_cast<long>(random() >> 2)) *
                   sign;
    }
}

dense_matrix any_matrix(std::size_t rows, std::size_t columns, std::mt19937_64& random) {
    dense_matrix result(rows, columns);
    for (ball& each : result.entries) {
        each = any_entry(random);
    }
    return result;
}

dense_matrix with_radii(dense_matrix a, std::mt19937_64& random) {
    for (ball& each : a.entries) {
        if (random() % 2 == 0) {
            each = enclose(each, power_of_2(static_cast<long>(random() % 80) - 60));
        }
    }
    return a;
}

// A matrix of the ball matrix, at the ends of its entries.
dense_matrix at_ends(dense_matrix a, std::mt19937_64& random) {
    for (ball& each : a.entries) {
        each = random() % 2 == 0 ? lower_bound(each) : upper_bound(each);
    }
    return a;
}

bool encloses(const dense_matrix& found, const dense_matrix& exact) {
    for (std::size_t i = 0; i < found.entries.size(); ++i) {
        if (arb_contains(found.entries[i].handle(), exact.entries[i].handle()) == 0) {
            return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("a product in double contains the products of the matrices of balls", "[ode][proved]") {
    const precision_scope scope(600);  // more than the products of these entries need
    std::mt19937_64 random(7);
    for (const std::size_t inner : {1, 2, 3, 17, 60}) {
        for (int tried = 0; tried < 40; ++tried) {
            const dense_matrix a =
                tried % 2 == 0 ? any_matrix(3, inner, random) : with_radii(any_matrix(3, inner, random), random);
            const dense_matrix b =
                tried % 4 < 2 ? any_matrix(inner, 4, random) : with_radii(any_matrix(inner, 4, random), random);
            const rounded_matrix left(a);
            const rounded_matrix right(b);
            CHECK(encloses(product(left, right).balls(), product(at_ends(a, random), at_ends(b, random))));
            CHECK(encloses(left.balls(), at_ends(a, random)));
        }
    }
}

// Double holds neither 1 + 2^-53 + 2^-105 nor 1 - 2^-53 - 2^-105, nor three times the double nearest to 1/3.
TEST_CASE("rounding errors of sums and products in double are bounded", "[ode][proved]") {
    const precision_scope scope(100);
    const dense_matrix ones(1, 2, {ball(1), ball(1)});
    const ball little = power_of_2(-53) + power_of_2(-105);
    const dense_matrix terms(2, 1, {ball(1), little});
    const ball sum = product(rounded_matrix(ones), rounded_matrix(terms)).entry(0, 0);
    CHECK(arb_contains(sum.handle(), (ball(1) + little).handle()) != 0);
    CHECK(certainly_less(radius_of(sum), power_of_2(-48)));
    const rounded_matrix a(1, 1, {ball(1)});
    const rounded_matrix b(1, 1, {little});
    CHECK(arb_contains(ode::sum(a, b).entry(0, 0).handle(), (ball(1) + little).handle()) != 0);
    CHECK(arb_contains(difference(a, b).entry(0, 0).handle(), (ball(1) - little).handle()) != 0);
    const ball third = exactly(1.0 / 3);
    const ball one = product(rounded_matrix(1, 1, {third}), rounded_matrix(1, 1, {ball(3)})).entry(0, 0);
    CHECK(arb_contains(one.handle(), (third * 3L).handle()) != 0);
    CHECK(certainly_less(radius_of(one), power_of_2(-48)));
}

TEST_CASE("a product in double that underflows is bounded, and one that overflows is without bounds", "[ode][proved]") {
    const precision_scope scope(100);
    const ball small = power_of_2(-600);
    const ball square = product(rounded_matrix(1, 1, {small}), rounded_matrix(1, 1, {small})).entry(0, 0);
    CHECK(arb_contains(square.handle(), (small * small).handle()) != 0);
    CHECK(certainly_less(radius_of(square), power_of_2(-1000)));
    const ball large = power_of_2(600);
    CHECK(!is_finite(product(rounded_matrix(1, 1, {large}), rounded_matrix(1, 1, {large})).entry(0, 0)));
    CHECK(!is_finite(rounded_matrix(1, 1, {power_of_2(2000)}).entry(0, 0)));
    CHECK(contains_zero(rounded_matrix(1, 1, {power_of_2(-2000)}).entry(0, 0)));
}

// 51 nodes times 50 modes are more than are factored as a whole. A slow block of four, two of two, and others of one.
TEST_CASE("the matrix of Newton's method is inverted by blocks and refinement", "[ode][proved]") {
    constexpr std::size_t nodes = 51;
    constexpr std::size_t modes = 50;
    std::mt19937_64 random(3);
    const auto any = [&](double size) { return size * std::uniform_real_distribution<double>(-1, 1)(random); };
    std::vector<double> integrals;
    for (std::size_t i = 0; i < nodes * nodes; ++i) {
        integrals.push_back(any(1.0 / nodes));
    }
    std::vector<std::vector<double>> jacobians(nodes);
    for (auto& each : jacobians) {
        for (std::size_t i = 0; i < modes * modes; ++i) {
            each.push_back(i % (modes + 1) == 0 ? -2.0 - static_cast<double>(i % 7) : any(0.05));
        }
    }
    std::vector<std::size_t> blocks{4, 2, 2};
    blocks.resize(3 + modes - 8, 1);
    collocation_matrix matrix;
    REQUIRE(matrix.factor(integrals, jacobians, blocks));
    constexpr std::size_t columns = 2;
    std::vector<double> right;
    for (std::size_t i = 0; i < nodes * modes * columns; ++i) {
        right.push_back(any(1));
    }
    const auto check = [&] {
        const auto x = matrix.solved(right, columns);
        double most = 0;
        for (std::size_t row = 0; row < nodes * modes; ++row) {
            for (std::size_t j = 0; j < columns; ++j) {
                double sum = x[row * columns + j];
                for (std::size_t k = 0; k < nodes; ++k) {
                    for (std::size_t c = 0; c < modes; ++c) {
                        sum -= integrals[row / modes * nodes + k] * jacobians[k][row % modes * modes + c] *
                               x[(k * modes + c) * columns + j];
                    }
                }
                most = std::max(most, std::fabs(sum - right[row * columns + j]));
            }
        }
        // The last correction is at most 1e-9 of the solution, and the norm of the matrix below 12: 1 + (9 + 50/20).
        const double largest = std::fabs(*std::ranges::max_element(x, {}, [](double each) { return std::fabs(each); }));
        CHECK(most < 12e-9 * largest);
    };
    check();
    for (auto& each : jacobians) {
        each[1] = 0.5;
    }
    REQUIRE(matrix.update(jacobians));
    check();
}

}  // namespace algebra_rounded_matrix_test
