// Equations with special functions on the command line, compared with the quadratures of tests/reference/functions.py.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "scalars.hpp"

namespace command_functions_test {

using namespace libration;
using namespace libration::tests;

namespace {

struct quadrature {
    std::string problem, time, value;
};

std::vector<quadrature> quadratures() {
    std::ifstream file(std::filesystem::path(LIBRATION_REFERENCE_DIR) / "functions.txt");
    std::vector<quadrature> all;
    for (std::string line; std::getline(file, line);) {
        const auto first = line.find(" | ");
        const auto second = line.find(" | ", first + 3);
        all.push_back({line.substr(0, first), line.substr(first + 3, second - first - 3), line.substr(second + 3)});
    }
    return all;
}

}  // namespace

TEST_CASE("values of equations with special functions are proved and equal to quadratures", "[command][function]") {
    const auto all = quadratures();
    CHECK(all.size() == 10);
    for (const quadrature& each : all) {
        INFO(each.problem);
        const auto rows = rows_of({"reference", "--problem", each.problem, "--time", each.time, "--digits", "38"});
        REQUIRE(rows.size() == 1);
        const precision_scope scope(60);
        const mpfr value = decimal(rows.front().at(each.problem.substr(0, 1))).value;
        CHECK(abs(mpfr(value - decimal(each.value).value)) <= abs(value) * pow(mpfr(10), -37));
    }
}

TEST_CASE("a function of a start in its singular set is refused", "[command][function]") {
    const temporary_folder folder;
    check_refused({"reference", "--problem", "y' = bessel_j(0, y); y(0) = 0", "--time", "1"},
                  {"takes a Bessel function at 0, a singular point of its equation"}, folder);
    check_refused({"reference", "--problem", "y' = acosh(1 + y); y(0) = 0", "--time", "1"},
                  {"takes acosh of 1, where it has no series"}, folder);
    check_refused({"reference", "--problem", "y' = bessel_j(y, 1); y(0) = 1", "--time", "1"},
                  {"has an order that is not constant"}, folder);
}

}  // namespace command_functions_test
