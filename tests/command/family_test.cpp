// Families of solutions in double: in lock step on all cores, with the table of solutions one by one.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "command/child_process.hpp"
#include "command/printed.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/precision_scope.hpp"

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

TEST_CASE("values that equations need as constants are integrated one by one", "[command][family]") {
    const auto powers = rows_of(
        {"trajectory", "--problem", "x' = x^p; x(0) = 1", "--set", "p=0,1,2", "--times", "1/2", "--scalar", "double"});
    REQUIRE(powers.size() == 3);
    CHECK(value_of(powers[0].at("x")) == Approx(1.5).epsilon(1e-15));
    CHECK(value_of(powers[1].at("x")) == Approx(std::exp(0.5)).epsilon(1e-15));
    CHECK(value_of(powers[2].at("x")) == Approx(2).epsilon(1e-15));
}

// A declared "invariant" k x that grows by k^2 t.
TEST_CASE("members of a family have the changes of their own invariants", "[command][family]") {
    const auto growing = rows_of({"trajectory", "--problem", "x' = k; x(0) = 1; k = 1; invariant k*x", "--set",
                                  "k=1,2,3", "--set", "x(0)=5,7", "--times", "0,1/2,-2", "--scalar", "double"});
    REQUIRE(growing.size() == 18);
    for (const auto& row : growing) {
        const double k = value_of(row.at("k"));
        CHECK(value_of(row.at("invariant_drift")) == Approx(k * k * std::abs(value_of(row.at("time")))).epsilon(5e-3));
    }
}

// Energy -1/2 and angular momentum sqrt(1 - e^2) of Kepler's ellipse, at the states, which 17 digits determine.
TEST_CASE("the changes of invariants in lock step are those of the printed states", "[command][family]") {
    const auto rows =
        rows_of({"trajectory", "--problem", "kepler", "--set", "e=1/5:4/5:4", "--times", "1,7", "--scalar", "double"});
    REQUIRE(rows.size() == 8);
    const precision_scope scope(40);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto at = [&](const char* name) { return mpfr(value_of(rows[i].at(name))); };
        const mpfr e = mpfr(1 + static_cast<int>(i) / 2) / 5;
        const mpfr x = at("x");
        const mpfr y = at("y");
        const mpfr energy = (at("x'") * at("x'") + at("y'") * at("y'")) / 2 - 1 / sqrt(x * x + y * y);
        const mpfr momentum = x * at("y'") - y * at("x'");
        const mpfr change = std::max(mpfr(abs(energy + mpfr(1) / 2)), mpfr(abs(momentum - sqrt(1 - e * e))));
        CHECK(value_of(rows[i].at("invariant_drift")) ==
              Approx(change.convert_to<double>()).epsilon(6e-3));  // 3 digits
    }
}

}  // namespace command_family_test
