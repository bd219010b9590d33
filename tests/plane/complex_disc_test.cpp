// Discs of theorems T and V along paths in the complex plane, compared with closed forms on every sheet that they
// reach.
#include "libration/plane/complex_disc.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/complex_functions.hpp"
#include "proved.hpp"

namespace plane_complex_disc_test {

using namespace libration;
using namespace libration::ode;

namespace {

complex_ball at(int re, int im, int of) {
    return {from_rational<ball>(rational(re, of)), from_rational<ball>(rational(im, of))};
}

bool holds(const complex_ball& outside, const complex_ball& value) {
    return overlaps(outside.re, value.re) && overlaps(outside.im, value.im);
}

// Along straight segments through the corners, in steps of half a radius.
complex_set moved(const complex_flow& flow, complex_set now, const std::vector<complex_ball>& corners) {
    for (const complex_ball& corner : corners) {
        for (bool arrived = false; !arrived;) {
            const complex_disc disc(flow, now);
            const complex_ball way = corner - now.offset;
            const magnitude length = size_of(way);
            const magnitude longest = disc.radius() * magnitude::of(1, -1);
            arrived = length <= longest;
            const ball part = arrived ? ball(1) : ball(longest.exact() / length.exact());
            const complex_ball next = now.offset + way * part;
            now = disc.moved_to(arrived ? corner : complex_ball{exact_midpoint(next.re), exact_midpoint(next.im)});
        }
    }
    return now;
}

complex_set moved(const complex_flow& flow, const std::vector<complex_ball>& corners) {
    return moved(flow, flow.start(), corners);
}

}  // namespace

// y = 1/(7/3 - t), and the tangent, round their poles; the radius proved about each point is below the distance.
TEST_CASE("discs follow closed forms round poles", "[ode][proved][singularity]") {
    const precision_scope scope(60);
    const complex_flow riccati(explicit_system(parse("y' = y^2; y(0) = 3/7")), 180);
    const complex_ball target = at(5, 1, 1);
    const complex_set there = moved(riccati, {at(1, 2, 1), at(4, 2, 1), target});
    const complex_ball exact = complex_ball(ball(1)) / (complex_ball(ball(7) / 3) - target);
    const complex_ball value = values_of(there)[0];
    CHECK(holds(value, exact));
    CHECK(certainly_less(radius_of(value.re), pow(ball(10), -45)));

    const complex_flow tangent(explicit_system(parse("y' = 1 + y^2; y(0) = 0")), 180);
    const complex_set beyond = moved(tangent, {at(1, 1, 1), at(3, 1, 1), at(3, 0, 1)});
    CHECK(holds(values_of(beyond)[0], tan(at(3, 0, 1))));
    const ball distance = abs(ball(3) - pi<ball>() / 2);
    CHECK(certainly_less(complex_disc(tangent, beyond).radius().exact(), distance));
}

// y = (1 + 2t/3)^(3/2) solves y' = y^(1/3): once round t = -3/2 it is -1 at the initial point, and 1 after two turns.
// The root is continued along the path, because the principal one of y would jump.
TEST_CASE("discs go to other sheets", "[ode][proved][singularity]") {
    const precision_scope scope(60);
    const complex_flow flow(explicit_system(parse("y' = y^(1/3); y(0) = 1")), 100);
    const std::vector<complex_ball> turn{at(-3, 3, 2), at(-6, 0, 2), at(-3, -3, 2), at(0, 0, 1)};
    std::vector<complex_ball> twice = turn;
    twice.insert(twice.end(), turn.begin(), turn.end());
    CHECK(holds(values_of(moved(flow, turn))[0], complex_ball(-1)));
    CHECK(holds(values_of(moved(flow, twice))[0], complex_ball(1)));
}

// An inexact initial value widens the set as the derivative of the flow does, 1/(1 - t/3)^2 for y' = y^2 from 1/3.
TEST_CASE("uncertain starts are carried in the frame", "[ode][proved][singularity]") {
    const precision_scope scope(60);
    const complex_flow few(explicit_system(parse("y' = y^2; y(0) = 1/3")), 100);  // 1/3 to 100 bits
    const complex_set there = moved(few, {at(2, 1, 1)});
    const complex_ball value = values_of(there)[0];
    CHECK(holds(value, complex_ball(ball(1)) / (complex_ball(ball(3)) - at(2, 1, 1))));
    CHECK_FALSE(is_exact(value.re));
    // |1 - t/3|^-2 = 9/2 times 2^-100 of a third, and at most 64 times as much.
    CHECK(certainly_less(radius_of(value.re), ball(64 * 3) * pow(ball(2), -101)));
}

// 1/(1 - z) from the exact initial value 1, by one step of 9/10 of the proved radius: with 100 bits the series omits
// more than 2^-40 there, so that without its tail the enclosure would not contain the value.
TEST_CASE("a long step holds what its series leaves out", "[ode][proved][singularity]") {
    const precision_scope scope(60);
    const complex_flow flow(explicit_system(parse("y' = y^2; y(0) = 1")), 100);
    const complex_disc disc(flow, flow.start());
    const ball far = exact_midpoint(disc.radius().exact() * 9 / 10);
    const complex_ball value = values_of(disc.moved_to(complex_ball(far)))[0];
    CHECK(holds(value, complex_ball(ball(1) / (ball(1) - far))));
    CHECK(certainly_less(pow(ball(2), -60), radius_of(value.re)));
}

// 1/3 is not representable in 100 bits.
TEST_CASE("a start that is rounded has its width", "[ode][proved][singularity]") {
    const complex_flow flow(explicit_system(parse("y' = y^2; y(0) = 1/3")), 100);
    const precision_scope scope(90);
    CHECK(holds(values_of(flow.start())[0], complex_ball(ball(1) / 3)));
}

// From the initial values 1 + i e, |e| <= d, by 2i/5 to 2/5: there 1/(1/(1 + i e) - 2/5) is 25/9 i e off 5/3 to first
// order. Along the path the derivative of the flow rotates by 44 degrees and back: a map that rotated errors in the
// other direction would leave a twentieth of it.
TEST_CASE("an imaginary error turns with the flow", "[ode][proved][singularity]") {
    const precision_scope scope(60);
    const complex_flow flow(explicit_system(parse("y' = y^2; y(0) = 1")), 150);
    const magnitude d = magnitude::of(1, -30);
    complex_set now{complex_ball(0), {complex_ball(1)}, {0}, lohner_set({magnitude(), d})};
    for (const complex_ball& corner : {at(0, 1, 5), at(0, 2, 5), at(1, 1, 5), at(2, 0, 5)}) {
        const complex_ball to{exact_midpoint(corner.re), exact_midpoint(corner.im)};
        now = complex_disc(flow, now).moved_to(to);
    }
    const complex_ball end = now.offset;
    const complex_ball start{ball(1), d.exact()};
    CHECK(holds(values_of(now)[0], complex_ball(1) / (complex_ball(1) / start - end)));
    // 25/9 d, and at most half as much again.
    CHECK(certainly_less(radius_of(values_of(now)[0].im), d.exact() * 25 / 6));
}

// int dz/(7/3 - z) = -log(1 - 3 z/7), and with the weight ((z - 1)/2)^2.
TEST_CASE("integrals along a step", "[ode][proved][singularity]") {
    const precision_scope scope(30);
    const complex_flow flow(explicit_system(parse("y' = y^2; y(0) = 3/7")), 120);
    const complex_disc disc(flow, flow.start());
    const complex_ball z = at(1, 1, 1);
    const complex_ball pole(ball(7) / 3);
    const complex_ball plain = -log(complex_ball(1) - z / pole);
    CHECK(holds(disc.integral(0, z, complex_ball(0), ball(1), 0), plain));
    // (z - 1)^2 = (p - z)^2 - 2 (p - 1)(p - z) + (p - 1)^2 with p the pole.
    const complex_ball q = pole - complex_ball(1);
    const complex_ball half = pole * z - z * z / 2;
    const complex_ball weighted = (half - q * z * 2 + q * q * plain) / 4;
    CHECK(holds(disc.integral(0, z, complex_ball(1), ball(2), 2), weighted));
}

// sin(t)/t and (1 + t^2/3)^(-1/2), whose radius is sqrt(3): the disc about 0 is one of theorem S, the following ones of
// theorem T. Of 150 bits the first step retains 120, and a dozen steps of half a radius 110.
TEST_CASE("discs lead away from a singular start", "[ode][proved][singularity]") {
    const precision_scope scope(60);
    const std::string text = "t*y'' + 2*y' + t*y^n = 0; y(0) = 1; y'(0) = 0; ";
    const auto sinc = [](const complex_ball& t) { return sin(t) / t; };
    const auto plummer = [](const complex_ball& t) { return exp(-log(complex_ball(1) + t * t / complex_ball(3)) / 2); };
    const auto follow = [&](const char* n, const auto& exact) {
        const complex_flow flow(explicit_system(parse(text + n)), 150);
        const complex_disc about_start(flow);
        CHECK(certainly_less(ball(1), about_start.radius().exact()));
        complex_set now = about_start.moved_to(exact_midpoint(at(1, 1, 2)));
        CHECK(holds(values_of(now)[0], exact(now.offset)));
        CHECK(certainly_less(radius_of(values_of(now)[0].re), pow(ball(2), -120)));
        for (const complex_ball& corner : {at(1, 5, 5), at(5, 5, 5), at(7, 3, 5)}) {
            now = moved(flow, now, {exact_midpoint(corner)});
            CHECK(holds(values_of(now)[0], exact(now.offset)));
            CHECK(certainly_less(radius_of(values_of(now)[0].re), pow(ball(2), -110)));
        }
    };
    follow("n = 1", sinc);
    follow("n = 5", plummer);
    const complex_flow flow(explicit_system(parse(text + "n = 5")), 150);
    const complex_disc about_start(flow);
    CHECK(certainly_less(about_start.radius().exact(), sqrt(ball(3))));
    CHECK_THROWS_AS(about_start.integral(0, at(1, 0, 2), complex_ball(0), ball(1), 0), error);
}

}  // namespace plane_complex_disc_test
