// Pade approximants of theta from the top.
#include "libration/pendulum/arc_pade.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/pendulum/error_norm.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_descent_pade_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

TEST_CASE("a Pade approximant has the coefficients of theta that it was made of", "[descent_pade]") {
    const precision_scope precision(120);
    for (const std::string energy : {"0.5", "1", "1.71", "2.02", "4"}) {
        INFO("E = " << energy);
        const fundamental_arc<mpfr> arc = arc_of<mpfr>(with_energy(energy));
        const int parity = arc.level().regime == regime::rotation ? 1 : 0;
        for (const int count : {1, 2, 5, 8}) {
            const auto f = pade_from_top(arc, count);
            // At x = 1e-6 the difference of the two is the first power beyond them.
            const mpfr x("1e-6");
            const int next = 2 * count - parity + 2;
            const auto series = series_from_top(arc, next + 20);
            CHECK(abs(f(x).value - series(x).value) < pow(x, next) * 10);
            CHECK(abs(f(x).slope - series(x).slope) < pow(x, next - 1) * 10 * next);
        }
    }
}

TEST_CASE("a pole on the way to the bottom is seen", "[descent_pade]") {
    const precision_scope precision(60);
    // From a_2 and a_4 alone Q(s) = 1 - s a_4/a_2, and theta'' = -sin(theta) makes its root t = (12/(E-1))^(1/2).
    for (const std::string energy : {"1.99", "1.999", "1.9999999999"}) {
        const fundamental_arc<mpfr> arc = arc_of<mpfr>(with_energy(energy));
        const auto pole = pade_from_top(arc, 2).first_pole();
        INFO("E = " << energy);
        REQUIRE(pole);
        // The end of the arc is a few units off, and a quotient of coefficients.
        CHECK_THAT(*pole, near(mpfr(sqrt(mpfr(12 / (mpfr(energy) - 1))) / arc.effective_period()), 100));
    }
    // Here it is beyond the bottom, or the poles are complex.
    CHECK_FALSE(pade_from_top(arc_of<mpfr>(with_energy("1.71")), 2).first_pole());
    CHECK_FALSE(pade_from_top(arc_of<mpfr>(with_energy("0.5")), 2).first_pole());
    CHECK_FALSE(pade_from_top(arc_of<mpfr>(with_energy("1.71")), 8).first_pole());
}

TEST_CASE("its slope is that of its value", "[descent_pade]") {
    const precision_scope precision(60);
    for (const std::string energy : {"0.5", "4"}) {
        const auto f = pade_from_top(arc_of<mpfr>(with_energy(energy)), 6);
        const mpfr x("0.7");
        const mpfr h("1e-20");
        CHECK(abs((f(mpfr(x + h)).value - f(mpfr(x - h)).value) / (h * 2) - f(x).slope) < mpfr("1e-35"));
    }
}

TEST_CASE("away from E = 2 it gains digits on the series with every coefficient", "[descent_pade]") {
    const precision_scope precision(120);
    for (const std::string energy : {"0.5", "1.71", "4"}) {
        INFO("E = " << energy);
        arc_errors errors(with_energy(energy));
        const int parity = errors.bounds().parity;
        const auto gain = [&](int count) {
            const mpfr series = errors.norm(arc_method::series, 2 * count - parity).norm;
            return mpfr(series / errors.norm_of(pade_from_top(errors.arc(), count), 2 * count).norm);
        };
        CHECK(gain(16) > 100);
        CHECK(gain(28) > gain(16) * 100);
    }
}

TEST_CASE("no coefficient makes no approximant", "[descent_pade]") {
    const precision_scope precision(30);
    CHECK_THROWS_AS(pade_from_top(arc_of<mpfr>(with_energy("1")), 0), libration::error);
}

}  // namespace pendulum_descent_pade_test
