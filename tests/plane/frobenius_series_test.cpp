// Local series compared with closed forms, and their bounds with all coefficients.
#include "libration/plane/frobenius_series.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"

namespace plane_frobenius_series_test {

using namespace libration;
using namespace libration::ode;

namespace {

linear_equation typed(const std::string& text) { return *linear_equation::of(explicit_system(parse(text))); }

ball from_double(double x) {
    ball result;
    arb_set_d(result.handle(), x);
    return result;
}

}  // namespace

// y = (1 - t)^-40 about 0: v_n = binomial(n + 39, n), and v_n 0.85^n is largest at n = 220.
TEST_CASE("the bound holds for all coefficients, also for those above the first ones", "[plane][proved]") {
    const precision_scope scope(200);
    const linear_equation equation = typed("y' = 40*y/(1-t); y(0) = 1");
    const local_operator about = operator_about(equation, complex_ball(0), enclosed_roots(equation.leading()));
    const frobenius_series series(about, complex_ball(0), {{complex_ball(1)}}, {0.85, 0.01, 20, 0});
    ball v(1);
    for (long n = 0; n < 1500; ++n) {
        CHECK(
            certainly_less(v, ball(series.size().exact() * pow(series.reach(), -n) * (ball(1) + pow(ball(2), -25L)))));
        v = v * (n + 40) / (n + 1);
    }
    const auto y = series.derivatives(complex_ball(from_double(0.0078125)), 2);
    const ball truth = pow(ball(1 - from_double(0.0078125)), -40L);
    CHECK(overlaps(y[0].re, truth));
    CHECK(overlaps(y[1].re, ball(truth * 40 / (1 - from_double(0.0078125)))));
    CHECK(certainly_less(radius_of(y[0].re), pow(ball(10), -4L)));
}

// x y'' + y' = 0 in x = 1 - t: log x.
TEST_CASE("a logarithm, its derivatives and its bound on both sides of the slit", "[plane][proved]") {
    const precision_scope scope(40);
    const linear_equation equation = typed("(1-t)*y'' = y'; y(0) = 0; y'(0) = -1");
    const fuchsian_point structure(equation, rational_polynomial(std::vector<rational>{-1, 1}));
    const local_operator about = operator_at(structure, complex_ball(1), {});
    REQUIRE(structure.classes().size() == 1);
    const frobenius_series series(about, complex_ball(0), {{complex_ball(0), complex_ball(1)}}, {4, 0.5, 60, 0});
    const ball x = from_double(0.625);
    const auto y = series.derivatives(complex_ball(x), 3);
    CHECK(overlaps(y[0].re, log(x)));
    CHECK(overlaps(y[1].re, ball(1 / x)));
    CHECK(overlaps(y[2].re, ball(ball(-1) / (x * x) / 2)));
    const ball bound = series.bound(from_double(0.25), from_double(0.5));
    CHECK(certainly_less(sqrt(ball(log(ball(4)) * log(ball(4)) + pi<ball>() * pi<ball>())), bound));
    CHECK(certainly_less(bound, ball(6)));
}

// (1 + t^2) y' = t y/2 at i: x^(1/4) (1 - x/2)^(1/4), x = 1 + i t.
TEST_CASE("a complex point", "[plane][proved]") {
    const precision_scope scope(40);
    const linear_equation equation = typed("(1+t^2)*y' = 1/2*t*y; y(0) = 1");
    const fuchsian_point structure(equation, rational_polynomial(std::vector<rational>{1, 0, 1}));
    const complex_ball i{ball(0), ball(1)};
    const local_operator about = operator_at(structure, i, {complex_ball{ball(0), ball(-1)}});
    const frobenius_series series(about, complex_ball(from_rational<ball>(rational(1, 4))), {{complex_ball(1)}},
                                  {1.7, 1, 100, 0});
    const auto at = series.derivatives(complex_ball(1), 1);
    CHECK(overlaps(at[0].re, pow(ball(ball(1) / 2), ball(ball(1) / 4))));
    CHECK(contains_zero(at[0].im));
    CHECK(certainly_less(radius_of(at[0].re), pow(ball(10), -20L)));
}

TEST_CASE("a point outside the reach", "[plane][proved]") {
    const precision_scope scope(40);
    const linear_equation equation = typed("y' = y/(1-t); y(0) = 1");
    const local_operator about = operator_about(equation, complex_ball(0), enclosed_roots(equation.leading()));
    const frobenius_series series(about, complex_ball(0), {{complex_ball(1)}}, {0.75, 0.5, 40, 0});
    CHECK_THROWS_AS(series.derivatives(complex_ball(from_double(0.76)), 1), precision_exhausted);
    CHECK_THROWS_AS(series.bound(ball(0), from_double(0.76)), precision_exhausted);
}

}  // namespace plane_frobenius_series_test
