#include "libration/approximant/damped_pade.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace approximant_damped_pade_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;
using libration::tests::near;

TEST_CASE("what damping leaves of a series over fractions", "[approximant][asymptotic]") {
    // f - 3 = e^(-2t)/(1 + t)^2, by series of the exponential and of the square of the geometric one.
    auto f = power_series<rational>::zero(8);
    rational exponential = 1;
    std::vector<rational> decay;
    for (int n = 0; n <= 8; ++n) {
        decay.push_back(exponential);
        exponential *= rational(-2, n + 1);
        for (int k = 0; k <= n; ++k) {
            f[n] += decay[static_cast<std::size_t>(n - k)] * ((k % 2 == 0 ? 1 : -1) * (k + 1));
        }
    }
    f[0] += 3;
    const auto left = undamped(f, damping<rational>{3, 2, 2});
    for (int n = 0; n <= 8; ++n) {
        CHECK(left[n] == (n == 0 ? 1 : 0));
    }
}

TEMPLATE_LIST_TEST_CASE("a damped rational function is recovered", "[approximant][asymptotic]", all_scalars) {
    using T = typename TestType::type;
    using std::exp;
    using std::sqrt;
    const typename TestType::precision precision;
    // f = 2 + e^(-t/2) (1 + t)^(-1/2) (1 + 3 t)/(1 + t/2)
    auto rational_part = power_series<T>::zero(6);
    rational_part[0] = T(1);
    rational_part[1] = T(5) / 2;
    for (int n = 2; n <= 6; ++n) {
        rational_part[n] = -rational_part[n - 1] / 2;
    }
    auto f = undamped(rational_part, damping<T>{T(0), T(-1) / 2, T(-1) / 2});
    f[0] += 2;
    const auto of = *damped_pade<T>::of(f, 1, {T(2), T(1) / 2, T(1) / 2});
    CHECK_THAT(of.value(T(3)), near(T(2 + exp(T(T(-3) / 2)) / 2 * 4), 100));
    // d log: -1/2 - 1/8 + 3/10 - 1/5
    const T slope = exp(T(T(-3) / 2)) * 2 * (T(-21) / 40);
    CHECK_THAT(of(T(3)).slope, near(slope, 400));
    CHECK_FALSE(damped_pade<T>::of(power_series<T>::zero(2), 1, {T(0), T(1), T(0)}).has_value());
}

}  // namespace approximant_damped_pade_test
