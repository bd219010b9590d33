#include "libration/algebra/vandermonde.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace algebra_vandermonde_test {

using namespace libration;
using libration::tests::all_scalars;
using libration::tests::near;

TEST_CASE("a Vandermonde system over fractions gives back the coefficients it was made of", "[algebra][vandermonde]") {
    const std::vector<rational> nodes{1, 2, rational(7, 2), -5, rational(1, 3)};
    const std::vector<rational> a{rational(3, 7), -4, 0, rational(22, 5), 1};
    std::vector<rational> right;
    for (int n = 0; n < 5; ++n) {
        rational sum = 0;
        for (std::size_t j = 0; j < 5; ++j) {
            rational power = 1;
            for (int i = 0; i < n; ++i) {
                power *= nodes[j];
            }
            sum += a[j] * power;
        }
        right.push_back(sum);
    }
    CHECK(solve_vandermonde(nodes, right) == a);
    CHECK(solve_vandermonde(std::vector<rational>{}, std::vector<rational>{}).empty());
}

TEST_CASE("equal nodes and missing right sides of a Vandermonde system are refused", "[algebra][vandermonde]") {
    CHECK_THROWS_WITH(solve_vandermonde<double>({1, 2, 1}, {1, 1, 1}), Catch::Contains("are not distinct"));
    CHECK_THROWS_WITH(
        solve_vandermonde<double>({1, 2, 3}, {1, 1}),
        Catch::Contains("'2' is not the number of nodes, 3") || Catch::Contains("is not the number of nodes, 3"));
}

TEMPLATE_LIST_TEST_CASE("the condition of a Vandermonde system is the product of the norms", "[algebra][vandermonde]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // Nodes 1, 2, 3: rows 1 1 1 | 1 2 3 | 1 4 9, inverse 3 -5/2 1/2 | -3 4 -1 | 1 -3/2 1/2: 14 times 8.
    CHECK_THAT(vandermonde_condition(std::vector<T>{T(1), T(2), T(3)}), near(T(112), 30));
    CHECK_THAT(vandermonde_condition(std::vector<T>{T(5)}), near(T(1), 1));
}

}  // namespace algebra_vandermonde_test
