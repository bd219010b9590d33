#include "libration/approximant/difference_norm.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <tuple>

#include "scalars.hpp"

namespace approximant_difference_norm_test {

using namespace libration;
using namespace libration::series;
using libration::tests::near;

namespace {

// Without quad: the bracketing method of Boost 1.81 asks for std::numeric_limits<quad>::min(), which does not compile
// in strict C++20 (__float128 converts to quad in GNU mode alone).
using all_scalars = std::tuple<tests::scalar_tag<double>, tests::scalar_tag<long double>, tests::scalar_tag<mpfr>>;

tests::expected_value fraction(long numerator, long denominator) {
    const precision_scope scope(200);
    return tests::exactly(mpfr(mpfr(numerator) / denominator));
}

// x (1-x)^2, largest at 1/3 with 4/27.
const auto hump = []<class T>(const T& x) {
    const T rest = 1 - x;
    return jet<T>{x * rest * rest, rest * (1 - x * 3)};
};

// The Chebyshev polynomial T_n of 2x - 1 by its recurrence, with its derivative.
struct chebyshev {
    int degree;
    template <class T>
    jet<T> operator()(const T& x) const {
        const T y = x * 2 - 1;
        jet<T> before{T(1), T(0)};
        jet<T> at{y, T(2)};
        for (int n = 2; n <= degree; ++n) {
            const jet<T> next{y * at.value * 2 - before.value, (at.value * 2 + y * at.slope) * 2 - before.slope};
            before = at;
            at = next;
        }
        return at;
    }
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("a maximum between grid points is found with all digits of its place",
                        "[approximant][difference_norm]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto points = chebyshev_points(11);
    const auto found = difference_norm<T>(hump, points);
    // Four roundings of half an epsilon in the value; the place is half of a bracket of 4 epsilon, and what the slope
    // is rounded by (1 epsilon at most) over f'' = -2.
    CHECK_THAT(found.norm, near<T>(fraction(4, 27), 2));
    CHECK_THAT(found.place, near<T>(fraction(1, 3), 3, T(1)));
    // The grid alone would be wrong in the fourth digit.
    T on_grid(0);
    for (const double x : points) {
        on_grid = std::max(on_grid, hump(T(x)).value);
    }
    CHECK((found.norm - on_grid) * 10'000 > found.norm);
}

TEMPLATE_LIST_TEST_CASE("the norm knows no sign, and does not depend on the grid", "[approximant][difference_norm]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto zero = [](const T&) { return jet<T>{T(0), T(0)}; };
    const auto found = difference_norm<T>(hump, chebyshev_points(1001));
    const auto negative = difference_norm<T>(difference(zero, hump), chebyshev_points(5));
    CHECK_THAT(negative.norm, near<T>(found.norm, 2 * 2));  // both with the errors of the case above
    CHECK_THAT(negative.place, near<T>(found.place, 2 * 3, T(1)));
    const auto none = difference_norm<T>(difference(hump, hump), chebyshev_points(5));
    CHECK(none.norm == 0);
}

TEMPLATE_LIST_TEST_CASE("a maximum at an end of the interval is found there", "[approximant][difference_norm]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto parabola = [](const T& x) { return jet<T>{x * x - x / 2, x * 2 - T(1) / 2}; };
    const auto right = difference_norm<T>(parabola, chebyshev_points(7));
    CHECK(right.norm == T(1) / 2);
    CHECK(right.place == 1);
    const auto mirrored = [&](const T& x) {
        const jet<T> at = parabola(1 - x);
        return jet<T>{at.value, -at.slope};
    };
    const auto left = difference_norm<T>(mirrored, chebyshev_points(7));
    CHECK(left.norm == T(1) / 2);
    CHECK(left.place == 0);
}

TEMPLATE_LIST_TEST_CASE("all stationary points of a Chebyshev polynomial are found", "[approximant][difference_norm]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const chebyshev f{9};
    const auto points = chebyshev_points(30);
    std::vector<jet<T>> jets;
    jets.reserve(points.size());
    for (const double x : points) {
        jets.push_back(f(T(x)));
    }
    const auto places = stationary_points<T>(f, points, jets);
    REQUIRE(places.size() == 8);
    for (int i = 1; i <= 8; ++i) {
        // (1 - cos(i pi/9))/2 = sin^2(i pi/18).
        const auto known = [&] {
            const precision_scope scope(200);
            const mpfr root = sin(pi<mpfr>() * i / 18);
            return tests::exactly(mpfr(root * root));
        }();
        INFO(i);
        const T& place = places[static_cast<std::size_t>(i) - 1];
        CHECK_THAT(place, near<T>(known, 3, T(1)));                             // as above; here f'' is larger than 100
        CHECK_THAT(f(place).value, near<T>(T(i % 2 == 0 ? -1 : 1), f.degree));  // a rounding in each step
    }
    CHECK_THAT(difference_norm<T>(f, points).norm, near<T>(T(1), f.degree));
}

TEMPLATE_LIST_TEST_CASE("a difference subtracts values and slopes", "[approximant][difference_norm]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const chebyshev square{2};  // 2 y^2 - 1, y = 2x - 1
    const chebyshev line{1};
    const jet<T> at = difference(square, line)(T(T(3) / 4));
    CHECK(at.value == -1);  // (1/2 - 1) - 1/2
    CHECK(at.slope == 2);   // 8 y - 2
}

TEST_CASE("Chebyshev points run from 0 to 1, crowd at both ends, and nest", "[approximant][difference_norm]") {
    const auto coarse = chebyshev_points(51);
    const auto fine = chebyshev_points(101);
    REQUIRE(coarse.size() == 51);
    CHECK(coarse.front() == 0);
    CHECK(coarse.back() == 1);
    CHECK(chebyshev_points(2) == std::vector<double>{0, 1});
    const precision_scope scope(50);
    for (std::size_t j = 0; j < coarse.size(); ++j) {
        INFO(j);
        CHECK(coarse[j] == fine[2 * j]);
        const mpfr exact = (1 - cos(pi<mpfr>() * static_cast<int>(j) / 50)) / 2;
        // The square doubles half an epsilon each of pi, product, quotient and sine, and adds its own.
        CHECK_THAT(coarse[j], near<double>(tests::exactly(exact), 5));
        CHECK_THAT(coarse[j] + coarse[coarse.size() - 1 - j], near<double>(1.0, 5));
    }
    CHECK(std::is_sorted(fine.begin(), fine.end()));
}

TEST_CASE("what is not a number has no norm, and two ends are the fewest points", "[approximant][difference_norm]") {
    const auto nowhere = [](const double& x) { return jet<double>{(x - x) / (x - x), x}; };
    CHECK_THROWS_AS(difference_norm<double>(nowhere, chebyshev_points(5)), libration::error);
    CHECK_THROWS_AS(chebyshev_points(1), libration::error);
}

TEST_CASE("a turn far below the largest value is not sought, one that may exceed it is", "[difference_norm]") {
    const jet<double> rising{0.5, 10};
    const jet<double> falling{0.5, -10};
    CHECK(turns_between(rising, falling));
    CHECK_FALSE(turns_between(rising, rising));
    CHECK_FALSE(turns_between(rising, jet<double>{1, 0}));
    // The cubic through both over a width of 0.1 reaches 0.5 + 0.25 * 10 * 0.1 = 0.75.
    CHECK(may_exceed(0.75, rising, falling, 0.1));
    CHECK_FALSE(may_exceed(3.0, rising, falling, 0.1));
    CHECK(may_exceed(0.45, jet<double>{-0.5, -1e-9}, jet<double>{-0.5, 1e-9}, 0.1));
}

}  // namespace approximant_difference_norm_test
