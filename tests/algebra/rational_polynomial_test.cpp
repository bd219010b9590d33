// Factors, roots and inverses of polynomials with rational coefficients.
#include "libration/algebra/rational_polynomial.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace algebra_rational_polynomial_test {

using namespace libration;

namespace {

rational_polynomial made(const std::vector<rational>& coefficients) { return {coefficients}; }

}  // namespace

TEST_CASE("products are factored again, with multiplicities", "[algebra]") {
    const auto root = made({rational(-1, 2), 1});
    const auto square = made({-2, 0, 1});
    int found = 0;
    for (const auto& [factor, multiplicity] : irreducible_factors(root * root * square * rational(6))) {
        found += factor == root && multiplicity == 2 ? 1 : 0;
        found += factor == square && multiplicity == 1 ? 1 : 0;
    }
    CHECK(found == 2);
    CHECK(irreducible_factors(made({7})).empty());
}

TEST_CASE("division, common divisors and derivatives", "[algebra]") {
    const auto a = made({1, 2, 3, 4});
    const auto b = made({rational(1, 3), 0, 5});
    const auto by = divided(a, b);
    CHECK(by.quotient * b + by.rest == a);
    CHECK(by.rest.degree() < b.degree());
    CHECK(common_divisor(a * b, b * made({1, 1})) == b * rational(1, 5));
    CHECK(common_divisor({}, {}).is_zero());
    CHECK(a.taylor_coefficient(2) == made({3, 12}));
    CHECK_THROWS_AS(divided(a, {}), error);
}

// 1/(1 + sqrt 2) = sqrt 2 - 1.
TEST_CASE("inverses in a number field", "[algebra]") {
    const number_field field(made({-2, 0, 1}));
    CHECK(field.inverse(made({1, 1})) == made({-1, 1}));
    CHECK_THROWS_AS(field.inverse({}), error);
}

TEST_CASE("roots in disjoint balls, real ones real", "[algebra][proved]") {
    const precision_scope scope(40);
    const auto roots = enclosed_roots(made({-2, 0, 0, 1}));  // t^3 = 2
    REQUIRE(roots.size() == 3);
    int real = 0;
    for (const auto& each : roots) {
        real += is_exact(each.im) && contains_zero(each.im) ? 1 : 0;
        const auto cube = each * each * each;
        CHECK(contains(cube.re, ball(2)));
        CHECK(certainly_less(radius_of(each.re), pow(ball(10), -35L)));
    }
    CHECK(real == 1);
}

}  // namespace algebra_rational_polynomial_test
