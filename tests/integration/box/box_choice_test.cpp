// Which of the theorems G and V continues, for growths of the radii that are clearly on one side.
#include "libration/integration/box/box_choice.hpp"

#include <catch2/catch.hpp>

namespace integration_box_choice_test {

using namespace libration::ode;

namespace {

// After ten steps over a distance, 1 unless given, in which the radii grow by so many bits.
bool prefers_columns(std::size_t unknowns, double growth, double rest, double way = 1) {
    box_choice choice(unknowns, 3 * unknowns);
    for (int step = 0; step < 11; ++step) {
        choice.add(growth / 10, way / 10, 100);
    }
    return choice.prefers_columns(rest);
}

}  // namespace

TEST_CASE("box choice: radii that hardly grow need no derivative of the flow") {
    CHECK_FALSE(prefers_columns(12, 10, 1));
    CHECK_FALSE(prefers_columns(50, 5, 20));
    CHECK_FALSE(prefers_columns(50, -5, 1000));
}

TEST_CASE("box choice: radii that grow by thousands of bits do") {
    CHECK(prefers_columns(12, 1000, 900, 100));
    CHECK(prefers_columns(50, 5000, 9000, 1000));
}

TEST_CASE("box choice: a growth at the beginning is not taken for that of the whole way") {
    CHECK_FALSE(prefers_columns(28, 2, 1, 1e-3));
    CHECK_FALSE(prefers_columns(50, 5, 10000));
}

TEST_CASE("box choice: hundreds of unknowns never do") { CHECK_FALSE(prefers_columns(400, 10, 10000)); }

}  // namespace integration_box_choice_test
