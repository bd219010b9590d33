#include "libration/convergence/exponent_drift.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "libration/convergence/recurrence_estimate.hpp"

namespace convergence_exponent_drift_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

// nu + error(n) at n, f n, f^2 n for f = 1/2.
template <class Error>
local_exponents<double> local_with(int n, double nu, const Error& error) {
    local_exponents<double> local{{}, 0.5};
    for (double& each : local.at) {
        each = nu + error(static_cast<double>(n));
        n /= 2;
    }
    return local;
}

}  // namespace

TEST_CASE("the possible drift of an exponent like 1/log n follows from its last step",
          "[convergence][exponent_drift]") {
    for (const int n : {64, 128, 256, 1024}) {
        const list_quality<double> list{n, 0x1p-52};
        for (const double k : {-2.0, -1.0, 1.0, 3.0}) {
            for (const double c : {0.0, 1.0, std::log(n)}) {
                const auto slow = local_with(n, 0.5, [&](double at) { return k / (std::log(at) + c); });
                const double error = k / (std::log(n) + c);
                CHECK(drift_of_exponent(slow, 0.5 + error, list) >= std::abs(error));
                CHECK(drift_of_exponent(slow, 0.5 + error, list) <= std::abs(error) * 4);
            }
        }
        // 1/n may be a drift too, of which the step is 1/n.
        const auto fast = local_with(n, 0.5, [](double at) { return 1 / at; });
        CHECK(drift_of_exponent(fast, 0.5, list) <= (2 * std::log2(n) + 1) / n * (1 + 0x1p-20));
        // Rounding errors are not taken for a drift.
        const auto noisy = local_with(n, 0.5, [&](double at) { return std::sin(at) * n * n * 0x1p-52; });
        CHECK(drift_of_exponent(noisy, 0.5, list) == 0);
    }
}

TEST_CASE("local exponents of a power are those of the power, of a point and of a pair",
          "[convergence][exponent_drift]") {
    const precision_scope scope(40);
    const mpfr third = mpfr(1) / 3;
    const auto point = local_exponents_of(every_coefficient(binomial_series(mpfr(2), third, 100)),
                                          complex_number<mpfr>{mpfr(2), mpfr(0)}, 1);
    REQUIRE(point);
    const mpfr c = mpfr(3) / 5;
    const auto pair = local_exponents_of(every_coefficient(gegenbauer_series(c, third, 100)),
                                         complex_number<mpfr>{c, mpfr(mpfr(4) / 5)}, 2);
    REQUIRE(pair);
    for (const auto& local : {*point, *pair}) {
        CHECK(local.factor == mpfr(1) / 2);
        for (const mpfr& each : local.at) {
            // Rounding is magnified by n^2 for a point and by n^4 for a pair, n <= 100.
            CHECK(abs(mpfr(each - third)) <= mpfr("1e-28"));
        }
    }
    CHECK_FALSE(local_exponents_of(every_coefficient(binomial_series(mpfr(2), third, 8)),
                                   complex_number<mpfr>{mpfr(2), mpfr(0)}, 1));
    CHECK_FALSE(local_exponents_of(every_coefficient(binomial_series(mpfr(2), third, 100)),
                                   complex_number<mpfr>{mpfr(3), mpfr(0)}, 1));
}

TEST_CASE("the exponent at a root is as sensitive as the root is near to another one",
          "[convergence][exponent_drift]") {
    const precision_scope scope(40);
    // (x - 1)(x - 1 - d): the exponent's distance e from d - 1 is e/d per unit of the root.
    for (const char* const text : {"1e-3", "1e-10", "1e-19"}) {
        const mpfr d(text);
        auto top = series::power_series<mpfr>::zero(2);
        top[0] = 1 + d;
        top[1] = -(2 + d);
        top[2] = 1;
        const mpfr e = mpfr(3) / 2;
        const mpfr found = fitting::sensitivity_of_exponent(top, {mpfr(1), mpfr(0)}, e);
        // The slope at the root, -d, cancels to 40 digits less those of d.
        CHECK(abs(mpfr(found * d / e - 1)) <= mpfr("1e-19"));
        CHECK(fitting::sensitivity_of_exponent(top, {mpfr(1), mpfr(0)}, mpfr(0)) == 0);
    }
}

TEST_CASE("roots that are not told apart are one singularity", "[convergence][exponent_drift]") {
    const precision_scope scope(40);
    const auto root = [](const char* re, const char* im, const char* error) {
        fitted_singularity one{{mpfr(re), mpfr(im)}, mpfr(0), {mpfr(error), mpfr(error)}, mpfr(0), mpfr(0)};
        return one;
    };
    const auto count = [](const std::vector<fitted_singularity>& roots) {
        return fitting::number_on_circle(roots, roots.front().moved.likely, mpfr(4));
    };
    CHECK(count({root("1", "0", "1e-6")}) == 1);
    CHECK(count({root("1", "0", "1e-6"), root("-1", "0", "1e-6")}) == 2);
    CHECK(count({root("0.6", "0.8", "1e-6")}) == 2);
    CHECK(count({root("1", "0", "1e-6"), root("1.000005", "0", "1e-6")}) == 1);
    CHECK(count({root("1", "1e-6", "1e-6")}) == 1);
    CHECK(count({root("1", "1e-3", "1e-6")}) == 2);
}

}  // namespace convergence_exponent_drift_test
