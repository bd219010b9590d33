// Systems with algebraic equations, compared with closed forms and with differential equations in other coordinates.
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/query/trajectory.hpp"
#include "libration/scalar/scalar.hpp"

namespace algebraic_equations_test {

using namespace libration;

constexpr int digits = 40;

ode::explicit_system system_of(const std::string& text) { return ode::explicit_system(ode::parse(text)); }

// The values of the unknowns, without derivatives.
std::vector<mpfr> values_of(const std::string& text, const rational& time) {
    const auto states = ode::trajectory(system_of(text), {ode::number(time)}, digits);
    std::vector<mpfr> values;
    for (const auto& each : states.front()) {
        values.push_back(each[0]);
    }
    return values;
}

// Both have 40 correct digits, relative to the largest unknown.
void require_equal(const mpfr& a, const mpfr& b) { CHECK(abs(a - b) <= 2 * pow(mpfr(10), -digits + 1)); }

std::string message_of(const std::string& text) {
    try {
        system_of(text);
    } catch (const error& problem) {
        return problem.what();
    }
    return {};
}

TEST_CASE("algebraic equations agree with closed forms", "[ode][algebraic]") {
    const precision_scope scope(digits + 10);
    // x' = -x/2.
    const auto linear = values_of("x' = z - x; 0 = 2*z - x; x(0) = 1; z(0) = 1/2", 3);
    require_equal(linear[0], exp(mpfr(-3) / 2));
    require_equal(linear[1], exp(mpfr(-3) / 2) / 2);
    // x' = sqrt(x): x = (1 + t/2)^2, z = 1 + t/2; the other root is -z.
    const auto root = values_of("x' = z; 0 = z^2 - x; x(0) = 1; z(0) = 1", 3);
    require_equal(root[0], mpfr(25) / 4);
    require_equal(root[1], mpfr(5) / 2);
    require_equal(values_of("x' = z; 0 = z^2 - x; x(0) = 1; z(0) = -1", 1)[1], -mpfr(1) / 2);
    // A given function of time and of unknowns, without its initial value.
    const auto named = values_of("x' = -x; 0 = x^2 + sin(t) - z; 0 = 3*z - w; x(0) = 1", 2);
    require_equal(named[1], exp(mpfr(-4)) + sin(mpfr(2)));
    require_equal(named[2], 3 * named[1]);
}

TEST_CASE("mass matrices of any rank are eliminated", "[ode][algebraic]") {
    const precision_scope scope(digits + 10);
    // With u = x - y: u' = -u, and 0 = x + 2*y - 3 from the sum of both equations.
    const auto singular = values_of("x' - y' = y - x; y' - x' = 2*x + y - 3; x(0) = 5/3; y(0) = 2/3", 2);
    require_equal(singular[0], 1 + 2 * exp(mpfr(-2)) / 3);
    require_equal(singular[1], 1 - exp(mpfr(-2)) / 3);
    // Regular, with coefficients that depend on unknowns: x' = y, y' = -x.
    const auto regular = values_of("x*x' + y*y' = 0; x*y' - y*x' = -x^2 - y^2; x(0) = 0; y(0) = 1", 2);
    require_equal(regular[0], sin(mpfr(2)));
    require_equal(regular[1], cos(mpfr(2)));
}

TEST_CASE("the pendulum in Cartesian coordinates is the one in its angle", "[ode][algebraic]") {
    const precision_scope scope(digits + 10);
    const std::string cartesian =
        "x'' = -L*x; y'' = -L*y - 1; 0 = x^2 + y^2 - 1; x(0) = 3/5; x'(0) = 4/5; y(0) = -4/5; y'(0) = 3/5; L(0) = 9/5";
    CHECK(system_of(cartesian).algebraic().size() == 3);
    // sin(a) = 3/5, a' = 1, and L = a'^2 + cos(a).
    const auto angle =
        ode::trajectory(system_of("a'' = -sin(a); a(0) = asin(3/5); a'(0) = 1"), {ode::number(rational(7))}, digits)
            .front()[0];
    const auto found = values_of(cartesian, 7);
    require_equal(found[0], sin(angle[0]));
    require_equal(found[1], mpfr(angle[1] * angle[1] + cos(angle[0])));
    require_equal(found[2], -cos(angle[0]));
    // The same with the constraint differentiated twice by hand, and with L(0) from it.
    const auto stated = values_of(
        "x'' = -L*x; y'' = -L*y - 1; 0 = x'^2 + y'^2 - y - L; x(0) = 3/5; x'(0) = 4/5; y(0) = -4/5; y'(0) = 3/5", 7);
    for (std::size_t i = 0; i < found.size(); ++i) {
        require_equal(found[i], stated[i]);
    }
}

TEST_CASE("algebraic equations that are wrong are reported", "[ode][algebraic]") {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"x' = z; 0 = z^2 - x; x(0) = 1; z(0) = 2",
         "problem 'algebraic equation' at line 1, column 9 does not hold for the initial values, where its sides "
         "differ "
         "by -3: give initial values that satisfy it and its derivatives"},
        {"x' = z; 0 = exp(z) - x - 2*z; x(0) = 1",
         "problem 'z' has no initial value, and the algebraic equations at the initial point are not linear in those "
         "that are left out, or do not determine them: add z(0) = number"},
        {"x' + y' = 1; x' + y' = t; x(0) = 0; y(0) = 0",
         "problem 'equation 2' at line 1, column 14 depends on the others or contradicts them: give as many "
         "independent equations as unknowns"},
        {"x' = z; 0 = z^2 - x*t; x(0) = 1; z(0) = 0",
         "problem 'z'' cannot be expanded about the initial point, because its right-hand side divides by zero: choose "
         "another initial point"},
        // Any w is a solution.
        {"x' = 1; 0 = z; 0 = z*w; x(0) = 1; z(0) = 0; w(0) = 5",
         "problem has a coefficient of a highest derivative that is not proved nonzero at the initial point: choose "
         "another initial point, or equations that determine the highest derivatives"},
        {"z' = 0; z*w' = 0; z(0) = 0; w(0) = 5",
         "problem has a coefficient of a highest derivative that is not proved nonzero at the initial point: choose "
         "another initial point, or equations that determine the highest derivatives"},
        {"x' = z; 0 = x - z; 0 = x + z; x(0) = 0; z(0) = 0",
         "problem has 3 equations for 2 unknowns (x, z): give the same number of both"},
    };
    for (const auto& [text, message] : wrong) {
        CHECK(message_of(text) == message);
    }
    // The hidden constraint y y' + x x' = 0 does not hold.
    CHECK_THAT(message_of("x'' = -L*x; y'' = -L*y - 1; 0 = x^2 + y^2 - 1; x(0) = 0; x'(0) = 1; y(0) = -1; y'(0) = 1; "
                          "L(0) = 2"),
               Catch::Contains("where its sides differ by 2:"));
}

}  // namespace algebraic_equations_test
