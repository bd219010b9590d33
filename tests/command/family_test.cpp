// Families of solutions in double: in lock step on all cores, with the table of solutions one by one.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "command/child_process.hpp"
#include "command/printed.hpp"

namespace command_family_test {

using namespace libration;
using namespace libration::tests;

namespace {

constexpr double epsilon_of_double = std::numeric_limits<double>::epsilon();

double value_of(const std::string& text) { return number_of(text).convert_to<double>(); }

}  // namespace

TEST_CASE("a family of thousands in double is a table of its closed form", "[command][family]") {
    const auto rows = rows_of({"trajectory", "--problem", "x' = a*x + t; x(0) = 2/a", "--set", "a=1:2:2001", "--times",
                               "1/2,0", "--scalar", "double"});
    REQUIRE(rows.size() == 4002);
    for (std::size_t i = 0; i < rows.size(); i += 7) {
        const double a = 1 + static_cast<double>(i / 2) / 2000;
        const double t = i % 2 == 0 ? 0.5 : 0;
        CHECK(value_of(rows[i].at("a")) == Approx(a).epsilon(1e-14));
        CHECK(rows[i].at("rigour") == "heuristic");
        CHECK(rows[i].at("time_typed") == (i % 2 == 0 ? "1/2" : "0"));
        const double exact = (2 / a + 1 / (a * a)) * std::exp(a * t) - (a * t + 1) / (a * a);
        // A step or two, and the error of a and of the printed value, of one unit each.
        CHECK(std::abs(value_of(rows[i].at("x")) - exact) <= 64 * epsilon_of_double * exact);
    }
}

// x = e^(1 - p): the parameter moves the initial point of each member.
TEST_CASE("members of a family begin at their own initial points", "[command][family]") {
    const auto rows = rows_of({"trajectory", "--problem", "x' = x; x(p) = 1; p = 0", "--set", "p=0:1/2:3", "--time",
                               "1", "--scalar", "double"});
    REQUIRE(rows.size() == 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double exact = std::exp(1 - static_cast<double>(i) / 4);
        CHECK(std::abs(value_of(rows[i].at("x")) - exact) <= 64 * epsilon_of_double * exact);  // a step or two
    }
}

TEST_CASE("the number of threads changes no digit of a family", "[command][family]") {
    const words family{"trajectory", "--problem", "x'' = -sin(x)", "--set",  "x(0)=0:3:600", "--set", "x'(0)=0",
                       "--times",    "0:4:3",     "--scalar",      "double", "--format",     "csv"};
    CHECK(output_of(family + words{"--jobs", "1"}) == output_of(family + words{"--jobs", "3"}));
}

TEST_CASE("a member that ends at a singularity is explained, and the others are complete", "[command][family]") {
    const auto done = run_libration({"trajectory", "--problem", "y' = y^2", "--set", "y(0)=1/4,2,1/2", "--times", "0,1",
                                     "--scalar", "double", "--format", "csv"});
    CHECK(done.exit_code == 1);
    CHECK(done.err.find("singularity") != std::string::npos);
    const auto rows = csv_rows(done.out);
    REQUIRE(rows.size() == 5);
    CHECK(std::abs(value_of(rows[1].at("y")) - 1.0 / 3) <= 16 * epsilon_of_double);
    CHECK(rows[2].at("y(0)") == "2");
    CHECK(std::abs(value_of(rows[4].at("y")) - 1) <= 16 * epsilon_of_double);
}

TEST_CASE("values that equations need as constants, and invariants, are integrated one by one", "[command][family]") {
    const auto powers = rows_of(
        {"trajectory", "--problem", "x' = x^p; x(0) = 1", "--set", "p=0,1,2", "--times", "1/2", "--scalar", "double"});
    REQUIRE(powers.size() == 3);
    CHECK(value_of(powers[0].at("x")) == Approx(1.5).epsilon(1e-15));
    CHECK(value_of(powers[1].at("x")) == Approx(std::exp(0.5)).epsilon(1e-15));
    CHECK(value_of(powers[2].at("x")) == Approx(2).epsilon(1e-15));
    const auto springs = rows_of({"trajectory", "--problem", "x'' = -x; x'(0) = 0; invariant x^2 + x'^2", "--set",
                                  "x(0)=1,2", "--times", "1", "--scalar", "double"});
    REQUIRE(springs.size() == 2);
    CHECK(springs[1].count("invariant_drift") == 1);
}

}  // namespace command_family_test
