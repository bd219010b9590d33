// Discs compared with tan t = sin 2x/(cos 2x + cosh 2y) + i sinh 2y/(..) in balls.
#include "libration/plane/series_disc.hpp"

#include <catch2/catch.hpp>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace plane_series_disc_test {

using namespace libration;
using namespace libration::ode;

namespace {

complex_ball tangent_at(const complex_ball& z) {
    const ball x = z.re * 2;
    const ball y = z.im * 2;
    const ball below = cos(x) + cosh(y);
    return {sin(x) / below, sinh(y) / below};
}

}  // namespace

TEST_CASE("a chain of discs for the tangent", "[ode][proved][plane]") {
    const precision_scope scope(40);
    const explicit_system system(parse("y' = 1 + y^2; y(0) = 0"));
    const plane_system points(system);
    series_disc disc(points, complex_ball(0), carried_start(system, points), 60);
    for (const std::complex<double> z : {std::complex<double>(0.3, 0.4), {0.7, 0.9}, {1.2, 1.1}}) {
        const complex_ball place = exact_point(z);
        const auto value = disc.at(place);
        const complex_ball exact = tangent_at(place);
        CHECK(overlaps(value[0].re, exact.re));
        CHECK(overlaps(value[0].im, exact.im));
        CHECK(certainly_less(radius_of(value[0].re), pow(ball(10), -12L)));
        const magnitude by = magnitude::of(1, -6);
        const complex_ball wide{widened(place.re, by), widened(place.im, by)};
        const auto over = disc.over(wide);
        for (const double side : {-1.0, 1.0}) {
            const complex_ball corner = tangent_at(exact_point(z + std::complex<double>(side, -side) / 64.0));
            CHECK(contains(over[0].re, corner.re));
            CHECK(contains(over[0].im, corner.im));
        }
        disc = series_disc(points, place, value, 60);
        // The disc of convergence ends at pi/2.
        CHECK(mag_get_d(disc.radius().handle()) < std::abs(z - 1.5707963267948966));
    }
}

TEST_CASE("no value is given outside a disc", "[ode][proved][plane]") {
    const precision_scope scope(40);
    const explicit_system system(parse("y' = y^2; y(0) = 1"));
    const plane_system points(system);
    const series_disc disc(points, complex_ball(0), carried_start(system, points), 40);
    CHECK_THROWS_AS(disc.at(complex_ball(1)), precision_exhausted);
    CHECK_THROWS_AS(disc.over(complex_ball(-1)), precision_exhausted);
}

}  // namespace plane_series_disc_test
