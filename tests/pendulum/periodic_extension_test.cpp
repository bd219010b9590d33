#include "libration/pendulum/periodic_extension.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

#include "libration/pendulum/bounds.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_periodic_extension_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
periodic_extension<T, endpoint_approximant<T>> resummed(const motion& m, int order) {
    return {m, resummation_from_top(arc_of<T>(m), order)};
}

// Motions whose resummation converges quickly: every regime with a period, direction, well and kind of start.
std::vector<named_motion> extended_motions() {
    return {{"E = 1.71", with_energy("1.71")},
            {"E = 2.02", with_energy("2.02")},
            {"E = 2.02, clockwise", with_energy("2.02", -1)},
            {"E = 1e-3", with_energy("1e-3")},
            {"E = 10, clockwise", with_energy("10", -1)},
            {"from (2.5, -0.3)", with_state("2.5", "-0.3")},
            {"from (-1, 0.5)", with_state("-1", "0.5")},
            {"from (9.0, 0.1)", with_state("9.0", "0.1")},
            {"from (-50, -3)", with_state("-50", "-3")},
            {"from (-7pi, -1)", with_state("-7pi", "-1")}};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the extension is within bound A2 of the exact solution at all times", "[periodic_extension]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    std::mt19937 engine(1729);
    std::uniform_int_distribution<int> hundredth(-5000, 5000);
    for (const auto& [name, m] : extended_motions()) {
        const exact_solution<T> solution(m);
        const auto bounds = top_bounds<T>::of(energy_level_of<T>(m));
        for (const int order : {4, 15, 40}) {
            const auto extension = resummed<T>(m, order);
            for (int i = 0; i < 24; ++i) {
                const exact time = libration::exactly(rational(hundredth(engine), 100));
                INFO(name << " at " << time.text << ", N = " << order);
                const T expected = solution(time).theta;
                // Roundings of theta, of its whole turns, and of omega* T* in between.
                const T rounding = epsilon<T>() * (abs(expected) + bounds.effective_period + 4);
                CHECK(abs(T(extension(time).value - expected)) <= bounds.resummation_norm(order) + rounding);
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("an extension of the exact descent is the exact solution", "[periodic_extension]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    for (const auto& [name, m] : extended_motions()) {
        const exact_solution<T> solution(m);
        const motion canonical = motion::of_energy(m.energy().value_or(2));
        if (!m.energy()) {
            continue;  // the canonical motion of the same energy is known if that is rational
        }
        const exact_solution<T> arc(canonical);
        const T period = effective_period(energy_level_of<T>(m));
        const auto on_arc = [&](const T& x) {
            const auto s = arc.from_top(x);
            return jet<T>{s.theta, s.omega * period};
        };
        const periodic_extension<T, decltype(on_arc)> extension(m, on_arc);
        for (const std::string time :
             {"0", "T/8", "-T/8", "T/3", "-T/3", "T/4", "-3T/4", "3T/2", "0.7", "-13.5", "1e12"}) {
            INFO(name << " at " << time);
            const auto expected = solution(read_exact(time));
            const jet<T> at = extension(read_exact(time));
            CHECK_THAT(at.value, near<T>(expected.theta, 3, T(abs(expected.theta) + 1)));
            CHECK_THAT(at.slope, near<T>(expected.omega, 3, T(2 * energy_level_of<T>(m).time_scale)));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the extension is continuous and smooth where its pieces meet", "[periodic_extension]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::abs;
    // A tiny step to both sides of tops and bottoms; N = 3 is far from converged, continuity is of the formula.
    const rational step = fraction("1e-60");
    for (const auto& [name, m] : extended_motions()) {
        const auto extension = resummed<T>(m, 3);
        const int quarters = quarters_per_period(m.regime());
        for (int quarter = -5; quarter <= 5; ++quarter) {
            INFO(name << " at quarter " << quarter);
            const jet<T> before = extension(exact{rational(quarter, quarters) - step, unit::period, ""});
            const jet<T> after = extension(exact{rational(quarter, quarters) + step, unit::period, ""});
            // 2 step T |omega| is below 1e-57.
            const T moved = from_rational<T>(rational(step * 1000)) + epsilon<T>() * 8 * (1 + abs(before.value));
            CHECK(abs(T(after.value - before.value)) <= moved);
            CHECK(abs(T(after.slope - before.slope)) <= moved * 4);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("clockwise is the mirror image, and another well a shift", "[periodic_extension]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string time : {"0.3", "-2.2", "5T/7", "100"}) {
        INFO(time);
        const exact t = read_exact(time);
        const jet<T> forward = resummed<T>(with_state("0.5", "3"), 12)(t);
        const jet<T> mirrored = resummed<T>(with_state("-0.5", "-3"), 12)(t);
        CHECK(mirrored.value == -forward.value);
        CHECK(mirrored.slope == -forward.slope);
        const jet<T> well = resummed<T>(with_state("pi/3", "1/2"), 12)(t);
        const jet<T> other = resummed<T>(with_state("13pi/3", "1/2"), 12)(t);
        CHECK_THAT(other.value, near<T>(T(well.value + pi<T>() * 4), 2));
        CHECK_THAT(other.slope, near<T>(well.slope, 1, T(1)));
    }
}

namespace {

// The paper's (newseries) as printed, with any T*, from the top at time 0 and counterclockwise.
template <class T, class F>
T as_printed(const F& f, const T& t, const T& effective_period, bool rotates) {
    using std::floor;
    const T period = effective_period * (rotates ? 2 : 4);
    const T rest = t - floor(T(t / period)) * period;
    const auto tilde = [&](const T& s) { return f(T(s / effective_period)).value; };
    if (rotates) {
        const T turned = pi<T>() * 2 / period * (t - rest);
        return rest <= effective_period ? T(turned + tilde(rest))
                                        : T(turned - tilde(effective_period * 2 - rest) + pi<T>() * 4);
    }
    if (rest <= effective_period) {
        return tilde(rest);
    }
    if (rest <= effective_period * 3) {
        return rest <= effective_period * 2 ? T(-tilde(effective_period * 2 - rest))
                                            : T(-tilde(rest - effective_period * 2));
    }
    return tilde(effective_period * 4 - rest);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("with the T* of a rule the extension is the paper's with that T*", "[periodic_extension]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"1.71", "2.02"}) {
        const bool rotates = energy == "2.02";
        const motion m = with_energy(energy);
        for (const period_rule& by : {period_rule{period_method::series, 3}, period_rule{period_method::resummed, 1}}) {
            const T effective_period = effective_period_by(by, energy_level_of<T>(m));
            const auto f = resummation_from_top(arc_of<T>(m, by), 8);
            CHECK(f(T(1)).value == (rotates ? T(pi<T>() * 2) : T(0)));
            using extension = periodic_extension<T, endpoint_approximant<T>>;
            const extension from_top(m, f, by);
            const extension from_bottom(motion::of_energy_from(fraction(energy), exact{}), f, by);
            for (const std::string time : {"0.5", "3", "7.7", "40"}) {
                INFO("E = " << energy << " at " << time << ", T* by " << static_cast<int>(by.method));
                const T t = from_exact<T>(read_exact(time));
                const T expected = as_printed<T>(f, t, effective_period, rotates);
                // t/T* up to 20 in theta and omega, and the turns.
                CHECK_THAT(from_top(read_exact(time)).value, near<T>(expected, 100, T(2)));
                // At the bottom, rising, three quarters after the top; in rotation half a period, at 2 pi.
                const T later = t + effective_period * (rotates ? 1 : 3);
                const T shifted = as_printed<T>(f, later, effective_period, rotates) - pi<T>() * (rotates ? 2 : 0);
                CHECK_THAT(from_bottom(read_exact(time)).value, near<T>(shifted, 100, T(2)));
            }
            // A multiple of T is one of the true period.
            const T period = dimensionless_time<T>(m, read_exact("3T"));
            CHECK_THAT(from_top(read_exact("3T")).value,
                       near<T>(as_printed<T>(f, period, effective_period, rotates), 100, T(2)));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("E = 2 has nothing to extend", "[periodic_extension]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto f = [](const T& x) { return jet<T>{x, T(1)}; };
    using extension = periodic_extension<T, decltype(f)>;
    CHECK_THROWS_AS(extension(with_energy("2"), f), libration::error);
}

}  // namespace pendulum_periodic_extension_test
