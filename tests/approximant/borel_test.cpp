// Borel sums of series of factorial growth against incomplete gamma functions, and what a pole on the ray contributes.
#include "libration/approximant/borel.hpp"

#include <catch2/catch.hpp>

#include "libration/scalar/precision_scope.hpp"

namespace approximant_borel_test {

using namespace libration;

namespace {

// P/Q with Q = 1 + q x.
pade_approximant<mpfr> pole(const mpfr& q) {
    return {series::power_series<mpfr>(std::vector<mpfr>{mpfr(1)}),
            series::power_series<mpfr>(std::vector<mpfr>{mpfr(1), q})};
}

}  // namespace

TEST_CASE("the transform of n! is 1, and that of Gamma(2 n + 3/2) for s = 2, b = 3/2", "[approximant][borel]") {
    const precision_scope scope(60);
    std::vector<mpfr> factorials{mpfr(1)};
    std::vector<mpfr> gammas{mpfr(sqrt(pi<mpfr>()) / 2)};
    for (int n = 1; n <= 20; ++n) {
        factorials.push_back(factorials.back() * n);
        gammas.push_back(gammas.back() * (4 * n - 1) * (4 * n + 1) / 4);  // (2n - 1/2)(2n + 1/2)
    }
    for (const mpfr& each : borel_transform(factorials, rational(1), rational(1))) {
        CHECK(abs(mpfr(each - 1)) < mpfr("1e-55"));
    }
    for (const mpfr& each : borel_transform(gammas, rational(2), rational(3, 2))) {
        CHECK(abs(mpfr(each - 1)) < mpfr("1e-55"));
    }
}

TEST_CASE("the Borel sum of (-1)^n n! x^n is that of Euler", "[approximant][borel]") {
    const precision_scope scope(80);
    const laplace_rule rule(rational(1), rational(1));
    for (const int tenths : {1, 10, 35}) {
        const mpfr x = mpfr(tenths) / 10;
        mpfr gamma;  // e^(1/x) Gamma(0, 1/x)/x
        mpfr_gamma_inc(handle(gamma), handle(mpfr(0)), handle(mpfr(1 / x)), MPFR_RNDN);
        const mpfr truth = exp(mpfr(1 / x)) * gamma / x;
        const auto sum = *rule.integral(pole(mpfr(1)), x);
        CHECK(abs(mpfr(sum.value - truth)) < mpfr("1e-40"));
        CHECK(abs(mpfr(sum.value - truth)) <= sum.error);
        const auto of_function = rule.integral([&](const mpfr& u) { return mpfr(1 / (x * u + 1)); });
        CHECK(abs(mpfr(of_function.value - truth)) < mpfr("1e-40"));
    }
}

TEST_CASE("a pole on the ray adds half the difference of both paths to the error", "[approximant][borel]") {
    const precision_scope scope(80);
    // 1/(1 - x u): the residue in u is 1/x at u = 1/x.
    const laplace_rule rule(rational(1), rational(1));
    const mpfr x = mpfr(1) / 7;
    const auto sum = *rule.integral(pole(mpfr(-1)), x);
    CHECK(sum.error >= pi<mpfr>() * exp(mpfr(-7)) * 7);
    CHECK(sum.error < pi<mpfr>() * exp(mpfr(-7)) * 7 * 10);
}

TEST_CASE("powers of u are integrated to gamma functions for every s and b", "[approximant][borel]") {
    const precision_scope scope(80);
    for (const rational& s : {rational(1, 2), rational(1), rational(2)}) {
        for (const rational& b : {rational(1), rational(3, 2), rational(3)}) {
            const laplace_rule rule(s, b);
            mpfr truth;
            mpfr_gamma(handle(truth), handle(from_rational<mpfr>(rational(s * 2 + b))), MPFR_RNDN);
            const auto sum = rule.integral([](const mpfr& u) { return mpfr(u * u); });
            CHECK(abs(mpfr(sum.value / truth - 1)) < mpfr("1e-40"));
            CHECK(rule.points().size() > 100);
        }
    }
}

}  // namespace approximant_borel_test
