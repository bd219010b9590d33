#include "libration/scalar/counted.hpp"

#include <catch2/catch.hpp>

#include "libration/pendulum/other_recurrences.hpp"
#include "libration/pendulum/resummation.hpp"

namespace scalar_counted_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;

namespace {

// An arbitrary initial state: the counts depend only on its zeros.
taylor_start<counted> start(parity of_theta) {
    const bool even = of_theta == parity::even;
    return {
        {counted(1.5), counted(even ? 0.0 : 0.7), counted(0.6), counted(0.8)}, {counted(0.9), counted(1.1)}, of_theta};
}

template <class Work>
long products(const Work& work) {
    return count_operations(work).multiplications;
}

}  // namespace

TEST_CASE("counted numbers compute as doubles and count", "[scalar][counted]") {
    const auto count = count_operations([] {
        const counted a(6.0);
        const counted b(1.5);
        CHECK((a * b).value() == 9);
        CHECK((a / b).value() == 4);
        CHECK((a + b).value() == 7.5);
        CHECK((1 - a * 2 / 3).value() == -3);
        counted c = -a;
        c *= counted(0);
        c -= b;
        CHECK(c.value() == -1.5);
        CHECK(sqrt(counted(9.0)).value() == 3);
    });
    CHECK(count.multiplications == 2);
    CHECK(count.by_zero == 1);
    CHECK(count.divisions == 1);
    CHECK(count.additions == 2);
    CHECK(count.by_integers == 3);
}

TEST_CASE("counts nest without disturbing each other", "[scalar][counted]") {
    const auto outer = count_operations([] {
        const counted a = counted(2) * counted(3);
        CHECK(count_operations([&] { return a + a; }).multiplications == 0);
    });
    CHECK(outer.multiplications == 1);
    CHECK(outer.additions == 0);
}

TEST_CASE("the loops of the recurrences have the products that their sums have", "[scalar][counted]") {
    for (const int n : {4, 20, 81, 160}) {
        INFO("N = " << n);
        // (pendseries): two sums of j products for j = 1 .. N-2, one product for each a_j and four for the initial
        // state.
        CHECK(products([&] { taylor_by_sine_cosine(start(parity::any), n, counted(2.0)); }) == (n - 1) * (n - 1) + 4);
        // The convolution: sum_{j=0}^{N} (j+1) products.
        auto series = power_series<counted>::zero(n);
        const std::vector<counted> endpoint{counted(0), counted(-1)};
        CHECK(products([&] { inner_series_by_convolution(series, endpoint); }) == (n + 1) * (n + 2) / 2);
        CHECK(products([&] { inner_series(series, endpoint); }) == 0);
        CHECK(products([&] { endpoint_corrected(series, endpoint); }) == 3);
    }
}

TEST_CASE("products in units of N^2 are what the sums are in the limit", "[scalar][counted]") {
    constexpr int n = 1000;
    const auto in_squares = [&](const auto& work) { return static_cast<double>(products(work)) / n / n; };
    const counted one(1);
    // The linear terms are below 20 N: 0.02 of N^2.
    CHECK(in_squares([&] { taylor_by_sine_cosine(start(parity::even), n, one); }) == Approx(1. / 2).margin(0.02));
    CHECK(in_squares([&] { taylor_by_symmetric_squares(start(parity::even), n, one); }) ==
          Approx(3. / 16).margin(0.02));
    CHECK(in_squares([&] { taylor_by_symmetric_squares(start(parity::odd), n, one); }) == Approx(3. / 16).margin(0.02));
    CHECK(in_squares([&] { taylor_by_speed(start(parity::even), n, one); }) == Approx(3. / 16).margin(0.02));
    CHECK(in_squares([&] { taylor_by_speed(start(parity::any), n, one); }) == Approx(3. / 4).margin(0.02));
    CHECK(in_squares([&] { taylor_by_arcsine(start(parity::any), n, one); }) == Approx(3. / 2).margin(0.02));
    CHECK(in_squares([&] { taylor_by_arcsine(start(parity::even), n, one); }) == Approx(3. / 8).margin(0.02));
}

}  // namespace scalar_counted_test
