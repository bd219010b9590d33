// Blasius' boundary layer f''' + f f''/2 = 0, f(0) = f'(0) = 0, f'(infinity) = 1, integrated from the wall outwards.

#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/number/exact.hpp"
#include "scalars.hpp"

namespace expansion_blasius_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;

namespace {

// f''(0) from OEIS A256522; lim (eta - f) by mpmath 1.2.1, its odefun with 60 digits from 0 to 32.
const std::string known_curvature = "0.332057336215196298937180062010582966547093561412679818100447564";
const std::string known_displacement = "1.7207876575205028196054381598253124496";

template <class T>
struct boundary_layer {
    T f;
    T slope;
    T curvature;
};

const ode::tape& equation() {
    static const ode::tape made = ode::tape::about_points(
        ode::explicit_system(ode::parse("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 1")));
    return made;
}

template <class T>
power_series<T> expand(const boundary_layer<T>& at, int order) {
    ode::taylor_expansion<T> expansion(equation(), order);
    expansion.about(T(0), {{at.f, at.slope, at.curvature}});
    return expansion.series_of(0);
}

template <class T>
boundary_layer<T> advance(const boundary_layer<T>& at, const T& step, int order) {
    const auto f = expand(at, order);
    const jet<T> slope = evaluate(derivative(f), step);
    return {evaluate(f, step).value, slope.value, slope.slope};
}

constexpr int steps = 128;
constexpr int steps_in_one = 4;  // eta goes to 32

// The layer at eta = 32, and the momentum in it: the integral of f'^2.
template <class T>
std::pair<boundary_layer<T>, T> far_out() {
    const T step = T(1) / steps_in_one;
    // The singularities nearest to the positive axis, 5.69 e^(+-i pi/3), are at least 4.9 away: a step of 1/4 gains 4
    // bits per degree.
    const int order = digits<T>() / 4 + 10;
    boundary_layer<T> at{T(0), T(0), from_exact<T>(read_exact(known_curvature))};
    T momentum(0);
    for (int i = 0; i < steps; ++i) {
        const auto slope = derivative(expand(at, order));
        momentum += evaluate(integral(slope * slope, T(0)), step).value;
        at = advance(at, step, order);
    }
    return {at, momentum};
}

// A rounding of half an epsilon in every step, without damping: a random walk of 128 of them ends at sqrt(128)/2 < 6.
constexpr long walked = 6;

}  // namespace

TEMPLATE_LIST_TEST_CASE("Blasius' series at the wall is the known one", "[ode][blasius]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // With f''(0) = 1: only powers 2, 5, 8, ..., 1/2!, -1/(2 5!), 11/(4 8!), -375/(8 11!) [Blasius 1908].
    const auto f = expand<T>({T(0), T(0), T(1)}, 11);
    for (int n = 0; n <= 11; ++n) {
        CHECK((n % 3 == 2 || f[n] == 0));
    }
    CHECK(f[2] == T(1) / 2);
    // Three roundings per coefficient, three coefficients.
    CHECK_THAT(f[5], tests::near<T>(from_rational<T>(rational(-1) / 240), 3));
    CHECK_THAT(f[8], tests::near<T>(from_rational<T>(rational(11) / (4 * 40320)), 6));
    CHECK_THAT(f[11], tests::near<T>(from_rational<T>(rational(-375) / (8 * integer(39916800))), 9));
}

TEMPLATE_LIST_TEST_CASE("Blasius' layer ends at speed 1 with its known displacement", "[ode][blasius]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto [at, momentum] = far_out<T>();
    // c f(c eta) solves the equation too: f'' ~ c^3, f' ~ c^2. A relative error of f''(0) causes 2/3 of it in f'. The
    // remainder beyond eta = 32 is less than f''(32), because f'' falls faster than e^-eta.
    tests::expected_value one = tests::exactly(T(1));
    {
        const auto wall = tests::decimal(known_curvature);
        one.uncertainty = wall.uncertainty / wall.value * 2 / 3 + widen(at.curvature);
    }
    CHECK_THAT(at.slope, tests::near<T>(one, walked));
    CHECK_THAT(T(32 - at.f), tests::near<T>(tests::decimal(known_displacement), walked, T(32)));
    // The equation integrated once: f'' - f''(0) + (f f' - int f'^2)/2 = 0, to all digits, whatever f''(0).
    const T wall = from_exact<T>(read_exact(known_curvature));
    const T balance = at.f * at.slope - momentum + (at.curvature - wall) * 2;
    CHECK_THAT(balance, tests::near<T>(tests::exactly(T(0)), walked, T(32)));
}

}  // namespace expansion_blasius_test
