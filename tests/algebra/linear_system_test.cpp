#include "libration/algebra/linear_system.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace series_linear_system_test {

using namespace libration;

TEST_CASE("linear systems need their pivots", "[series][linear_system]") {
    // x + y = 3, 1e-20 scaled: 1e-20 x - 1e-20 y = -1e-20, and a zero in the first place.
    const auto x = *solve_linear<double>({{0, 1, 1}, {1e-20, -1e-20, 0}, {1, 1, 1}}, {5, -1e-20, 6}, 1e-14);
    CHECK(x[0] == Approx(1));
    CHECK(x[1] == Approx(2));
    CHECK(x[2] == Approx(3));
    CHECK_FALSE(solve_linear<double>({{1, 2}, {2, 4}}, {1, 2}, 1e-14));
    CHECK_FALSE(solve_linear<double>({{0, 0}, {2, 4}}, {1, 2}, 1e-14));
    CHECK(solve_linear<double>({}, {}, 1e-14)->empty());
}

TEST_CASE("a growing system solves what its equations share once", "[series][linear_system]") {
    growing_system<double> system(3, 1e-14);
    REQUIRE(system.add({0, 1, 1, 5}));
    REQUIRE(system.add({1e-20, -1e-20, 0, -1e-20}));
    CHECK_FALSE(system.solution());
    REQUIRE(system.add({1, 1, 1, 6}));
    CHECK_FALSE(system.add({1, 0, 0, 1}));  // as many as unknowns already
    const auto x = *system.solution();
    CHECK(x[0] == Approx(1));
    CHECK(x[1] == Approx(2));
    CHECK(x[2] == Approx(3));
    // Back to the first two, x = y - 1 and y + z = 5, with another third: z = 1.
    system.keep(2);
    CHECK_FALSE(system.add({1e-20, 1e-20, 2e-20, 9e-20}));  // twice the first and the second
    REQUIRE(system.add({0, 0, 1, 1}));
    const auto y = *system.solution();
    CHECK(y[0] == Approx(3));
    CHECK(y[1] == Approx(4));
    CHECK(y[2] == Approx(1));
    CHECK(growing_system<double>(0, 1e-14).solution()->empty());
}

TEST_CASE("systems that slide over a sequence have solutions of all their equations", "[series][linear_system]") {
    // Equations k: x_0 u_k + x_1 u_{k-1} + x_2 u_{k-2} = v_k of sequences that no recurrence makes.
    const auto row_at = [](int k) {
        const auto u = [](int n) { return std::cos(n * n); };
        return std::vector<double>{u(k), u(k - 1), u(k - 2), std::sin(3 * k * k)};
    };
    sliding_systems systems(3, 1e-14, row_at);
    // Neighbours, some that share nothing, one twice, in no order.
    for (const std::vector<int>& lasts :
         {std::vector<int>{50, 49, 48, 47, 40, 30}, std::vector<int>{20, 19, 18, 17, 18, 16},
          std::vector<int>{7, 30, 8, 7}, std::vector<int>{9}, std::vector<int>{}}) {
        std::vector<std::vector<double>> found;
        CHECK(systems.solve(lasts, [&](const std::vector<double>& x) {
            found.push_back(x);
            return true;
        }));
        REQUIRE(found.size() == lasts.size());
        for (std::size_t i = 0; i < lasts.size(); ++i) {
            for (int k = lasts[i] - 2; k <= lasts[i]; ++k) {
                const auto row = row_at(k);
                double left = row[3];
                double size = 0;
                for (std::size_t j = 0; j < 3; ++j) {
                    left -= row[j] * found[i][j];
                    size = std::max(size, std::abs(found[i][j]));
                }
                INFO(lasts[i] << " " << k);
                // Wilkinson's n^3 times the growth of entries, 2^(n-1), n = 3; no entry is above 1.
                CHECK(std::abs(left) <= 108 * epsilon<double>() * (size + 1));
            }
        }
    }
    // It ends where the caller has seen enough, and where equations depend on each other.
    int seen = 0;
    CHECK_FALSE(systems.solve(std::vector<int>{50, 49, 48}, [&](const std::vector<double>&) { return ++seen < 2; }));
    CHECK(seen == 2);
    sliding_systems dependent(2, 1e-14, [](int k) { return std::vector<double>{1.0 * k, 2.0 * k, 1}; });
    CHECK_FALSE(dependent.solve(std::vector<int>{5}, [](const std::vector<double>&) { return true; }));
}

}  // namespace series_linear_system_test
