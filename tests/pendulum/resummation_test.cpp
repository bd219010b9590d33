#include "libration/pendulum/resummation.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/pendulum/expansion.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_resummation_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

const std::vector<std::string> energies_tested{"1e-3", "0.5", "1.71", "1.9998", "2.02", "4", "10"};

template <class T>
T power_of(const T& x, int n) {
    T result(1);
    for (int i = 0; i < n; ++i) {
        result *= x;
    }
    return result;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the descent goes from the top to the bottom of the exact solution", "[resummation]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& energy : energies_tested) {
        INFO(energy);
        const auto d = arc_of<T>(with_energy(energy));
        const exact_solution<T> solution(with_energy(energy));
        const auto top = solution.from_top(T(0));
        const auto bottom = solution.from_top(T(1));
        CHECK_THAT(d.top().theta, near<T>(top.theta, 2));
        CHECK_THAT(d.top().omega, near<T>(top.omega, 2));
        CHECK_THAT(d.bottom().value, near<T>(bottom.theta, 1));
        CHECK_THAT(d.bottom().slope, near<T>(bottom.omega, 2));
        CHECK((d.bottom().slope < 0) == (fraction(energy) < 2));  // libration moves towards smaller angles
    }
    CHECK_THROWS_AS(arc_of<T>(with_energy("2")), libration::error);
}

TEMPLATE_LIST_TEST_CASE("theta_N has the value and the slope of theta at T*, whatever N", "[resummation]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& energy : energies_tested) {
        const auto d = arc_of<T>(with_energy(energy));
        for (const int order : {0, 1, 2, 5, 20, 41}) {
            INFO("E = " << energy << ", N = " << order);
            const jet<T> end = resummation_from_top(d, order)(T(1));
            CHECK(end.value == d.bottom().value);
            CHECK(end.slope == d.bottom().slope * d.effective_period());
        }
    }
}

TEMPLATE_LIST_TEST_CASE("theta_N does not have the second derivative of theta at T*, which is 0", "[resummation]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    // theta'' = -sin theta* = 0; that of theta_N is twice the inner series at 1 (paper: "up to the 2nd derivative").
    for (const std::string energy : {"1.71", "2.02"}) {
        const auto d = arc_of<T>(with_energy(energy));
        for (const int order : {2, 5, 20}) {
            const T second = evaluate(resummation_from_top(d, order).inner(), T(1)).value * 2;
            INFO("E = " << energy << ", N = " << order);
            CHECK(abs(second) > T(1) / 100000);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("theta_N starts with the coefficients of the series", "[resummation]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& energy : energies_tested) {
        const auto d = arc_of<T>(with_energy(energy));
        for (const int order : {3, 20}) {
            const auto a = arc_series(d, order);
            // theta* + omega* T* (x-1) + (1-x)^2 sum h_n x^n, expanded by Cauchy products.
            auto polynomial = power_series<T>::zero(order);
            polynomial[0] = d.bottom().value - d.bottom().slope * d.effective_period();
            polynomial[1] = d.bottom().slope * d.effective_period();
            auto square = power_series<T>::zero(order);
            square[0] = T(1);
            square[1] = T(-2);
            square[2] = T(1);
            const auto inner = resummation_from_top(d, order).inner();
            const auto whole = polynomial + square * inner;
            for (int n = 0; n <= order; ++n) {
                INFO("E = " << energy << ", n = " << n);
                // The running sums reach n times the size of theta and omega* T*, and are taken back.
                CHECK_THAT(whole[n], near<T>(a[n], 1, T((1 + d.effective_period()) * (n + 1))));
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("theta_N in the form of the appendix has the alpha and beta of the paper", "[resummation]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& energy : energies_tested) {
        for (const int order : {2, 7, 20}) {
            INFO("E = " << energy << ", N = " << order);
            const auto d = arc_of<T>(with_energy(energy));
            const auto a = arc_series(d, order);
            const auto corrected = endpoint_corrected(a, arc_endpoint(d));
            REQUIRE(corrected.order() == order + 2);
            // (efficient) in t, with sigma_N - theta* for the printed sigma_N.
            const T period = d.effective_period();
            const auto in_time = rescale(a, T(1 / period));
            const jet<T> sigma = evaluate(in_time, period);
            const T off = sigma.value - d.bottom().value;
            const T slope_off = d.bottom().slope - sigma.slope;
            const T power = power_of(period, order);
            const T alpha = -(off * (order + 2)) / (power * period) - slope_off / power;
            const T beta = off * (order + 1) / (power * period * period) + slope_off / (power * period);
            // Both are differences of terms of the size of theta and omega T*, multiplied by N.
            const T scale = (T(4) + period * 2) * (order + 2);
            CHECK_THAT(T(alpha * power * period), near<T>(corrected[order + 1], 2, scale));
            CHECK_THAT(T(beta * power * period * period), near<T>(corrected[order + 2], 2, scale));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the ahat_n in t are the convolution of the paper", "[resummation]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& energy : energies_tested) {
        const int order = 12;
        const auto d = arc_of<T>(with_energy(energy));
        const T period = d.effective_period();
        auto b = rescale(arc_series(d, order), T(1 / period));
        b[0] += -d.bottom().value + period * d.bottom().slope;  // (b), with theta*
        b[1] -= d.bottom().slope;
        const auto inner = resummation_from_top(d, order).inner();
        for (int n = 0; n <= order; ++n) {
            INFO("E = " << energy << ", n = " << n);
            T sum(0);
            for (int k = 0; k <= n; ++k) {
                sum += b[n - k] * (k + 1) / power_of(period, k + 2);
            }
            const T size = (T(4) + period * 2) * (n + 1);
            // The sums grow like n times the size of theta and omega* T*.
            CHECK_THAT(T(sum * power_of(period, n + 2)), near<T>(inner[n], 2, size));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("series and resummation converge to the exact solution", "[resummation]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"0.5", "1.71", "2.1", "10"}) {
        const auto d = arc_of<T>(with_energy(energy));
        const exact_solution<T> solution(with_energy(energy));
        // rho = T*/R is below 0.89 here, and 0.89^2300 below 1e-116.
        const int order = digits<T>() * 6 + 100;
        const auto series = series_from_top(d, order);
        const auto resummed = resummation_from_top(d, order);
        for (int eighths = 0; eighths <= 8; ++eighths) {
            INFO("E = " << energy << " at " << eighths << "/8");
            const auto expected = solution.from_top(T(eighths) / 8);
            CHECK_THAT(series(T(T(eighths) / 8)).value, near<T>(expected.theta, 3, T(4)));
            CHECK_THAT(resummed(T(T(eighths) / 8)).value, near<T>(expected.theta, 3, T(4)));
        }
    }
}

}  // namespace pendulum_resummation_test
