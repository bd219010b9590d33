#include "libration/convergence/coefficient_pattern.hpp"

#include <catch2/catch.hpp>
#include <functional>

#include "scalars.hpp"

namespace convergence_coefficient_pattern_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;

namespace {

power_series<double> list(int order, const std::function<bool(int)>& present) {
    auto a = power_series<double>::zero(order);
    for (int n = 0; n <= order; ++n) {
        a[n] = present(n) ? (n % 2 == 0 ? 1 : -2) : 0;
    }
    return a;
}

coefficient_pattern of(const power_series<double>& a) { return pattern_of(a, 1e-16); }

}  // namespace

TEST_CASE("classes of indices are found, with exceptions at the beginning", "[convergence][coefficient_pattern]") {
    for (int stride = 1; stride <= 6; ++stride) {
        for (int first = 0; first < stride; ++first) {
            const auto found = of(list(60, [&](int n) { return n % stride == first || n == 0; }));
            INFO(stride << " " << first);
            CHECK(found.stride == stride);
            CHECK(found.first == first);
            CHECK(found.exceptions == 0);  // a constant is none
            CHECK(found.zeros == 0);
            CHECK_FALSE(found.lacunary);
            CHECK_FALSE(found.polynomial);
        }
    }
    const auto found = of(list(60, [](int n) { return n % 4 == 2 || n == 5 || n == 7; }));
    CHECK(found.stride == 4);
    CHECK(found.first == 2);
    CHECK(found.exceptions == 2);
    CHECK(found.text() == "only n = 2 mod 4 are nonzero, with 2 exceptions in the first quarter");
}

TEST_CASE("zeros inside of a class are counted and do not hide it", "[convergence][coefficient_pattern]") {
    // 1/(1 + x + x^2): 1, -1, 0, 1, -1, 0, ...
    const auto found = of(list(59, [](int n) { return n % 3 != 2; }));
    CHECK(found.stride == 1);
    CHECK(found.zeros == 15);  // n = 17, 20, ..., 59
    CHECK(found.text() == "no pattern of zeros, and 15 further zeros");
}

TEST_CASE("what rounding leaves of a zero is one", "[convergence][coefficient_pattern]") {
    auto a = list(40, [](int n) { return n % 2 == 0; });
    for (int n = 1; n <= 40; n += 2) {
        a[n] = 1e-16 * n;
    }
    CHECK(of(a).stride == 2);
    CHECK(pattern_of(a, 1e-20).stride == 1);
}

TEST_CASE("growing gaps make a lacunary series", "[convergence][coefficient_pattern]") {
    const auto power_of_two = [](int n) { return n > 0 && (n & (n - 1)) == 0; };
    const auto square = [](int n) {
        for (int k = 0; k * k <= n; ++k) {
            if (k * k == n) {
                return true;
            }
        }
        return false;
    };
    for (const int order : {30, 50, 100, 127, 128, 200, 400}) {
        INFO(order);
        CHECK(of(list(order, power_of_two)).lacunary);
        CHECK(of(list(order, square)).lacunary);
        CHECK_FALSE(of(list(order, [](int n) { return n % 6 == 1; })).lacunary);
    }
}

TEST_CASE("a polynomial, nothing at all, and too little", "[convergence][coefficient_pattern]") {
    const auto polynomial = of(list(40, [](int n) { return n <= 7; }));
    CHECK(polynomial.polynomial);
    CHECK(polynomial.last == 7);
    CHECK(polynomial.text() == "all coefficients after n = 7 are 0");
    const auto nothing = of(power_series<double>::zero(10));
    CHECK(nothing.last == -1);
    CHECK(nothing.text() == "all coefficients are 0");
    CHECK(of(power_series<double>({3})).last == 0);
    CHECK(of(power_series<double>({1, 2})).stride == 1);
    CHECK(of(power_series<double>({0, 2})).stride == 1);
}

}  // namespace convergence_coefficient_pattern_test
