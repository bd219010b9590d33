#include "libration/convergence/radius_report.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_radius_report_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

template <class T>
radius_report<T> report(const power_series<T>& a) {
    return report_on_radius(a, epsilon<T>());
}

template <class T>
power_series<T> exponential(int order) {
    auto a = power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 1; n <= order; ++n) {
        a[n] = a[n - 1] * order / 3 / n;  // exp(order x/3): as large as its radius test would have it
    }
    return a;
}

// No test gives a radius, each says why, and nothing else.
template <class T>
void check_no_radius(const radius_report<T>& found, const std::string& reason) {
    for (const auto& test : found.tests) {
        CHECK_FALSE(test.radius);
        CHECK(test.note == reason);
    }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("what has no radius gets none from any test", "[convergence][radius_report]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    check_no_radius(report(exponential<T>(60)),
                    "no finite radius seen up to N = 60: the coefficients fall faster than any power R^-n");
    auto factorials = exponential<T>(60);
    for (int n = 0; n <= 60; ++n) {
        factorials[n] = 1 / factorials[n];
    }
    check_no_radius(report(factorials),
                    "no positive radius seen up to N = 60: the coefficients grow faster than any power R^-n");
    check_no_radius(report(power_series<T>::zero(20)), "no finite radius seen up to N = 20: all coefficients are 0");
    check_no_radius(report(power_series<T>::zero(0)), "no finite radius seen up to N = 0: all coefficients are 0");
    auto polynomial = power_series<T>::zero(20);
    polynomial[3] = T(1);
    check_no_radius(report(polynomial), "no finite radius seen up to N = 20: all coefficients after n = 3 are 0");
}

TEMPLATE_LIST_TEST_CASE("no list makes a test answer with what is no number", "[convergence][radius_report]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    std::uint64_t state = 20260101;
    const auto random = [&state](int range) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(range));
    };
    for (int trial = 0; trial < 60; ++trial) {
        // Few values, many of them 0 or equal: systems are singular and differences vanish.
        auto a = power_series<T>::zero(random(40));
        for (int n = 0; n <= a.order(); ++n) {
            a[n] = T(trial % 3 == 0 ? random(3) - 1 : trial % 3 == 1 ? 1 : random(1000)) / (1 + random(2));
        }
        const auto found = report(a);
        for (const auto& test : found.tests) {
            INFO(trial << " " << test.method << " " << test.note);
            CHECK(well_formed(test));
        }
    }
}

TEST_CASE("answers in a unit are lengths", "[convergence][radius_report]") {
    radius_estimate<double> one;
    one.radius = 1;
    one.uncertainty = 0.5;
    one.position = complex_number<double>{0.5, 0.25};
    const auto three = in_unit(one, 3.0);
    CHECK(*three.radius == 3);
    CHECK(three.uncertainty == 1.5);
    CHECK(three.position->re == 1.5);
    CHECK(three.position->im == 0.75);
    CHECK_FALSE(in_unit(no_estimate<double>("x", "because"), 3.0).radius);
}

TEST_CASE("exponents are told as simple fractions within their uncertainty", "[convergence][radius_report]") {
    radius_estimate<double> found;
    CHECK_FALSE(simple_exponent(found));
    const auto with = [](double exponent, double uncertainty) {
        radius_estimate<double> e;
        e.exponent = exponent;
        e.exponent_uncertainty = uncertainty;
        return e;
    };
    CHECK(*simple_exponent(with(-1.0001, 0.001)) == -1);
    CHECK(*simple_exponent(with(0.3333, 0.001)) == rational(1, 3));
    CHECK_FALSE(simple_exponent(with(0.3333, 0.00001)));
    CHECK_FALSE(simple_exponent(with(0.3333, 0.1)));
}

TEST_CASE("an exponent is no more certain than the radius lets it be", "[convergence][radius_report]") {
    const auto with = [](double exponent, double uncertainty, double of_radius) {
        radius_estimate<double> e;
        e.radius = 2;
        e.uncertainty = of_radius * 2;
        e.exponent = exponent;
        e.exponent_uncertainty = uncertainty;
        return e;
    };
    const list_quality<double> list{100, 0x1p-52};
    const double l = std::log(100.0);
    // Sharp: n delta, which does not narrow anything.
    auto sharp = with(0.3, 1e-12, 1e-9);
    add_position_to_exponent(sharp, list);
    CHECK(sharp.exponent_uncertainty == Approx(1e-7));
    auto wide = with(0.3, 0.1, 1e-9);
    add_position_to_exponent(wide, list);
    CHECK(wide.exponent_uncertainty == 0.1);
    // Not sharp: n log^2 n delta, and 2 n log^3 n delta away from simple fractions.
    auto near_half = with(0.5001, 1e-12, 1e-6);
    add_position_to_exponent(near_half, list);
    CHECK(near_half.exponent_uncertainty == Approx(1e-4 * l * l));
    auto near_none = with(0.6, 1e-12, 1e-6);
    add_position_to_exponent(near_none, list);
    CHECK(near_none.exponent_uncertainty == Approx(2e-4 * l * l * l));
    // Sharp is N^-4.
    CHECK(is_sharp(with(0, 0, 0.99e-8), list));
    CHECK_FALSE(is_sharp(with(0, 0, 1.01e-8), list));
}

}  // namespace convergence_radius_report_test
