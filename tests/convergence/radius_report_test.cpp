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
    CHECK_FALSE(found.verdict.radius);
    CHECK(found.verdict.note == reason);
    for (const auto& test : found.tests) {
        CHECK_FALSE(test.radius);
        CHECK(test.note == reason);
    }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the verdict is the most certain test, and another one confirms it",
                        "[convergence][radius_report]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    const auto poles = report(three_poles<T>(60));
    REQUIRE(poles.verdict.radius);
    CHECK(poles.verdict.method == "verdict");
    CHECK(abs(T(*poles.verdict.radius - T(5) / 4)) <= poles.verdict.uncertainty);
    CHECK(poles.verdict.kind == singularity_kind::pole);
    CHECK(poles.verdict.count == 1);
    const auto pair = report(spread(logarithms_of_a_pair<T>(60), 0, 2));
    REQUIRE(pair.verdict.radius);
    CHECK(pair.pattern.stride == 2);
    CHECK(pair.verdict.kind == singularity_kind::logarithm);
    CHECK(pair.verdict.count == 4);
    CHECK_THAT(pair.verdict.note, Catch::Contains("by pole-of-derivative, confirmed by"));
    const auto root = report(power_at<T>(T(1), T(1) / 3, 60));
    CHECK(root.verdict.kind == singularity_kind::algebraic);
    CHECK(*simple_exponent(root.verdict) == rational(1, 3));
}

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
    check_no_radius(report(polynomial),
                    "no finite radius seen up to N = 20: no coefficient after n = 3 is other than 0");
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

TEST_CASE("exponents are told as simple fractions within their uncertainty", "[convergence][radius_verdict]") {
    radius_estimate<double> found;
    CHECK_FALSE(simple_exponent(found));
    CHECK(kind_of(found) == singularity_kind::unknown);
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
    CHECK(kind_of(with(-2.0001, 0.001)) == singularity_kind::pole);
    CHECK(kind_of(with(0.0001, 0.001)) == singularity_kind::logarithm);
    CHECK(kind_of(with(0.3333, 0.00001)) == singularity_kind::algebraic);
    CHECK(kind_of(with(0.3333, 0.5)) == singularity_kind::unknown);
}

}  // namespace convergence_radius_report_test
