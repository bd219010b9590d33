#include "libration/pendulum/runge_kutta.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/exact_solution.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_runge_kutta_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
jet<T> start() {
    return {from_rational<T>(fraction("2.5")), from_rational<T>(rational(-3, 10))};
}

// |theta - exact| at t = 2 with 2/h steps.
mpfr error_with(const rational& h) {
    runge_kutta_march<mpfr> march(start<mpfr>(), from_rational<mpfr>(h));
    const mpfr expected = exact_solution<mpfr>(with_state("2.5", "-0.3"))(read_exact("2")).theta;
    return abs(march.advance_to(mpfr(2)).value - expected);
}

}  // namespace

TEST_CASE("halving the step divides the error by 2^4, and of one step by 2^5", "[runge_kutta]") {
    const precision_scope precision(40);
    const mpfr ratio = error_with(rational(1, 64)) / error_with(rational(1, 128));
    CHECK(ratio > 15);
    CHECK(ratio < 17);
    const exact_solution<mpfr> solution(with_state("2.5", "-0.3"));
    const auto local_error = [&](const rational& h) {
        const mpfr expected = solution(libration::exactly(h)).theta;
        return mpfr(abs(runge_kutta_step(start<mpfr>(), from_rational<mpfr>(h)).value - expected));
    };
    const mpfr local_ratio = local_error(rational(1, 128)) / local_error(rational(1, 256));
    CHECK(local_ratio > 31);
    CHECK(local_ratio < 33);
}

TEMPLATE_LIST_TEST_CASE("one step is exact to the fourth power of its length", "[runge_kutta]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::cos;
    using std::sin;
    // theta + h w - h^2 s/2 - h^3 c w/6 + h^4 s (w^2 + c)/24 + O(h^5), h^5 beyond all digits.
    const T h = from_rational<T>(fraction("1e-24"));
    const jet<T> from{T(1), from_rational<T>(rational(1, 2))};
    const jet<T> to = runge_kutta_step(from, h);
    const T s = sin(T(1));
    const T c = cos(T(1));
    const T w = from.slope;
    const T moved = h * w - h * h * s / 2 - h * h * h * c * w / 6 + h * h * h * h * s * (w * w + c) / 24;
    CHECK_THAT(to.value, near<T>(T(T(1) + moved), 1));
    const T gained = -h * s - h * h * c * w / 2 + h * h * h * s * (w * w + c) / 6 +
                     h * h * h * h * w * (c * w * w + c * c - s * s * 3) / 24;
    CHECK_THAT(to.slope, near<T>(T(w + gained), 1));
}

TEMPLATE_LIST_TEST_CASE("the march agrees with the exact solution as far as its order goes", "[runge_kutta]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    const exact_solution<T> solution(with_state("2.5", "-0.3"));
    runge_kutta_march<T> march(start<T>(), from_rational<T>(rational(1, 100)));
    for (const std::string time : {"0", "0.3", "1.234567", "5", "4", "-1"}) {
        INFO(time);
        const jet<T> y = march.advance_to(from_rational<T>(time[0] == '-' ? rational(-1) : fraction(time)));
        const auto expected = solution(read_exact(time));
        const T allowed = from_rational<T>(fraction("1e-7"));  // (h^4 = 1e-8) times the time and a derivative
        CHECK(abs(T(y.value - expected.theta)) <= allowed);
        CHECK(abs(T(y.slope - expected.omega)) <= allowed);
    }
}

TEMPLATE_LIST_TEST_CASE("no time is no motion", "[runge_kutta]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    runge_kutta_march<T> march(start<T>(), from_rational<T>(rational(1, 100)));
    const jet<T> y = march.advance_to(T(0));
    CHECK(y.value == start<T>().value);
    CHECK(y.slope == start<T>().slope);
    CHECK(runge_kutta_step(start<T>(), T(0)).value == start<T>().value);
}

TEMPLATE_LIST_TEST_CASE("forward and back again returns to the start", "[runge_kutta]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    runge_kutta_march<T> march(start<T>(), from_rational<T>(rational(1, 100)));
    march.advance_to(T(3));
    const jet<T> y = march.advance_to(T(0));
    const T allowed = from_rational<T>(fraction("1e-9"));  // the fourth-order errors cancel, h^5 = 1e-10 remains
    CHECK(abs(T(y.value - start<T>().value)) <= allowed);
    CHECK(abs(T(y.slope - start<T>().slope)) <= allowed);
}

TEMPLATE_LIST_TEST_CASE("equilibria stay, and the mirror image marches as the mirror image", "[runge_kutta]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T step = from_rational<T>(rational(1, 10));
    CHECK(runge_kutta_march<T>({T(0), T(0)}, step).advance_to(T(5)).value == 0);
    const jet<T> s = start<T>();
    const jet<T> forward = runge_kutta_march<T>(s, step).advance_to(T(5));
    const jet<T> mirrored = runge_kutta_march<T>({T(-s.value), T(-s.slope)}, step).advance_to(T(5));
    CHECK(mirrored.value == -forward.value);
    CHECK(mirrored.slope == -forward.slope);
}

TEMPLATE_LIST_TEST_CASE("more steps than anyone waits for are refused", "[runge_kutta]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    runge_kutta_march<T> march(start<T>(), from_rational<T>(fraction("1e-12")));
    CHECK_THROWS_AS(march.advance_to(T(1)), libration::error);
    CHECK_THROWS_AS(march.advance_to(T(-1)), libration::error);
}

}  // namespace pendulum_runge_kutta_test
