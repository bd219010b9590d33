// Series in the variables of Euler's map and of the map of the cut plane, against functions that become rational there.
#include "libration/approximant/conformal_map.hpp"

#include <catch2/catch.hpp>

#include "libration/scalar/precision_scope.hpp"

namespace approximant_conformal_map_test {

using namespace libration;

TEST_CASE("log(1 + x/R) is -log(1 - w) in Euler's variable", "[approximant][conformal map]") {
    const precision_scope scope(60);
    const mpfr R = mpfr(3) / 2;
    std::vector<mpfr> a{mpfr(0)};
    mpfr power(1);
    for (int n = 1; n <= 20; ++n) {
        power /= -R;
        a.push_back(-power / n);
    }
    const auto c = in_euler_variable(series::power_series<mpfr>(a), R);
    CHECK(c[0] == 0);
    for (int m = 1; m <= 20; ++m) {
        CHECK(abs(mpfr(c[m] * m - 1)) < mpfr("1e-50"));
    }
    const mpfr x = mpfr(7) / 3;
    const mpfr w = euler_variable(x, R);
    CHECK(abs(mpfr(w * R / (1 - w) - x)) < mpfr("1e-55"));
}

TEST_CASE("1/(1 + x/R) is (1 - w)^2/(1 + w)^2 in the variable of the cut plane", "[approximant][conformal map]") {
    const precision_scope scope(60);
    const mpfr R = mpfr(3) / 2;
    std::vector<mpfr> a{mpfr(1)};
    for (int n = 1; n <= 20; ++n) {
        a.push_back(-a.back() / R);
    }
    const auto c = in_cut_variable(a, R);
    CHECK(c[0] == 1);
    for (int m = 1; m <= 20; ++m) {
        CHECK(abs(mpfr(c[static_cast<std::size_t>(m)] - (m % 2 == 0 ? 4 * m : -4 * m))) < mpfr("1e-45"));
    }
    const mpfr x = mpfr(7) / 3;
    const mpfr w = cut_variable(x, R);
    CHECK(abs(mpfr(w * R * 4 / ((1 - w) * (1 - w)) - x)) < mpfr("1e-55"));
    // Not a function of later coefficients.
    a.resize(6);
    CHECK(in_cut_variable(a, R)[5] == c[5]);
}

}  // namespace approximant_conformal_map_test
