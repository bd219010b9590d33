#include "libration/pendulum/energy.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_energy_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

struct typed_state {
    std::string theta0;
    std::string omega0;
};

// E = 2 sin^2(theta0/2) + w^2/2 and 2-E = 2 (cos(theta0/2) - w/2)(cos(theta0/2) + w/2), at 900 digits.
struct expected_pair {
    expected_value energy;
    expected_value gap;
};
expected_pair from_half_angle(const typed_state& s) {
    const precision_scope precision(900);
    const mpfr half = from_exact<mpfr>(read_exact(s.theta0)) / 2;
    const mpfr w = from_exact<mpfr>(read_exact(s.omega0));
    const mpfr sine = sin(half);
    const mpfr cosine = cos(half);
    return {{sine * sine * 2 + w * w / 2, mpfr(0)}, {(cosine - w / 2) * (cosine + w / 2) * 2, mpfr(0)}};
}

// Correctly rounded up to a double rounding: half an ulp, and epsilon is one ulp of the smallest significand.
constexpr long one_rounding = 1;

}  // namespace

TEMPLATE_LIST_TEST_CASE("E and 2-E of a state have all their digits", "[energy]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const std::vector<typed_state> states{{"2.5", "-0.3"},
                                          {"120deg", "0.99999999999999999999"},
                                          {"120deg", "1.000000000000000000000000000001"},
                                          {"60deg", "1.7320508075688772935"},
                                          {"3.141592653589793238462643383279502884197", "0"},
                                          {"3.141592653589793238462643383279502884198", "1e-30"},
                                          {"1e-20", "0"},
                                          {"0", "1e-20"},
                                          {"1e-20", "1e-40"},
                                          {"0", "1.9999999999999999999999999999999999999999"},
                                          {"9.0", "0.1"},
                                          {"100", "0"},
                                          {"-50", "-3"},
                                          {"1e30", "1"},
                                          {"0.1", "1e10"}};
    for (const auto& s : states) {
        INFO("theta0 = " << s.theta0 << ", omega0 = " << s.omega0);
        const auto expected = from_half_angle(s);
        const auto pair = energies<T>(with_state(s.theta0, s.omega0));
        CHECK_THAT(pair.energy, near<T>(expected.energy, one_rounding));
        CHECK_THAT(pair.gap, near<T>(expected.gap, one_rounding));
    }
}

TEMPLATE_LIST_TEST_CASE("E and 2-E keep their digits many turns away", "[energy]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    std::string theta0;  // 2e30 pi + 2 pi/3 cut to 40 decimals: 2-E is near 1e-40 and depends on the last digits
    {
        const precision_scope wide(200);
        const mpfr angle = pi<mpfr>() * mpfr("2e30") + pi<mpfr>() * 2 / 3;
        theta0 = to_decimal(angle, 71);
    }
    INFO("theta0 = " << theta0);
    const auto expected = from_half_angle({theta0, "1"});
    const auto pair = energies<T>(with_state(theta0, "1"));
    CHECK_THAT(pair.gap, near<T>(expected.gap, one_rounding));
}

TEMPLATE_LIST_TEST_CASE("E and 2-E of an energy are the typed fractions", "[energy]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string small : {"1e-40", "1e-300", "3e-17"}) {
        INFO(small);
        CHECK(energies<T>(with_energy(small)).energy == from_rational<T>(fraction(small)));
        CHECK(energies<T>(with_gap(small)).gap == from_rational<T>(fraction(small)));
        CHECK(energies<T>(with_gap("-" + small)).gap == -from_rational<T>(fraction(small)));
    }
    CHECK(energies<T>(with_energy("2")).gap == 0);
    CHECK(energies<T>(with_energy("0")).energy == 0);
}

TEMPLATE_LIST_TEST_CASE("a scalar says when it cannot hold the energy", "[energy]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const motion& m : {with_gap("1e-400"), with_gap("-1e-400"), with_energy("1e-400"), with_energy("1e400"),
                            with_state("1e-200", "0")}) {
        if constexpr (std::is_same_v<T, double>) {
            CHECK_THROWS_AS(energies<T>(m), libration::error);
        } else {
            CHECK_NOTHROW(energies<T>(m));
        }
    }
    if constexpr (!std::is_same_v<T, mpfr>) {
        CHECK_THROWS_AS(energies<T>(with_gap("1e-5000")), libration::error);
    }
}

TEMPLATE_LIST_TEST_CASE("the modulus of an orbit is a pair of full precision", "[energy]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // Quotient and square root, half an ulp each, of operands correct to half an ulp; the square below doubles them.
    const long roundings = 4;
    for (const auto& [name, m] : periodic_motions()) {
        INFO(name);
        const auto o = energy_level_of<T>(m);
        const bool rotates = m.regime() == regime::rotation;
        const T denominator = rotates ? o.pair.energy : T(2);
        CHECK_THAT(T(o.modulus.k * o.modulus.k), near<T>(T((rotates ? T(2) : o.pair.energy) / denominator), roundings));
        CHECK_THAT(T(o.modulus.complement * o.modulus.complement),
                   near<T>(T(o.pair.gap * (rotates ? -1 : 1) / denominator), roundings));
        CHECK_THAT(T(o.time_scale * o.time_scale), near<T>(rotates ? T(o.pair.energy / 2) : T(1), roundings));
    }
}

TEMPLATE_LIST_TEST_CASE("E = 2 has no orbit", "[energy]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(energy_level_of<T>(with_energy("2")), libration::error);
    CHECK_THROWS_AS(energy_level_of<T>(with_state("120deg", "1")), libration::error);
    CHECK_THROWS_AS(energy_level_of<T>(with_state("pi", "0")), libration::error);
}

TEMPLATE_LIST_TEST_CASE("the unit of time is sqrt(length/gravity)", "[energy]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK(time_unit<T>(with_energy("1")) == 1);
    CHECK(time_unit<T>(with_energy("1").with_squared_frequency(4)) == T(1) / 2);
    const T unit = time_unit<T>(with_energy("1").with_squared_frequency(rational(981, 25)));
    CHECK_THAT(T(unit * unit * 981), near<T>(T(25), 3));  // quotient, root, square
}

}  // namespace pendulum_energy_test
