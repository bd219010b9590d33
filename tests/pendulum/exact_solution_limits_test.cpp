// The exact solution in extreme or degenerate cases: no period, no motion, huge times, units, mixed precisions.
#include <catch2/catch.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "libration/pendulum/coefficients.hpp"
#include "libration/series/arithmetic.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_exact_solution_limits_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("a Taylor series of the differential equation carries one state to the next",
                        "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [name, m] : periodic_motions()) {
        if (m.energy() == fraction("1e6")) {
            continue;  // too fast for the step below
        }
        for (const std::string time : {"0.37", "-5.1", "12.4"}) {
            INFO(name << " from " << time);
            const exact_solution<T> solution(m);
            const rational step(1, 16);
            const auto here = solution(read_exact(time));
            const auto there = solution(libration::exactly(rational(fraction(time) + step)));
            // (pendseries) does not use elliptic functions; (1/16 / 1.4)^90 is below 1e-120.
            const auto series =
                taylor_by_sine_cosine<T>({here, energies<T>(m), parity::any}, 90, from_rational<T>(step));
            const jet<T> carried = evaluate(series, T(1));
            using std::abs;
            const T scale = abs(there.theta) + 4;
            CHECK_THAT(there.theta, near<T>(carried.value, 3, scale));
            CHECK_THAT(there.omega, near<T>(T(carried.slope * 16), 3, scale));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("a separatrix leaves the bottom as the Gudermannian of time", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string time : {"0", "1e-30", "0.1", "-1", "7.3", "-20", "300"}) {
        INFO(time);
        expected_value theta;
        expected_value omega;
        {
            const precision_scope wide(400);
            const mpfr t = from_exact<mpfr>(read_exact(time));
            theta = {atan(sinh(t)) * 2, mpfr(0)};
            omega = {2 / cosh(t), mpfr(0)};
        }
        const auto s = state_of<T>(with_energy("2"), time);
        CHECK_THAT(s.theta, near<T>(theta, 3));  // atan and tanh and a product
        CHECK_THAT(s.omega, near<T>(omega, 2, T(2)));
        CHECK(state_of<T>(with_energy("2", -1), time).theta == -s.theta);
    }
}

TEMPLATE_LIST_TEST_CASE("an equilibrium stays where it is", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string time : {"0", "-3", "1e20"}) {
        for (const std::string bottom : {"0", "4pi", "-360deg"}) {
            const auto s = state_of<T>(with_state(bottom, "0"), time);
            CHECK(s.theta == from_exact<T>(read_exact(bottom)));
            CHECK(s.omega == 0);
            CHECK(s.half_sine == 0);
            CHECK(s.half_cosine == 1);
        }
        for (const std::string top : {"pi", "-180deg", "7pi"}) {
            const auto s = state_of<T>(with_state(top, "0"), time);
            CHECK(s.theta == from_exact<T>(read_exact(top)));
            CHECK(s.omega == 0);
            CHECK(s.half_sine == 1);
            CHECK(s.half_cosine == 0);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("small swings are harmonic and fast rotation is uniform", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::cos;
    // theta = A cos t + O(A^3), A = sqrt(2E) = 1e-60; the correction is 1e-120 relative.
    const motion tiny = motion::of_energy(rational(fraction("1e-120") / 2));
    for (const int time : {0, 1, 2, 3}) {
        const auto s = state_of<T>(tiny, std::to_string(time));
        CHECK_THAT(s.theta, near<T>(T(cos(T(time)) * from_rational<T>(fraction("1e-60"))), 4,
                                    from_rational<T>(fraction("1e-60"))));
    }
    // theta = pi + omega t + O(1/omega^2), omega = 1e60.
    if constexpr (!std::is_same_v<T, double>) {
        const auto s = state_of<T>(with_state("180deg", "1e60"), "1e-60");
        CHECK_THAT(s.theta, near<T>(T(pi<T>() + 1), 3));
    }
}

TEMPLATE_LIST_TEST_CASE("a huge time is the rest that a closed form of the period leaves of it", "[exact_solution]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const std::string huge = "1e50";
    rational rest;  // of 1e50 modulo Gamma(1/4)^2/sqrt(pi), the period of 90 degrees, exactly as a fraction
    {
        const precision_scope wide(220);
        mpfr gamma = mpfr(1) / 4;
        mpfr_gamma(handle(gamma), handle(gamma), MPFR_RNDN);
        const mpfr period = gamma * gamma / sqrt(pi<mpfr>());
        const mpfr time = from_exact<mpfr>(read_exact(huge));
        mpfr_get_q(rest.backend().data(), handle(mpfr(time - floor(time / period) * period)));
    }
    const auto expected = exact_solution<T>(with_energy("1"))(libration::exactly(rest));
    const auto s = state_of<T>(with_energy("1"), huge);
    CHECK_THAT(s.theta, near<T>(expected.theta, 1, T(1)));
    CHECK_THAT(s.omega, near<T>(expected.omega, 1, T(1)));
}

TEMPLATE_LIST_TEST_CASE("with a length and a gravity times are seconds and theta is the same", "[exact_solution]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // 9.81 m/s^2 and 0.0981 m: 100/s^2, ten units of time per second, and omega0 in rad/s.
    const motion in_seconds = motion::of_state(read_exact("2.5"), read_exact("-3"), rational(100));
    const motion plain = with_state("2.5", "-0.3");
    for (const std::string time : {"0", "0.73", "1e6"}) {
        INFO(time);
        const auto s = state_of<T>(in_seconds, time);
        const auto p = exact_solution<T>(plain)(libration::exactly(rational(fraction(time) * 10)));
        CHECK(s.theta == p.theta);
        CHECK(s.omega == p.omega);  // dimensionless: the caller divides by time_unit
    }
}

TEST_CASE("a solution made in few digits refuses to be evaluated in more", "[exact_solution]") {
    // The digits of E = 1.71 at t = 1 from the table; 30 and 50 digits of working precision.
    const expected_value expected = [] {
        for (const auto& row : reference_table("motions.csv")) {
            if (row.at("energy") == "1.71" && row.at("theta0").empty() && row.at("direction").empty() &&
                row.at("time") == "1") {
                return decimal(row.at("theta"));
            }
        }
        throw std::runtime_error("no such row");
    }();
    const auto relative_error = [&](const mpfr& theta) {
        const precision_scope wide(100);
        return mpfr(abs(theta - expected.value) / expected.value);
    };
    std::optional<exact_solution<mpfr>> narrow_made;
    std::optional<exact_solution<mpfr>> wide_made;
    {
        const precision_scope thirty(30);
        narrow_made.emplace(with_energy("1.71"));
    }
    {
        const precision_scope fifty(50);
        wide_made.emplace(with_energy("1.71"));
        CHECK_THROWS_AS((*narrow_made)(read_exact("1")), std::logic_error);  // 50 digits, of which 30 would be right
        CHECK(relative_error((*wide_made)(read_exact("1")).theta) < mpfr("1e-49"));
    }
    const precision_scope thirty(30);
    CHECK(relative_error((*wide_made)(read_exact("1")).theta) < mpfr("1e-29"));
}

}  // namespace pendulum_exact_solution_limits_test
