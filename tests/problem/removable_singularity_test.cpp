// Solutions that cross removable singularities, compared with the quadratures of tests/reference/removable.py, and the
// quotients that remain singular.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/equation/removable_singularity.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"

namespace problem_removable_singularity_test {

using namespace libration;

namespace {

struct crossed_problem {
    std::string text, time, name, value;
};

std::vector<crossed_problem> problems_of(const std::string& table) {
    std::ifstream file(std::filesystem::path(LIBRATION_REFERENCE_DIR) / table);
    std::vector<crossed_problem> all;
    for (std::string line; std::getline(file, line);) {
        std::vector<std::string> cells;
        for (std::size_t at = 0; at != std::string::npos;) {
            const auto next = line.find(" | ", at);
            cells.push_back(line.substr(at, next - at));
            at = next == std::string::npos ? next : next + 3;
        }
        all.push_back({cells.at(0), cells.at(1), cells.at(2), cells.at(3)});
    }
    return all;
}

std::string value_of(const crossed_problem& of, const request& how) {
    return solve(problem(of.text))->states(of.time, how).at(0, of.name);
}

ode::expression right_side(const std::string& text) {
    return ode::with_removed_singularities(ode::parse(text).equations.front().right);
}

}  // namespace

TEST_CASE("solutions cross removable singularities in every scalar", "[problem][removable]") {
    const auto all = problems_of("removable.txt");
    CHECK(all.size() == 22);
    const precision_scope scope(60);
    for (const crossed_problem& each : all) {
        INFO(each.text);
        const mpfr exact(each.value);
        // Two units of the last printed digit, one of them of the reference.
        CHECK(abs(mpfr(mpfr(value_of(each, proved_digits(35))) - exact)) <= abs(exact) * pow(mpfr(10), -34));
        CHECK(abs(mpfr(mpfr(value_of(each, rounded_digits(30))) - exact)) <= abs(exact) * pow(mpfr(10), -28));
        // Some 30 steps, each with some 20 roundings.
        const request in_double{.scalar = {scalar_kind::binary64, 17}, .digits = 17};
        CHECK(abs(mpfr(mpfr(value_of(each, in_double)) - exact)) <= abs(exact) * ldexp(mpfr(600), -52));
    }
}

// The first step by theorem S with the bounds of functions, and a second proof by another route.
TEST_CASE("solutions from singular initial points with functions have proved digits", "[problem][singular]") {
    const auto all = problems_of("singular_functions.txt");
    CHECK(all.size() == 7);
    const precision_scope scope(60);
    for (const crossed_problem& each : all) {
        INFO(each.text);
        request how = proved_digits(35);
        how.check = true;
        const mpfr exact(each.value);
        CHECK(abs(mpfr(mpfr(value_of(each, how)) - exact)) <= abs(exact) * pow(mpfr(10), -34));
    }
    // The tangent has no bound there.
    CHECK_THROWS_WITH(value_of({"y'' + 2*y'/t = tan(y); y(0) = 1; y'(0) = 0", "1", "y", ""}, proved_digits(10)),
                      Catch::Contains("takes tan, which is not proved there"));
}

// The solution starts at the singularity, crosses it, and the derivative of the removed quotient is that of the series.
TEST_CASE("derivatives with respect to numbers cross removable singularities", "[problem][removable]") {
    const precision_scope scope(60);
    request how = proved_digits(25);
    how.derivatives = {"U(0)"};
    // y = the integral of u/(exp(u) - 1) from U(0) to U(0) + 2: its derivative is the difference of the integrand.
    const auto found = solve(problem("U' = 1; y' = U/(exp(U) - 1); U(0) = -1; y(0) = 0"))->states("2", how);
    const auto integrand = [](int u) { return mpfr(mpfr(u) / (exp(mpfr(u)) - 1)); };
    const mpfr exact = integrand(1) - integrand(-1);
    CHECK(abs(mpfr(mpfr(found.at(0, "dy(t)/dU(0)")) - exact)) <= pow(mpfr(10), -23));
}

TEST_CASE("what becomes of a quotient with a removable singularity", "[problem][removable]") {
    const auto is_singular_at_zero = [](const std::string& text) {
        const ode::expression made = right_side("y' = " + text + "; y(0) = 0");
        const ode::expression at = replaced(made, [](const ode::expression& leaf) {
            return leaf.kind() == ode::node_kind::variable ? std::optional(ode::expression(0)) : std::nullopt;
        });
        return at.kind() != ode::node_kind::constant;
    };
    for (const char* const removed :
         {"sin(t)/t", "t/(1 - exp(-t))", "(exp(3*t) - exp(t))/t", "t^2/(1 - cos(t))", "tan(2*t)/sin(t)", "sin(t)^3/t^3",
          "log(1 + t)/expm1(t)", "1/t*sin(t)", "(acos(t) - pi/2)/t", "(1 + t)^(1/3)*(exp(t) - 1)/t", "y*t/sinh(t)",
          "(t - sin(t))/t^3", "(2^t - 1)/t"}) {
        INFO(removed);
        CHECK_NOTHROW(is_singular_at_zero(removed));
    }
    // Different expressions, poles, and roots that are not analytic at the common zero, remain as they are.
    for (const char* const kept :
         {"sin(y)/t", "sqrt(t)/t", "(y - t)/(y + t)", "y*(1 - t)/(1 - t)", "2*log(t)/log(t)*y", "cos(t)/t^2"}) {
        INFO(kept);
        const ode::expression given = ode::parse("y' = " + std::string(kept) + "; y(1) = 0").equations.front().right;
        CHECK(same_form(ode::with_removed_singularities(given), given));
    }
}

// Poles of a lower order than that of the zero of the divisor.
TEST_CASE("a solution ends at a pole from which a common zero was removed", "[problem][removable]") {
    for (const char* const pole :
         {"(exp(x) - 1 - x - x^2/2)/x^4", "x/(x/tan(x) - 1)", "sin(x)/x^2", "(1 - cos(x))/x^3"}) {
        INFO(pole);
        const auto found = solve(problem("x' = 1; y' = " + std::string(pole) + "; x(0) = -1; y(0) = 0"))
                               ->states("1/2, 2", proved_digits(15));
        REQUIRE(found.missing);
        CHECK_THAT(found.missing->what(), Catch::Contains("time '2' is not reached") && Catch::Contains("0.9999999"));
    }
    // By quadrature from -1 to -1/2, with mpmath.
    const auto at_half = [](const std::string& pole) {
        return value_of({"x' = 1; y' = " + pole + "; x(0) = -1; y(0) = 0", "1/2", "y", ""}, proved_digits(15));
    };
    CHECK(at_half("(exp(x) - 1 - x - x^2/2)/x^4") == "-0.0974532177911095");
    CHECK(at_half("x/(x/tan(x) - 1)") == "2.00305900740851");
}

// Two zeros, of different expressions that are equal along the solution.
TEST_CASE("a solution ends at a zero of different expressions", "[problem][removable]") {
    const auto found =
        solve(problem("x' = 1; w' = 1; y' = sin(x)/w; x(0) = -1; w(0) = -1; y(0) = 0"))->states("2", proved_digits(10));
    REQUIRE(found.missing);
    CHECK_THAT(found.missing->what(), Catch::Contains("time '2' is not reached"));
}

// |F(u + e) - F(u)| and the remainder of F(u) are those of theorem T: e' = exprel(1, e) has the solution of u' =
// (exp(u) - 1)/u, by t = the integral of u/(exp(u) - 1), which the tail has to contain.
TEST_CASE("theorem T holds for relative functions", "[problem][removable]") {
    const precision_scope scope(60);
    const ode::explicit_system system(ode::parse("u' = exprel(1, u); u(0) = -1/10"));
    const ode::polynomial_form form = lifted(system, ode::relative_functions::kept);
    CHECK(form.has_functions);
    const ode::tape of = ode::tape::about_points(form.system);
    constexpr int degree = 6;
    ode::taylor_expansion<ball> series(of, degree);
    series.about(ball(0), {{from_rational<ball>(rational(-1, 10))}});
    const auto tail = bounded_tail(of, series, ball(0), magnitude::of(1, -1));
    REQUIRE(tail);
    const ode::taylor_expansion<ball> longer = [&] {
        ode::taylor_expansion<ball> made(of, 40);
        made.about(ball(0), {{from_rational<ball>(rational(-1, 10))}});
        return made;
    }();
    // The terms that are left out at t = 1/4, those beyond 40 being less than 2^-60.
    ball rest(0);
    for (int n = 40; n > degree; --n) {
        rest += longer.coefficients(0)[n] * pow(ball(1) / 4, n);
    }
    const ball bound = tail->at(0, magnitude::of(1, -2)).exact();
    CHECK(certainly_less(abs(rest), bound));
    CHECK(certainly_less(bound, abs(rest) * 1000));
}

}  // namespace problem_removable_singularity_test
