// Certificates of roots: check/libration_check.py, a program in integers, proves that there is exactly one. Tests of other
// certificates are those of the command (tests/command/certificate_test.cpp).
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "certificates/checked.hpp"
#include "command/temporary_folder.hpp"
#include "libration/problem/certificate.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/enclose.hpp"

namespace problem_certificate_test {

using namespace libration;
using namespace libration::tests;

namespace {

using words = std::vector<std::string>;

words values_of(const answer& found) {
    words values;
    for (std::size_t k = 0; k < found.rows.size(); ++k) {
        values.push_back(found.at(k, "value"));
    }
    return values;
}

checked_certificate checked_content(const std::string& content) {
    const temporary_folder folder;
    const auto file = folder.path() / "a.cert";
    std::ofstream(file, std::ios::binary) << content;
    return checked(file);
}

checked_certificate checked_root(const std::string& equations, const words& unknowns, const words& conditions,
                                 long digits) {
    const problem of(equations);
    const request how = proved_digits(digits);
    const auto found = find_unknowns(of, unknowns, conditions, how);
    return checked_content(certificate_of_root(of, unknowns, conditions, values_of(found), how));
}

}  // namespace

// x = cos(t - 1).
TEST_CASE("the certificate of a root of two unknowns is proved", "[problem][certificate]") {
    const auto proved = checked_root("x'' = -x; x(0) = 1; x'(0) = 1", {"x'(0)", "x(0)"}, {"x(1) = 1", "x'(1) = 0"}, 10);
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "exactly one choice of x(0) in [540302305"));
    CHECK(contains(proved.out, "x(1) = 1,\n    x'(1) = 0."));
}

// Functions of a start that is an interval, and a time before the initial point.
TEST_CASE("the certificate of a root of an equation with functions is proved", "[problem][certificate]") {
    const auto proved =
        checked_root("y' = k*exp(-y)/(2 + cos(t) + y) + sqrt(y); y(1) = 1; k = 1", {"k"}, {"y(1/2) = 1/2"}, 8);
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "y(1/2) = 1/2."));
}

// The restricted three-body problem: 1/r^3 for r = sqrt(u) is a polynomial in u^(-1/2), so that the form has 6 unknowns; the
// Jacobi constant at the end is that of the start.
TEST_CASE("a certificate of roots of sums has few unknowns", "[problem][certificate]") {
    const problem of(
        "x'' = 2*y' + x - (1 - m)*(x + m)/r1^3 - m*(x - 1 + m)/r2^3; y'' = -2*x' + y - (1 - m)*y/r1^3 - m*y/r2^3;"
        "r1 = sqrt((x + m)^2 + y^2); r2 = sqrt((x - 1 + m)^2 + y^2); m = 0.01215;"
        "x(0) = 0.8; x'(0) = 0; y(0) = 0; y'(0) = 0.126");
    const ode::explicit_system system(of.equations());
    const request how = proved_digits(10);
    const auto found = solve(of, {.general = true})->states("1", how);
    std::vector<std::string> row;
    for (const std::string& name : ode::names_of_state(system)) {
        row.push_back(found.at(0, name));
    }
    const auto jacobi = [](double x, double u, double y, double v) {
        const double m = 0.01215;
        return x * x + y * y + 2 * (1 - m) / std::hypot(x + m, y) + 2 * m / std::hypot(x - 1 + m, y) - u * u - v * v;
    };
    const std::vector<std::string> order = ode::names_of_state(system);
    REQUIRE(order == std::vector<std::string>{"x", "x'", "y", "y'"});
    // 10 digits of numbers below 1, times derivatives below 10.
    CHECK(std::abs(jacobi(std::stod(row[0]), std::stod(row[1]), std::stod(row[2]), std::stod(row[3])) -
                   jacobi(0.8, 0, 0, 0.126)) < 1e-8);
    const auto content =
        certificate_of_states(system, {read_exact("1")}, {{row}, 10}, how, {"r1 = sqrt((x + m)^2 + y^2)", "\xce\xbc"});
    CHECK(content.size() < 12'000);
    const auto proved = checked_content(content);
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "*((x + 243/20000)^2 + y^2)^(-3/2)"));
    CHECK(contains(proved.out, "\nNot checked: r1 = sqrt((x + m)^2 + y^2)\nNot checked: ??\n"));
}

// The period of van der Pol's equation in the catalogue [PROBLEMS].
TEST_CASE("the certificate of a periodic orbit is proved", "[problem][certificate]") {
    const problem of("x'' = (1 - x^2)*x' - x; x(1) = 2; x'(1) = 0");
    const request how = proved_digits(10);
    const std::string content = certificate_of_orbit(of, values_of(find_periodic_orbit(of, how)), how);
    const auto proved = checked_content(content);
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "exactly one choice of x(1) in ["));
    CHECK(contains(proved.out, "t in [7.6632868"));
    CHECK(contains(proved.out, "x(t) = x(1),\n    x'(t) = x'(1)."));
}

TEST_CASE("roots that the format does not contain have no certificate", "[problem][certificate]") {
    const problem of("x'' = -x; x(0) = a; x'(0) = a; a = 1");
    CHECK_THROWS_WITH(certificate_of_root(of, {"a"}, {"x(1) = 1"}, {"0.72"}, proved_digits(2)),
                      Catch::Contains("on which an initial value depends, as on a"));
    const problem spring("x'' = -x; x(0) = 1; x'(0) = 1");
    CHECK_THROWS_WITH(certificate_of_root(spring, {"x(0)"}, {"x(1) = x(0)"}, {"0.72"}, proved_digits(2)),
                      Catch::Contains("contains roots of conditions such as y(1) = 1/2"));
    // A decimal that is not that of a root.
    CHECK_THROWS_WITH(certificate_of_root(spring, {"x(0)"}, {"x(1) = 1"}, {"0.72"}, proved_digits(2)),
                      Catch::Contains("not found again"));
}

// A step of x'' = -x has a length of about 2.
TEST_CASE("a certificate with too many steps is not begun", "[problem][certificate]") {
    const problem of("x'' = -x; x(0) = 1; x'(0) = 0");
    const ode::explicit_system system(of.equations());
    CHECK_THROWS_WITH(certificate_of_states(system, {read_exact("1e9")}, {{{"0.84", "-0.55"}}, 2}, proved_digits(2)),
                      Catch::Contains("contains at most 99999 steps, and to time 1000000000 there would be about"));
}

}  // namespace problem_certificate_test
