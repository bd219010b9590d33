// Problems with events, piecewise right-hand sides and delays in the C interface, compared with closed forms.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "c/called.hpp"

namespace c_test {

TEST_CASE("a bouncing ball from C", "[c][hybrid]") {
    // It falls from 1 to 0 at t = 1, and leaves with the speed 1: x = s - s^2, s = t - 1, up to t = 2.
    const auto bouncing = problem_of("x'' = -2; x(0) = 1; x'(0) = 0; when x = 0 down: x' = -x'/2");
    REQUIRE(libration_problem_size(bouncing.get()) == 2);
    CHECK(libration_problem_name(bouncing.get(), 1) == std::string("x'"));
    const auto states = made<table>([&](auto** to) {
        return libration_problem_states(bouncing.get(), "1/2,3/2", 20, LIBRATION_PROVED, nullptr, nullptr, to);
    });
    CHECK(cell(states, 0, 1) == "0.75000000000000000000");
    CHECK(cell(states, 1, 1) == "0.25000000000000000000");
    const auto bounces =
        made<table>([&](auto** to) { return libration_problem_events(bouncing.get(), "x = 0", 2, 20, to); });
    CHECK(cell(bounces, 0, 0) == "1.0000000000000000000");
    CHECK(cell(bounces, 1, 0) == "2.0000000000000000000");
    // From h it falls to 0 at u = sqrt(h): x = u s - s^2, s = t - u.
    const auto by = made<table>([&](auto** to) {
        return libration_problem_derivatives(bouncing.get(), "3/2", "x(0)", 20, nullptr, nullptr, to);
    });
    CHECK(cell(by, 0, 3) == "0.25000000000000000000");
    // In double the bounces accumulate at t = 3, beyond which there is no solution.
    const std::array<double, 3> times{0.5, 1.25, 4};
    std::array<double, 6> values{};
    REQUIRE(libration_problem_flow(bouncing.get(), 0, 1, nullptr, 3, times.data(), nullptr, nullptr, values.data()) ==
            LIBRATION_OK);
    constexpr double tolerance = 100 * std::numeric_limits<double>::epsilon();  // some operations in a step
    CHECK(std::abs(values[0] - 0.75) <= tolerance);
    CHECK(std::abs(values[2] - 0.1875) <= tolerance);
    CHECK(std::abs(values[3] - 0.5) <= tolerance);
    CHECK(std::isnan(values[4]));
    // From other states it would need their branch.
    CHECK(libration_problem_flow(bouncing.get(), 0, 1, values.data(), 3, times.data(), nullptr, nullptr,
                                 values.data()) == LIBRATION_ARGUMENT);
    CHECK_THAT(libration_error_message(), Catch::Contains("is an event"));
    libration_problem* none = nullptr;
    CHECK(libration_problem_new("x' = -x; x(0) = 1; when x = 0 down: y = 1", nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(none == nullptr);
}

TEST_CASE("piecewise right-hand sides and delays from C", "[c][hybrid][delay]") {
    const auto first = [](const std::string& text, const char* time) {
        const auto of = problem_of(text);
        return cell(made<table>([&](auto** to) {
                        return libration_problem_states(of.get(), time, 20, LIBRATION_PROVED, nullptr, nullptr, to);
                    }),
                    0, 1);
    };
    CHECK(first("x' = if(t < 1, 1, -2); x(0) = 1", "3/2") == "1.0000000000000000000");
    // x = 1 + t up to t = 1, then 2 + s + s^2/2, s = t - 1.
    CHECK(first("x' = x(t - 1); x(t <= 0) = 1", "2") == "3.5000000000000000000");
}

// x = x0 e^t: between 0.9 and 1.1 at t = 0, and from 0.9 to 1.1 e over the times up to 1.
TEST_CASE("bounds of all solutions from C", "[c][sets]") {
    const auto growth = problem_of("x' = x; x(0) = 1", "x(0) = [0.9, 1.1]");
    CHECK(libration_problem_name(growth.get(), 0) == std::string("x"));
    const auto bounds = made<table>(
        [&](auto** to) { return libration_problem_enclosures(growth.get(), "0, 0:1", 4, 30, nullptr, nullptr, to); });
    REQUIRE(libration_table_rows(bounds.get()) == 2);
    CHECK(cell(bounds, 0, 2) == "x");
    const auto number = [&](std::size_t row, std::size_t column) { return std::stod(cell(bounds, row, column)); };
    CHECK(number(0, 3) <= 0.9);
    CHECK(number(0, 4) >= 1.1);
    CHECK(number(1, 0) == 0);
    CHECK(number(1, 1) == 1);
    const double largest = 1.1 * std::exp(1.0);
    CHECK(number(1, 4) >= largest * (1 - std::numeric_limits<double>::epsilon()));
    CHECK(number(1, 4) < 1.1 * largest);
    libration_table* none = nullptr;
    CHECK(libration_problem_enclosures(growth.get(), "1:0", 4, 30, nullptr, nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_problem_enclosures(growth.get(), "1", 0, 30, nullptr, nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_problem_states(growth.get(), "1", 30, LIBRATION_PROVED, nullptr, nullptr, &none) ==
          LIBRATION_ARGUMENT);
    CHECK(none == nullptr);
}

// x0 e^t = a at ln(a/x0).
TEST_CASE("bounds of the events of all solutions from C", "[c][sets]") {
    const auto growth = problem_of("x' = x; x(0) = 1; a = 3", "x(0) = [1, 2]; a = [3, 4]");
    const auto bounds = made<table>([&](auto** to) {
        return libration_problem_enclosed_events(growth.get(), "x = a", 1, 64, 30, nullptr, nullptr, to);
    });
    REQUIRE(libration_table_rows(bounds.get()) == 2);
    CHECK(cell(bounds, 0, 1) == "time");
    CHECK(cell(bounds, 1, 1) == "x");
    const auto number = [&](std::size_t row, std::size_t column) { return std::stod(cell(bounds, row, column)); };
    CHECK(number(0, 2) <= std::log(1.5));
    CHECK(number(0, 3) >= std::log(4.0));
    CHECK(number(1, 2) <= 3);
    CHECK(number(1, 3) >= 4);
    libration_table* some = nullptr;
    CHECK(libration_problem_enclosed_events(growth.get(), "x = -1", 1, 1, 30, nullptr, nullptr, &some) ==
          LIBRATION_UNDECIDED);
    libration_table_free(some);
    libration_table* none = nullptr;
    for (const auto& [count, parts] : {std::pair(0L, 64L), std::pair(1L, 0L)}) {
        CHECK(libration_problem_enclosed_events(growth.get(), "x = a", count, parts, 30, nullptr, nullptr, &none) ==
              LIBRATION_ARGUMENT);
    }
    CHECK(none == nullptr);
}

}  // namespace c_test
