#include "libration/approximant/differential.hpp"

#include <catch2/catch.hpp>

#include "libration/scalar/convert.hpp"
#include "libration/scalar/mpfr_traits.hpp"

namespace approximant_differential_test {

using namespace libration;

namespace {

constexpr long bits = 500;
constexpr root_annulus around_one{0.6, 1.4};

// (1 - x)^(1/3) (1 + x/2)^(-5/4), which satisfies an equation of order 1: f'/f is a fraction.
std::vector<mpfr> product_of_powers(int order) {
    std::vector<mpfr> a{mpfr(1)};
    std::vector<mpfr> b{mpfr(1)};
    for (int n = 0; n < order; ++n) {
        a.push_back(a.back() * (n - mpfr(1) / 3) / (n + 1));
        b.push_back(b.back() * (-mpfr(5) / 4 - n) / (n + 1) / 2);
    }
    std::vector<mpfr> c;
    for (int n = 0; n <= order; ++n) {
        mpfr sum(0);
        for (int k = 0; k <= n; ++k) {
            sum += a[static_cast<std::size_t>(k)] * b[static_cast<std::size_t>(n - k)];
        }
        c.push_back(sum);
    }
    return c;
}

const differential_root* root_near(const differential_fit& fit, double re) {
    for (const auto& root : fit.roots) {
        if (abs(root.position.re - re) < 1e-9 && root.position.im == 0) {
            return &root;
        }
    }
    return nullptr;
}

}  // namespace

TEST_CASE("a product of powers satisfies an equation of order 1 exactly, with its exponents",
          "[approximant][differential]") {
    const precision_scope scope(decimal_digits(bits));
    const auto a = product_of_powers(40);
    const std::vector<differential_track> tracks{{1, 0, 0}, {1, 3, 0}, {2, 0, 0}, {2, 1, 1}, {3, 0, 0}};
    const auto fits = differential_fits(a, tracks, std::vector{39, 40}, around_one, bits);
    int exact = 0;
    for (const auto& fit : fits) {
        if (fit.exact) {
            ++exact;
            CHECK(fit.length == 40);
            const auto* const one = root_near(fit, 1);
            REQUIRE(one != nullptr);
            if (one->type() == 11 && fit.track == 0) {
                CHECK(abs(one->exponent.re - mpfr(1) / 3) < mpfr(1e-60));
            }
        }
    }
    CHECK(exact == 5);
}

TEST_CASE("an exact relation predicts all further coefficients", "[approximant][differential]") {
    const precision_scope scope(decimal_digits(bits));
    const auto a = product_of_powers(60);
    const auto relation = relation_of(a, {1, 0, 0}, 30, bits);
    REQUIRE(relation);
    CHECK(relation->exact);
    const auto continued = continued_by(*relation, a, 30, 30);
    for (std::size_t n = 31; n <= 60; ++n) {
        CHECK(abs(continued[n] - a[n]) <= abs(a[n]) * mpfr(1e-60));
    }
}

TEST_CASE("a fitted relation satisfies the equations that it was fitted to, and no further one",
          "[approximant][differential]") {
    const precision_scope scope(decimal_digits(bits));
    std::vector<mpfr> a;  // exp(x)/(1 - x) + log(1 - x/2)^2 is of a higher order than 2
    mpfr sum(0);
    mpfr term(1);
    for (int n = 0; n <= 40; ++n) {
        sum += term;
        term /= n + 1;
        mpfr square(0);
        for (int k = 1; k < n; ++k) {
            square += mpfr(1) / k / (n - k);
        }
        a.push_back(sum + square / pow(mpfr(2), n));
    }
    for (const differential_track& track : {differential_track{1, 0, 0}, {1, 2, 0}, {2, 0, 0}, {2, 1, 1}, {3, 1, 0}}) {
        const auto relation = relation_of(a, track, 30, bits);
        REQUIRE(relation);
        CHECK_FALSE(relation->exact);
        const auto predicted = continued_by(*relation, a, 29, 2);
        // a_30 is used in the fit and is given by it; a_31 is not.
        CHECK(abs(predicted[30] / a[30] - 1) < mpfr(1e-40));
        CHECK(abs(predicted[31] / a[31] - 1) > mpfr(1e-40));
    }
}

TEST_CASE("an equation that only the first coefficients satisfy is not exact", "[approximant][differential]") {
    const precision_scope scope(decimal_digits(bits));
    auto a = product_of_powers(130);
    const std::vector<differential_track> tracks{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const std::vector lengths{130};
    CHECK(differential_fits(a, tracks, lengths, around_one, bits).size() == 3);
    a.back() *= 1 + mpfr(1e-20);
    CHECK(differential_fits(a, tracks, lengths, around_one, bits).empty());
}

TEST_CASE("an essential singularity is an irregular point of its equation", "[approximant][differential]") {
    const precision_scope scope(decimal_digits(bits));
    // exp(1/(1 - x)) + 1/(1 - x): f' of the first summand is f/(1-x)^2.
    std::vector<mpfr> a{exp(mpfr(1))};
    for (int n = 0; n < 60; ++n) {
        mpfr sum(0);
        for (int k = 0; k <= n; ++k) {
            sum += a[static_cast<std::size_t>(k)] * (n - k + 1);
        }
        a.push_back(sum / (n + 1));
    }
    for (auto& each : a) {
        each += 1;
    }
    const auto fits =
        differential_fits(a, std::vector<differential_track>{{2, 0, 0}}, std::vector{60}, around_one, bits);
    REQUIRE(fits.size() == 1);
    REQUIRE(fits.front().exact);
    for (const auto& root : fits.front().roots) {
        if (root.multiplicity == root.lower && root.multiplicity > 1 && abs(root.position.re - 1) < mpfr(1e-30)) {
            CHECK(root.irregular);
            CHECK_FALSE(root.is_regular());
        }
    }
}

TEST_CASE("a short list gives no relation, and zeros satisfy each", "[approximant][differential]") {
    const precision_scope scope(decimal_digits(bits));
    CHECK_FALSE(relation_of(product_of_powers(20), {1, 0, 0}, 4, bits));
    const auto of_zeros = relation_of(std::vector<mpfr>(20, mpfr(0)), {2, 0, 0}, 19, bits);
    REQUIRE(of_zeros);
    CHECK(of_zeros->exact);
    // x^4/(1 - x/2): the equations 0 = 0 of the first coefficients are not further ones that it satisfies.
    std::vector<mpfr> late(24, mpfr(0));
    for (std::size_t n = 4; n < late.size(); ++n) {
        late[n] = n == 4 ? mpfr(1) : mpfr(late[n - 1] / 2);
    }
    const auto of_late = relation_of(late, {1, 0, 0}, 23, bits);
    REQUIRE(of_late);
    CHECK(of_late->exact);
    CHECK(relation_of(late, {0, 4, 0}, 23, bits));
    late[23] += mpfr(1) / 1000;
    const auto of_changed = relation_of(late, {1, 0, 0}, 23, bits);
    CHECK((!of_changed || !of_changed->exact));
    CHECK(relation_of(late, {0, 4, 0}, 23, bits));  // 19 equations, 19 unknowns
    // With a numerator of degree 3 the coefficient of x^4 is 0 = 1 whatever the denominator is.
    CHECK_FALSE(relation_of(late, {0, 3, 0}, 23, bits));
}

TEST_CASE("a logarithm and a power are a double root of an equation of order 2", "[approximant][differential]") {
    const precision_scope scope(decimal_digits(bits));
    std::vector<mpfr> a{mpfr(1)};  // (1 - x)^(-1/2) log(1 - x): exponent -1/2 twice
    std::vector<mpfr> b;
    for (int n = 0; n <= 60; ++n) {
        a.push_back(a.back() * (n + mpfr(1) / 2) / (n + 1));
    }
    for (int n = 0; n <= 60; ++n) {
        mpfr sum(0);
        for (int k = 1; k <= n; ++k) {
            sum -= a[static_cast<std::size_t>(n - k)] / k;
        }
        b.push_back(sum);
    }
    const auto fits =
        differential_fits(b, std::vector<differential_track>{{2, 0, 0}}, std::vector{60}, around_one, bits);
    REQUIRE(fits.size() == 1);
    CHECK(fits.front().exact);
    bool found = false;
    for (const auto& root : fits.front().roots) {
        if (root.type() == 22 && abs(root.position.re - 1) < mpfr(1e-40)) {
            found = true;
            CHECK(abs(root.exponent.re + mpfr(1) / 2) < mpfr(1e-20));
            REQUIRE(root.second);
            CHECK(*root.second == Approx(-0.5));
            CHECK(root.is_regular());
        }
    }
    CHECK(found);
}

}  // namespace approximant_differential_test
