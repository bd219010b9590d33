// Coefficients of placed steps are those of the stated sums to the last bit, also of numbers that are not normal.
#include "libration/expansion/step_kernels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/placed_steps.hpp"

namespace expansion_step_kernels_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr int most = 31;

using numbers = std::vector<double>;

bool same(double a, double b) {
    return std::isnan(a) ? std::isnan(b) : std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// The definition: inner term i in partial sum i mod 4, the first and the last term at the end.
double plain_sum(const double* a, const double* b, int n, int first, int last) {
    if (first > last) {
        return 0;
    }
    if (first == last) {
        return a[first] * b[n - first];
    }
    std::array<double, 4> sums{};
    for (int k = first + 1; k < last; ++k) {
        sums[static_cast<std::size_t>(k - first - 1) % 4] += a[k] * b[n - k];
    }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + (a[first] * b[n - first] + a[last] * b[n - last]);
}

double plain_square(const double* a, int n, int first) {
    const double half = plain_sum(a, a, n, first, (n + 1) / 2 - 1);
    return n % 2 == 0 && n >= 2 * first ? half + half + a[n / 2] * a[n / 2] : half + half;
}

// Every third one of a kind, the others between 1/2 and 2.
numbers with_some(double kind, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> size(0.5, 2);
    numbers all(most + 2);
    for (double& each : all) {
        each = generator() % 3 == 0 ? kind : (generator() % 2 == 0 ? size(generator) : -size(generator));
    }
    return all;
}

struct arrays {
    numbers a, b, r, behind, integral;
};

placed_step<double> step_of(coefficient_rule rule, newest_operand newest, arrays& of) {
    return {rule,       newest, 0, of.r.data(), of.a.data(), of.b.data(), 0.75, 3, of.integral.data(), of.behind.data(),
            of.a.data()};
}

// A step whose result is the operand that is the newest, and the one that uses it.
double coefficient_by_kernel(coefficient_rule rule, newest_operand newest, arrays& of, int n) {
    std::vector<placed_step<double>> steps;
    numbers zero(most + 2, -0.0);
    numbers other = newest == newest_operand::b ? of.b : of.a;
    if (newest != newest_operand::none) {
        numbers& into = newest == newest_operand::b ? of.b : of.a;
        steps.push_back({coefficient_rule::linear, newest_operand::none, 0, into.data(), other.data(), zero.data(), 1,
                         1, nullptr, nullptr, nullptr});
    }
    steps.push_back(step_of(rule, newest, of));
    run_steps<double>(steps, {}, n, n, {});
    return of.r[static_cast<std::size_t>(n)];
}

double coefficient_by_definition(coefficient_rule rule, const arrays& of, int n) {
    const double* const a = of.a.data();
    const double* const b = of.b.data();
    const double* const r = of.r.data();
    switch (rule) {
        case coefficient_rule::linear: return a[n] * 0.75 + b[n] * 3;
        case coefficient_rule::product: return plain_sum(a, b, n, 0, n);
        case coefficient_rule::square: return plain_square(a, n, 0);
        case coefficient_rule::quotient: return (a[n] - plain_sum(b, r, n, 1, n)) / b[0];
        case coefficient_rule::square_root: return (a[n] - plain_square(r, n, 1)) / of.behind[0];
        case coefficient_rule::fraction: return a[n] * 0.75 / 3;
        case coefficient_rule::raised: return n == 0 ? a[0] + 0.75 : a[n];
        case coefficient_rule::primitive: return plain_sum(b, a, n - 1, 0, n - 1) / n;
        case coefficient_rule::constant:
        case coefficient_rule::slope:
        case coefficient_rule::power:
        case coefficient_rule::sine_cosine:
        case coefficient_rule::otherwise: break;
    }
    return 0;
}

}  // namespace

TEST_CASE("coefficients of placed steps are those of the stated sums to the last bit", "[ode]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double> kinds{1.5,   0.0,      -0.0,      std::numeric_limits<double>::denorm_min(), 1e-200,
                                    1e200, infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
    for (const auto rule : {coefficient_rule::linear, coefficient_rule::product, coefficient_rule::square,
                            coefficient_rule::quotient, coefficient_rule::square_root, coefficient_rule::fraction,
                            coefficient_rule::raised, coefficient_rule::primitive}) {
        const bool begins = rule != coefficient_rule::square_root && rule != coefficient_rule::primitive;
        for (const double kind : kinds) {
            for (const auto newest : {newest_operand::none, newest_operand::a, newest_operand::b}) {
                for (int n = begins ? 0 : 1; n <= most; ++n) {
                    arrays of{with_some(kind, 1), with_some(kind, 2), with_some(kind, 3), with_some(1.5, 4),
                              numbers(most + 2, 0)};
                    const double expected = coefficient_by_definition(rule, of, n);
                    const double found = coefficient_by_kernel(rule, newest, of, n);
                    INFO("rule " << static_cast<int>(rule) << ", kind " << kind << ", newest "
                                 << static_cast<int>(newest) << ", n = " << n);
                    REQUIRE(same(found, expected));
                    REQUIRE(same(of.integral[static_cast<std::size_t>(n + 1)], expected / (n + 1)));
                }
            }
        }
    }
}

TEST_CASE("slopes, constants, integrals and other steps are run in their order", "[ode]") {
    arrays of{with_some(1.5, 1), with_some(1.5, 2), with_some(1.5, 3), with_some(1.5, 4), numbers(most + 2, 7)};
    const std::vector<placed_integral<double>> integrals{{of.integral.data(), of.a.data()}};
    std::vector<placed_step<double>> steps{{coefficient_rule::slope, newest_operand::none, 3, of.r.data(), of.a.data(),
                                            nullptr, 0, 0, nullptr, nullptr, nullptr},
                                           {coefficient_rule::otherwise, newest_operand::none, 4, of.b.data(), nullptr,
                                            nullptr, 0, 0, nullptr, nullptr, nullptr},
                                           {coefficient_rule::constant, newest_operand::none, 5, of.behind.data(),
                                            nullptr, nullptr, 2.5, 0, nullptr, nullptr, nullptr}};
    std::vector<std::pair<int, int>> calls;
    run_steps<double>(steps, integrals, 0, 3, [&](int index, int n) { calls.emplace_back(index, n); });
    CHECK(calls == std::vector<std::pair<int, int>>{{4, 0}, {4, 1}, {4, 2}, {4, 3}});
    CHECK(of.behind[0] == 2.5);
    CHECK(of.behind[1] == 0);
    CHECK(of.integral[0] == 7);
    for (std::size_t n = 0; n < 3; ++n) {
        CHECK(of.r[n] == of.a[n + 1] * static_cast<double>(n + 1));
        CHECK(of.integral[n + 1] == of.a[n] / static_cast<double>(n + 1));
    }
    CHECK(of.integral[5] == 7);
}

TEST_CASE("several polynomials are evaluated as one after the other", "[ode]") {
    for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 9U}) {
        std::vector<numbers> all;
        for (std::size_t i = 0; i < count; ++i) {
            all.push_back(with_some(1e-310, static_cast<unsigned>(i)));
        }
        numbers found(count);
        polynomial_values<double> several(most, -0.7);
        for (std::size_t i = 0; i < count; ++i) {
            several.add(all[i].data(), found[i]);
        }
        several.end();
        for (std::size_t i = 0; i < count; ++i) {
            double value = all[i][most];
            for (std::size_t n = most; n-- > 0;) {
                value = value * -0.7 + all[i][n];
            }
            CHECK(same(found[i], value));
        }
    }
}

TEST_CASE("steps in chains come after their operands, and follow them where they can", "[ode]") {
    const tape lorenz = tape::about_points(
        explicit_system(parse("x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z; x(0) = 1; y(0) = 0; z(0) = 0")));
    const tape mixed = tape::about_points(explicit_system(
        parse("x'' = -sin(x)*x' + cos(y)/x^3; y' = exp(-x^2)/(2 + y) + t; x(0) = 2; x'(0) = 0; y(0) = 1")));
    for (const tape* of : {&lorenz, &mixed}) {
        const std::vector<int> order = steps_in_chains(*of);
        std::vector<bool> known;
        std::size_t computed = 0;
        for (const tape_step& each : of->steps()) {
            known.push_back(each.kind == operation::state);
            computed += each.kind != operation::state && each.kind != operation::companion ? 1 : 0;
        }
        CHECK(order.size() == computed);
        for (const int i : order) {
            const tape_step& each = of->steps()[static_cast<std::size_t>(i)];
            for (const int operand : {each.left, each.right}) {
                CHECK((operand < 0 || known[static_cast<std::size_t>(operand)]));
            }
            CHECK_FALSE(known[static_cast<std::size_t>(i)]);
            known[static_cast<std::size_t>(i)] = true;
            for (std::size_t j = static_cast<std::size_t>(i) + 1;
                 j < of->steps().size() && of->steps()[j].kind == operation::companion; ++j) {
                known[j] = true;
            }
        }
    }
    // 10 (y - x), x (28 - z) - y, -8/3 z + x y: each step but the first of a chain uses the one before.
    const std::vector<int> order = steps_in_chains(lorenz);
    const auto uses = [&](std::size_t i) {
        const tape_step& each = lorenz.steps()[static_cast<std::size_t>(order[i])];
        return each.left == order[i - 1] || each.right == order[i - 1] ? 1 : 0;
    };
    int chained = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        chained += uses(i);
    }
    CHECK(chained >= 5);
}

}  // namespace expansion_step_kernels_test
