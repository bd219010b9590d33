// Solutions with limits at infinity, and eigenvalues, through the C interface.

#include <catch2/catch.hpp>
#include <string>

#include "c/called.hpp"

namespace c_infinity_test {

using namespace c_test;

// y = sqrt 2 sech t.
TEST_CASE("conditions at infinity in C", "[c][proved]") {
    const char* const soliton = "y'' = y - y^3; y'(0) = 0; y(inf) = 0";
    const auto found = made<table>(
        [&](auto** to) { return libration_find_at_infinity(soliton, "y(0) = 1.4", 20, nullptr, nullptr, to); });
    REQUIRE(libration_table_rows(found.get()) == 3);
    CHECK(cell(found, 0, 0) == "y(0)");
    CHECK(cell(found, 0, 1) == "1.4142135623730950488");
    CHECK(cell(found, 0, 2) == "unknown");
    CHECK(cell(found, 1, 0) == "rate 1");
    CHECK(cell(found, 1, 2) == "rate");
    CHECK(cell(found, 2, 0) == "amplitude of y");
    CHECK(cell(found, 2, 1) == "2.8284271247461900976");
    CHECK(cell(found, 2, 2) == "amplitude");
    const auto states = made<table>([&](auto** to) {
        return libration_states_at_infinity(soliton, "y(0) = 1.4", "1, inf", 20, nullptr, nullptr, to);
    });
    CHECK(cell(states, 0, 1) == "0.91648714296931200255");
    CHECK(cell(states, 1, 1) == "0");
    const auto levels = made<table>([&](auto** to) {
        return libration_eigenvalues("psi'' = (x^2 - E)*psi; psi(-inf) = 0; psi(inf) = 0", "E", 2, 20, nullptr, nullptr,
                                     to);
    });
    CHECK(cell(levels, 1, 0) == "E_1");
    CHECK(cell(levels, 1, 1) == "3.0000000000000000000");
    libration_table* none = nullptr;
    CHECK(libration_find_at_infinity("y' = -y; y(0) = 1", nullptr, 10, nullptr, nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_eigenvalues("psi'' = (x^2 - E)*psi; psi(-inf) = 0; psi(inf) = 0", "E", 0, 10, nullptr, nullptr,
                                &none) == LIBRATION_ARGUMENT);
    CHECK(none == nullptr);
}

}  // namespace c_infinity_test
