// The formulas of theorem F on local expansions made by hand, compared with closed forms and with incomplete beta functions.
#include "libration/asymptotics/fixed_point_terms.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"

namespace asymptotics_fixed_point_terms_test {

using namespace libration;
using namespace libration::ode;

namespace {

// x^e (first_0 + first_1 log x + ..), a solution of an equation with constant coefficients in log x and no other singular point.
fixed_point_terms terms_of(const rational& e, const std::vector<int>& first, double rho) {
    const int count = static_cast<int>(first.size());
    local_operator about;
    about.place = complex_ball(1);
    // (x d/dx - e)^count in terms of x^i (d/dx)^i, count at most 3
    const ball a = from_rational<ball>(e);
    const std::vector<std::vector<ball>> all{{-a, ball(1)},
                                             {a * a, ball(1) - a * 2, ball(1)},
                                             {-a * a * a, a * a * 3 - a * 3 + 1, ball(3) - a * 3, ball(1)}};
    for (const ball& each : all[first.size() - 1]) {
        about.c.push_back({complex_ball(each)});
    }
    about.exponents.assign(first.size(), complex_ball(a));
    std::vector<complex_ball> v;
    for (const int each : first) {
        v.emplace_back(each);
    }
    frobenius_series series(about, complex_ball(a), {v}, {4, 1, 40 * count, 60});
    return {complex_ball(1), true, {local_part{std::move(series), e}}, rho};
}

// Coefficient n of (1 - t)^a.
ball binomial_of(const rational& a, long n) {
    ball result(1);
    for (long k = 1; k <= n; ++k) {
        result = result * (k - 1 - from_rational<ball>(a)) / k;
    }
    return result;
}

// The integral of (u - 1)^a u^(-n-1) from 1 + d on.
ball integral_beyond(const rational& a, long n, const ball& d) {
    ball result;
    arb_hypgeom_beta_lower(result.handle(), ball(ball(n) - from_rational<ball>(a)).handle(),
                           ball(from_rational<ball>(a) + 1).handle(), ball(1 / (d + 1)).handle(), 0,
                           ball::working_bits());
    return result;
}

}  // namespace

TEST_CASE("powers and logarithms have the coefficients of their closed forms", "[asymptotics][proved]") {
    const precision_scope scope(40);
    for (const rational& a : {rational(1, 2), rational(-5, 3), rational(7, 4)}) {
        CHECK(overlaps(terms_of(a, {1}, 2).coefficient(30, 2), binomial_of(a, 30)));
    }
    const auto logarithm = terms_of(0, {0, 1}, 2);  // log(1 - t)
    const auto times = terms_of(1, {0, 1}, 2);      // (1 - t) log(1 - t)
    const auto square = terms_of(0, {0, 0, 2}, 2);  // log(1 - t)^2: 2 H_(n-1)/n
    const auto pole = terms_of(-2, {1}, 2);
    for (const long n : {20L, 400L}) {
        CHECK(overlaps(logarithm.coefficient(n, 3), ball(ball(-1) / n)));
        CHECK(overlaps(times.coefficient(n, 3), ball(ball(1) / n / (n - 1))));
        CHECK(overlaps(pole.coefficient(n, 3), ball(n + 1)));
        ball harmonic(0);
        for (long k = 1; k < n; ++k) {
            harmonic += ball(1) / k;
        }
        CHECK(overlaps(square.coefficient(n, 3), ball(harmonic * 2 / n)));
    }
    CHECK(pole.first(5) == 0);
    CHECK(logarithm.first(5) > 5);
}

// A term that is subtracted has its integral beyond d in the bound.
TEST_CASE("the bound contains the integrals of the subtracted terms beyond the circle", "[asymptotics][proved]") {
    const precision_scope scope(40);
    const ball d(1);
    for (const rational& a : {rational(1, 2), rational(-1, 3), rational(7, 4)}) {
        const auto terms = terms_of(a, {1}, 2);
        const ball truth = integral_beyond(a, 20, d) / pi<ball>();
        const ball bound = terms.bound(20, 0);
        CHECK(certainly_less(truth, bound));
        CHECK(certainly_less(bound, ball(truth * 2)));
    }
    // x log x: the jump is 2 pi i w
    const ball truth = integral_beyond(1, 20, d);
    const ball bound = terms_of(1, {0, 1}, 2).bound(20, 0);
    CHECK(certainly_less(truth, bound));
    CHECK(certainly_less(bound, ball(truth * 2)));
}

// x^2 log x as x V, V = x log x: with J = 0 the whole coefficient 2!(n - 3)!/n! is in the bound, and for large n little else.
TEST_CASE("the bound contains what is left out at the point", "[asymptotics][proved]") {
    const precision_scope scope(40);
    const auto whole = terms_of(2, {0, 1}, 2);
    local_operator about;
    about.place = complex_ball(1);
    about.c = {{complex_ball(4)}, {complex_ball(-3)}, {complex_ball(1)}};  // (x d/dx - 2)^2
    about.exponents = {complex_ball(2), complex_ball(2)};
    const std::vector<complex_ball> none{complex_ball(0), complex_ball(0)};
    frobenius_series series(about, complex_ball(0), {none, none, {complex_ball(0), complex_ball(1)}}, {4, 1, 40, 60});
    const fixed_point_terms parts(complex_ball(1), true, {local_part{std::move(series), rational(0)}}, 2);
    for (const long n : {30L, 300L}) {
        const ball truth = ball(2) / n / (n - 1) / (n - 2);
        CHECK(overlaps(whole.coefficient(n, 2), ball(-truth)));
        CHECK(certainly_less(truth, ball(parts.bound(n, 0) * (ball(1) + pow(ball(10), -6L)))));
        CHECK(certainly_less(parts.bound(n, 0), ball(truth * 2)));
        const auto uniform = parts.uniform(0);
        const ball beta = from_rational<ball>(uniform.index);
        ball quotient;
        arb_gamma(quotient.handle(), ball(ball(n) - beta).handle(), ball::working_bits());
        ball factorial;
        arb_gamma(factorial.handle(), ball(n + 1).handle(), ball::working_bits());
        CHECK(certainly_less(truth, ball(uniform.circle * pow(ball(2), -n) + uniform.slit * quotient / factorial)));
    }
}

// log x as x^-1 V, V = x log x.
TEST_CASE("the series of a power follows from that of the power below", "[asymptotics][proved]") {
    const precision_scope scope(40);
    local_operator about;
    about.place = complex_ball(1);
    about.c = {{complex_ball(0)}, {complex_ball(1)}, {complex_ball(1)}};  // (x d/dx)^2
    about.exponents = {complex_ball(0), complex_ball(0)};
    frobenius_series series(about, complex_ball(-1),
                            {{complex_ball(0), complex_ball(0)}, {complex_ball(0), complex_ball(1)}}, {4, 1, 40, 60});
    const fixed_point_terms parts(complex_ball(1), true, {local_part{std::move(series), rational(-1)}}, 2);
    CHECK(overlaps(parts.coefficient(50, 3), ball(ball(-1) / 50)));
}

TEST_CASE("the slit must end inside the reach, and the leading terms are ordered", "[asymptotics][proved]") {
    const precision_scope scope(40);
    CHECK_THROWS_AS(terms_of(rational(1, 2), {1}, 5.5), precision_exhausted);
    CHECK_THROWS_AS(terms_of(rational(1, 2), {1}, 1), precision_exhausted);
    const auto found = terms_of(0, {1, 3}, 2).leading();
    REQUIRE(!found.empty());
    CHECK(found[0].power == 1);
    CHECK(contains(found[0].coefficient.re, ball(3)));
    CHECK(terms_of(3, {1}, 2).leading().empty());
}

}  // namespace asymptotics_fixed_point_terms_test
