// The formulas of theorems A and B on singularities made by hand, compared with binomial coefficients and with the example of
// docs/asymptotics.md.
#include "libration/asymptotics/singular_terms.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace asymptotics_singular_terms_test {

using namespace libration;
using namespace libration::ode;

namespace {

// sqrt(1 - t): c_1 = 1; with |c_j| <= 3 * 3^-j.
algebraic_point root(int last) {
    algebraic_point made;
    made.place = complex_ball(1);
    made.sheets = 2;
    made.pole = 0;
    for (int j = 0; j <= last; ++j) {
        made.coefficients.emplace_back(j == 1 ? 1 : 0);
    }
    made.reach = ball(3);
    made.size = ball(3);
    made.real = true;
    return made;
}

// Coefficient n of (1 - t)^(1/2).
ball binomial_of_root(long n) {
    ball a(1);
    for (long k = 1; k <= n; ++k) {
        a = a * (2 * (k - 1) - 1) / (2 * k);
    }
    return a;
}

}  // namespace

TEST_CASE("poles: 1/(1 - t), its square, and 1/(1 + t^2)", "[asymptotics][proved]") {
    const precision_scope scope(40);
    const pole_terms simple{complex_ball(1), {complex_ball(-1)}, true};
    const pole_terms twice{complex_ball(1), {complex_ball(0), complex_ball(1)}, true};
    const pole_terms pair{{ball(0), ball(1)}, {{ball(0), ball(-1) / 2}}, false};
    for (const long n : {0L, 1L, 2L, 3L, 100L}) {
        CHECK(contains(pole_coefficient(simple, n), ball(1)));
        CHECK(contains(pole_coefficient(twice, n), ball(n + 1)));
        CHECK(contains(pole_coefficient(pair, n), ball(n % 2 != 0 ? 0 : n % 4 == 0 ? 1 : -1)));
    }
    CHECK(contains(pole_coefficient(simple, 1'000'000), ball(1)));
}

TEST_CASE("a square root: the terms are exact, and the bound is that of the example", "[asymptotics][proved]") {
    const precision_scope scope(40);
    const branch_terms known(root(1), 2);
    for (const long n : {3L, 10L, 200L}) {
        CHECK(overlaps(known.coefficient(n, 1), binomial_of_root(n)));
    }
    // J = 0: all of a_10 = -0.00927 is in the bound, 0.01043 + 0; here with c_1 known it is |c_1|/pi Gamma(3/2) Gamma(19/2)/10! plus
    // the rest beyond.
    const branch_terms unknown(root(0), 2);
    const ball bound = unknown.bound(10, 0);
    CHECK(certainly_less(abs(bound - from_rational<ball>(rational(1043, 100'000))),
                         from_rational<ball>(rational(1, 100'000))));
    CHECK(certainly_less(abs(binomial_of_root(10)), bound));
    const ball closer = known.bound(10, 0);
    CHECK(certainly_less(abs(binomial_of_root(10)), closer));
}

// d = 1: n > (J/2)(1 + d)/d = J; for d = 1/2 n > 3J/2; and n > J_1/2.
TEST_CASE("the least index of the bound", "[asymptotics][proved]") {
    const precision_scope scope(40);
    CHECK(branch_terms(root(20), 2).first(9) == 10);
    CHECK(branch_terms(root(20), 1.5).first(9) == 14);
    CHECK(branch_terms(root(20), 8).first(0) == 1);
    CHECK_THROWS_AS(branch_terms(root(20), 10.5), precision_exhausted);  // d > reach^2
    CHECK_THROWS_AS(branch_terms(root(20), 1), precision_exhausted);     // the circle passes through it
    CHECK_THROWS_AS(branch_terms(root(20), 2).bound(4, 9), precision_exhausted);
}

// The bound decreases where the terms do: it holds for a function with the terms c_1 and c_3 when only c_1 is used.
TEST_CASE("the bound contains what is left out", "[asymptotics][proved]") {
    const precision_scope scope(40);
    algebraic_point both = root(12);
    both.coefficients[3] = complex_ball(ball(1) / 9);
    const branch_terms terms(both, 2);
    for (const long n : {20L, 50L, 300L}) {
        const ball all = terms.coefficient(n, 12);
        const ball less = terms.coefficient(n, 1);
        CHECK(certainly_less(abs(all - less), ball(terms.bound(n, 1) + terms.bound(n, 12))));
        CHECK(certainly_less(terms.bound(n, 12), terms.bound(n, 1)));
        const auto uniform = terms.uniform(9);
        const ball at = uniform.circle * pow(ball(2), -n) + uniform.slit * gamma_quotient(n, uniform.index, 2);
        CHECK(certainly_less(terms.bound(n, 9), ball(at * (ball(1) + pow(ball(2), -20L)))));
    }
}

}  // namespace asymptotics_singular_terms_test
