// Paths in the complex t-plane: around a pole, around a branch point, and compared with the pendulum's closed form.
#include "libration/plane/path.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/digits/agreed_values.hpp"
#include "libration/elliptic/jacobi.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/invariant.hpp"
#include "libration/query/trajectory.hpp"
#include "scalars.hpp"

namespace plane_path_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::elliptic;
using namespace libration::tests;

namespace {

explicit_system solved(const std::string& text) { return explicit_system(parse(text)); }

complex_constant point(const std::string& text) { return parse_complex_constant(text); }

std::vector<complex_constant> points(const std::vector<std::string>& texts) {
    std::vector<complex_constant> all;
    for (const std::string& each : texts) {
        all.push_back(point(each));
    }
    return all;
}

// |value - expected| in epsilons.
template <class T>
T off(const complex_number<T>& value, const complex_number<T>& expected) {
    return modulus_of(complex_number<T>(value - expected)) / epsilon<T>();
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a way around a pole comes to the same value on both sides", "[ode][path]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // y = 1/(1 - t); some ten steps of some epsilon each.
    const auto system = solved("y' = y^2; y(0) = 1");
    for (const char* corner : {"1+i", "1-i"}) {
        const auto states = states_along<T>(system, points({corner}), points({"2", "2+i", "3/2", "0"}));
        CHECK(off(states[0][0][0], complex_number<T>(T(-1))) < 100);
        CHECK(off(states[1][0][0], {T(T(-1) / 2), T(T(1) / 2)}) < 100);
        CHECK(off(states[2][0][0], complex_number<T>(T(-2))) < 200);
        CHECK(off(states[3][0][0], complex_number<T>(T(1))) < 100);
    }
    // Without a corner the segment ends at the pole.
    CHECK_THROWS_WITH(states_along<T>(system, {}, points({"2"})),
                      Catch::Contains("is not reached by the straight line") && Catch::Contains("(1.0000"));
    CHECK(off(states_along<T>(system, {}, points({"1+i"}))[0][0][0], {T(0), T(1)}) < 100);
}

TEMPLATE_LIST_TEST_CASE("a way once around a branch point changes the sign of a root", "[ode][path]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto around = points({"-1+i", "-2", "-1-i"});
    const auto twice = points({"-1+i", "-2", "-1-i", "0", "-1+i", "-2", "-1-i"});
    // sqrt(1 + t) and 1/sqrt(1 + t): some fifty steps.
    for (const char* text : {"y' = 1/(2*y); y(0) = 1", "y' = -y^3/2; y(0) = 1"}) {
        const auto system = solved(text);
        CHECK(off(states_along<T>(system, around, points({"0"}))[0][0][0], complex_number<T>(T(-1))) < 500);
        CHECK(off(states_along<T>(system, twice, points({"0"}))[0][0][0], complex_number<T>(T(1))) < 1000);
    }
    // log(1 + t) gains 2 pi i, and its derivative is unchanged.
    const auto state = states_along<T>(solved("y'' = -y'^2; y(0) = 0; y'(0) = 1"), around, points({"0"}))[0][0];
    CHECK(off(state[0], {T(0), T(pi<T>() * 2)}) < 1000);
    CHECK(off(state[1], complex_number<T>(T(1))) < 500);
}

TEST_CASE("the pendulum around its singularities is its elliptic functions there", "[ode][path]") {
    // From the bottom with omega = 2 k: sin(x/2) = k sn, cos(x/2) = dn, with simple poles at t = i K' [DLMF 22.4],
    // where x has a logarithm. By the addition theorem sn(u + iv) = (s d1 + i c d s1 c1)/(c1^2 + k^2 s^2 s1^2), s, c, d
    // at u for k and s1, c1, d1 at v for k' [DLMF 22.8.1, 22.6.1].
    const precision_scope precision(50);
    const auto system = solved("x'' = -sin(x); x(0) = 0; x'(0) = 6/5");
    const auto m = modulus<mpfr>::from_modulus(mpfr(mpfr(3) / 5));
    const auto other = modulus<mpfr>::from_modulus(mpfr(mpfr(4) / 5));  // K' = 1.995..
    const mpfr u = mpfr(1) / 4;
    const mpfr v = mpfr(3);
    const auto at_u = jacobi(u, m);
    const auto at_v = jacobi(v, other);
    const mpfr below = at_v.cn * at_v.cn + m.k * m.k * at_u.sn * at_u.sn * at_v.sn * at_v.sn;
    const complex_number<mpfr> sn{mpfr(at_u.sn * at_v.dn / below), mpfr(at_u.cn * at_u.dn * at_v.sn * at_v.cn / below)};
    // To the left of the pole at 2i and to its right.
    std::vector<complex_number<mpfr>> x;
    for (const char* corner : {"1+2i", "-1+2i"}) {
        x.push_back(states_along<mpfr>(system, points({corner}), points({"1/4+3i"}))[0][0][0]);
        const auto half = complex_number<mpfr>(x.back() / 2);
        CHECK(off(sin(half), complex_number<mpfr>(sn * m.k)) < 10'000);
    }
    CHECK(off(complex_number<mpfr>(x[0] - x[1]), complex_number<mpfr>(mpfr(0))) > 1e40);  // two branches of x
    CHECK(off(cos(x[0]), cos(x[1])) < 10'000);
}

TEST_CASE("two ways agree on digits, and a real number is one however it was reached", "[ode][path]") {
    const auto system = solved("y' = y^2; y(0) = 1");
    const precision_scope precision(80);
    const auto states = trajectory_along(system, points({"1+i", "2+i"}), points({"3", "2+i", "1+i"}), 40);
    CHECK(abs(mpfr(states[0][0][0].re * 2 + 1)) < pow(mpfr(10), -50));
    CHECK(states[0][0][0].im == 0);
    CHECK(states[2][0][0].re == 0);
    const auto root = trajectory_along(solved("y' = 1/(2*y); y(0) = 1"), points({"-1+i"}), points({"-2"}), 30);
    CHECK(root[0][0][0].re == 0);
    CHECK(abs(mpfr(root[0][0][0].im - 1)) < pow(mpfr(10), -40));
    // The initial point itself, with an exact 0.
    const auto start = trajectory_along(solved("x'' = -x; x(0) = 0; x'(0) = 1"), {}, points({"0", "i"}), 20);
    CHECK(start[0][0][0].re == 0);
    CHECK(start[0][0][1].re == 1);
    CHECK(start[1][0][0].re == 0);
    CHECK_THAT(start[1][0][0].im, near<mpfr>(decimal("1.17520119364380145688238185059560081515571798"), 10));
}

TEST_CASE("invariants are kept along a way", "[ode][path]") {
    const precision_scope precision(40);
    const auto system = solved("x'' = -sin(x); x(0) = 1; x'(0) = 0; invariant x'^2/2 - cos(x)");
    const auto there = points({"2+i"});
    invariants<complex_number<mpfr>> energy(system);
    const auto time = constant_value<complex_number<mpfr>>::of(there[0]);
    const auto state = states_along<mpfr>(system, {}, there)[0];
    CHECK(energy.drift(time, state) < pow(mpfr(10), -36));
    auto wrong = state;
    wrong[0][0] = complex_number<mpfr>(wrong[0][0] + complex_number<mpfr>(mpfr(mpfr(1) / 1000)));
    CHECK(energy.drift(time, wrong) > pow(mpfr(10), -4));
    CHECK_THROWS_WITH(invariants<mpfr>(solved("y' = y; y(0) = 1")), Catch::Contains("states no invariant"));
}

TEST_CASE("complex numbers agree part by part, and a part far below the other is 0", "[ode][path]") {
    const auto none = [](long /*guard*/) {
        return std::vector<complex_number<mpfr>>{{mpfr(1), pow(mpfr(10), -60)}, {mpfr(0), mpfr(2)}};
    };
    const precision_scope precision(80);
    const auto values = agreed_complex_values(30, none);
    CHECK(values[0].im == 0);
    CHECK(values[1].re == 0);
    // A small part that is larger than that has its digits.
    const auto small = [](long /*guard*/) { return std::vector<complex_number<mpfr>>{{mpfr(1), pow(mpfr(10), -40)}}; };
    CHECK(agreed_complex_values(30, small)[0].im > 0);
    // Noise does not agree.
    const auto noise = [](long guard) {
        return std::vector<complex_number<mpfr>>{{mpfr(1), mpfr(mpfr(1) / static_cast<int>(guard))}};
    };
    CHECK_THROWS_AS(agreed_complex_values(30, noise), error);
}

}  // namespace plane_path_test
