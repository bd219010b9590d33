// Fields on both sides of the line x = 0, whose solutions are those of one equation for x.
#include "libration/hybrid/sliding.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace hybrid_sliding_test {

using namespace libration::ode;

namespace {

// The branches above, on and below a surface, with the signs of the derivative of u on them.
std::vector<side_of_surface> branches(int above, std::optional<int> on, int below) {
    return {{1, above}, {0, on}, {-1, below}};
}

}  // namespace

TEST_CASE("fields that point to the surface slide, and those that point away leave it twice", "[hybrid]") {
    CHECK(failure_at_surface(branches(-1, 0, 1), 1, true) == mode_failure::sliding);   // x' = -sign(x)
    CHECK(failure_at_surface(branches(-1, 0, 1), 1, false) == mode_failure::sliding);  // and y' = sign(y)
    CHECK(failure_at_surface(branches(1, 0, -1), 1, true) == mode_failure::several);   // x' = sign(x)
    CHECK(failure_at_surface(branches(1, 0, -1), 2, true) == mode_failure::several);   // x'' = sign(x)
    CHECK(failure_at_surface(branches(1, 0, -1), 1, false) == mode_failure::undecided);
    CHECK(failure_at_surface(branches(-1, 0, 1), 2, true) == mode_failure::undecided);  // x'' = -sign(x) oscillates
    CHECK(failure_at_surface(branches(1, 1, 1), 1, true) == mode_failure::undecided);
}

TEST_CASE("a derivative without a sign on a side decides nothing, one on the surface itself is not needed",
          "[hybrid]") {
    CHECK(failure_at_surface({{1, -1}, {0, 0}, {-1, std::nullopt}}, 1, true) == mode_failure::undecided);
    CHECK(failure_at_surface(branches(-1, std::nullopt, 1), 1, true) == mode_failure::sliding);
}

TEST_CASE("messages name the surface", "[hybrid]") {
    CHECK(reason_of(mode_failure::sliding, "sign(x)") ==
          "the solution slides along the surface of `sign(x)`: both branches lead back to it");
}

}  // namespace hybrid_sliding_test
