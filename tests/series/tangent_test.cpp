#include "libration/series/tangent.hpp"

#include <catch2/catch.hpp>

#include "proved.hpp"
#include "scalars.hpp"

namespace series_tangent_test {

using namespace libration;
using namespace libration::series;
using namespace libration::tests;

namespace {

constexpr int order = 14;

// Positive, like a function that is singular at |x| = 4.
template <class T>
power_series<T> positive(int first_in_eighths) {
    auto f = power_series<T>::zero(order);
    f[0] = T(first_in_eighths) / 8;
    for (int n = 1; n <= order; ++n) {
        f[n] = T((n * 5) % 7 + 1) / 8;
        for (int k = 0; k < n; ++k) {
            f[n] /= 4;
        }
    }
    return f;
}

template <class T>
power_series<T> one() {
    auto f = power_series<T>::zero(order);
    f[0] = T(1);
    return f;
}

}  // namespace

// All terms of the recurrence of tan are positive where f is, so each coefficient is right to a few epsilon times its
// degree; the others are measured against the tangent as a majorant.
TEMPLATE_LIST_TEST_CASE("tan is sin over cos, and its slope (1 + tan^2) f'", "[series][tangent]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto f = positive<T>(3);
    const auto t = tangent(f);
    const auto [s, c] = sine_cosine(f);
    const auto ratio = s / c;
    const auto slope = derivative(t);
    const auto expected = derivative(f) * (one<T>() + t * t);
    for (int n = 0; n <= order; ++n) {
        INFO("degree " << n);
        // exp f majorises sin and cos, and the quotient divides by cos f_0 > 9/10: below tan times 16 here.
        CHECK_THAT(ratio[n], near<T>(t[n], 16, t[n]));
        if (n < order) {
            CHECK_THAT(slope[n], near<T>(expected[n], 8));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("arctangent undoes the tangent, hyperbolic tangent is that of exponentials",
                        "[series][tangent]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto f = positive<T>(3);
    const auto back = arctangent(tangent(f));
    const auto h = hyperbolic_tangent(f);
    const auto e = exponential(f + f);
    const auto of_exponentials = (e - one<T>()) / (e + one<T>());
    const auto majorant = tangent(f);
    for (int n = 0; n <= order; ++n) {
        INFO("degree " << n);
        CHECK_THAT(back[n], near<T>(f[n], 16, majorant[n]));
        CHECK_THAT(h[n], near<T>(of_exponentials[n], 16, majorant[n]));
    }
}

TEST_CASE("on balls the tangents contain each other", "[series][tangent][ball]") {
    const precision_scope scope(40);
    const auto f = positive<ball>(3);
    const auto back = arctangent(tangent(f));
    const auto [s, c] = sine_cosine(f);
    const auto ratio = s / c;
    const auto t = tangent(f);
    for (int n = 0; n <= order; ++n) {
        INFO("degree " << n);
        CHECK(contains(back[n], midpoint(f[n])));
        CHECK(overlaps(ratio[n], t[n]));
        CHECK(certainly_less(radius_of(t[n]), ldexp(ball(1), -100)));
    }
}

}  // namespace series_tangent_test
