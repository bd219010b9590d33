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

TEST_CASE("an apparent singularity of a fitted equation is not the nearest one", "[convergence][radius_verdict]") {
    const precision_scope scope(50);
    // (1-x)^(2/3) + (1+x)^(-5/2): its second-order equation is singular at 0.5789 too, where the sum is analytic.
    auto sum = binomial_series(mpfr(1), mpfr(mpfr(2) / 3), 40);
    const auto other = binomial_series(mpfr(-1), mpfr(mpfr(-5) / 2), 40);
    for (int n = 0; n <= 40; ++n) {
        sum[n] += other[n];
    }
    const auto found = report(sum).verdict;
    REQUIRE(found.radius);
    CHECK(covers(found, mpfr(1)));
    CHECK(found.uncertainty < mpfr("1e-30"));
    REQUIRE(found.exponent);
    CHECK(abs(mpfr(*found.exponent + mpfr(5) / 2)) <= found.exponent_uncertainty);
}

TEST_CASE("a verdict tells a kind and an exponent only where they are seen, and with an uncertainty",
          "[convergence][radius_verdict]") {
    const precision_scope scope(30);
    // Relative noise of 1e-8 on (1 - x/2)^(3/2), five times.
    for (unsigned seed = 1; seed <= 5; ++seed) {
        auto noisy = binomial_series(mpfr(2), mpfr(mpfr(3) / 2), 39);
        unsigned state = seed;
        for (int n = 0; n <= 39; ++n) {
            state = state * 1103515245U + 12345U;
            noisy[n] *= 1 + mpfr(static_cast<int>(state >> 16U) % 2001 - 1000) / 100'000'000'000;
        }
        const auto found = report(noisy).verdict;
        INFO(seed << " " << found.note);
        REQUIRE(found.radius);
        CHECK(covers(found, mpfr(2)));
        CHECK(found.uncertainty < mpfr("0.1"));
        CHECK((found.kind == singularity_kind::branch || found.kind == singularity_kind::unknown));
        if (found.exponent) {
            CHECK(found.exponent_uncertainty > 0);
            CHECK(abs(mpfr(*found.exponent - mpfr(3) / 2)) <= found.exponent_uncertainty);
        }
    }
}

namespace {

radius_estimate<double> said(const std::string& method, double radius, double uncertainty, bool may_decide = true) {
    radius_estimate<double> e;
    e.method = method;
    e.radius = radius;
    e.uncertainty = uncertainty;
    e.may_decide = may_decide;
    return e;
}

}  // namespace

TEST_CASE("what the others say decides between answers, and a contradiction widens", "[convergence][radius_verdict]") {
    const coefficient_pattern pattern;
    // Certain of itself and alone, against three that agree.
    const auto outvoted = verdict_of<double>({said("a", 0.58, 1e-30), said("b", 1.0001, 1e-3), said("c", 1, 1e-4),
                                              said("d", 0.9999, 1e-3), said("e", 0.98, 0.54)},
                                             pattern);
    CHECK(*outvoted.radius == 1);
    CHECK_THAT(outvoted.note, Catch::Contains("confirmed by"));
    // An uncertainty of the size of the answer confirms nothing: four times its own is left.
    const auto alone = verdict_of<double>({said("a", 1, 1e-6), said("e", 0.975, 0.541)}, pattern);
    CHECK(alone.uncertainty == Approx(4e-6));
    // The distance and the other's own uncertainty.
    const auto apart = verdict_of<double>({said("a", 1, 1e-6), said("b", 1.25, 0.125)}, pattern);
    CHECK(apart.uncertainty == Approx(0.375));
    CHECK_THAT(apart.note, Catch::Contains("contradicted by b"));
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
    CHECK(kind_of(found, true) == singularity_kind::unknown);
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
    // A pure one.
    CHECK(kind_of(with(-2.0001, 0.001), true) == singularity_kind::pole);
    CHECK(kind_of(with(0.0001, 0.001), true) == singularity_kind::logarithm);
    CHECK(kind_of(with(0.3333, 0.00001), true) == singularity_kind::algebraic);
    CHECK(kind_of(with(0.3333, 0.5), true) == singularity_kind::unknown);
    CHECK(kind_of(with(0.01, 0.06), true) == singularity_kind::unknown);
    // One with other powers or logarithms: only that the exponent is not an integer is decided.
    CHECK(kind_of(with(-2.0001, 0.001), false) == singularity_kind::unknown);
    CHECK(kind_of(with(0.0001, 0.001), false) == singularity_kind::unknown);
    CHECK(kind_of(with(0.3333, 0.001), false) == singularity_kind::branch);
    CHECK(kind_of(with(0.3333, 0.5), false) == singularity_kind::unknown);
}

TEST_CASE("an exponent is no more certain than the radius lets it be", "[convergence][radius_verdict]") {
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
    // Sharp is N^-4, pure N^-6 or the noise.
    CHECK(is_sharp(with(0, 0, 0.99e-8), list));
    CHECK_FALSE(is_sharp(with(0, 0, 1.01e-8), list));
    const list_quality<double> exact_list{100, 0};
    CHECK(is_pure(with(0, 0, 0.99e-12), exact_list));
    CHECK_FALSE(is_pure(with(0, 0, 1.01e-12), exact_list));
    CHECK(is_pure(with(0, 0, 1e-11), list));
    CHECK_FALSE(is_pure(with(0, 0, 1e-9), list));
    CHECK_FALSE(is_pure(with(0, 0, 1e-7), list_quality<double>{100, 1e-10}));
}

}  // namespace convergence_radius_report_test
