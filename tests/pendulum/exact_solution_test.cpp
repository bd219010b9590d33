#include "libration/pendulum/exact_solution.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_exact_solution_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
T at_least_one(const T& x) {
    using std::abs;
    return abs(x) > 1 ? T(abs(x)) : T(1);
}

// The largest |omega|, sqrt(2E).
template <class T>
T top_speed(const motion& m) {
    using std::sqrt;
    return sqrt(energies<T>(m).energy * 2);
}

// Half an ulp each of the offset (|omega| offset <= 1.4), of k, of the two Landen levels that still differ from the
// identity, of the quotient by dn, and of the angle.
constexpr long theta_ulps = 4;
constexpr long omega_ulps = 4;
constexpr long square_ulps = 8;  // twice the relative error

const std::vector<std::string> times{"0", "0.1", "-13.5", "7.3", "20", "1e6", "T/8", "T/3", "-2T/7"};

}  // namespace

TEMPLATE_LIST_TEST_CASE("the solution conserves its energy", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [name, m] : periodic_motions()) {
        const auto pair = energies<T>(m);
        const exact_solution<T> solution(m);
        for (const auto& time : times) {
            INFO(name << " at " << time);
            const auto s = solution(read_exact(time));
            CHECK_THAT(T(s.half_sine * s.half_sine * 2 + s.omega * s.omega / 2), near<T>(pair.energy, square_ulps));
            CHECK_THAT(T(s.half_sine * s.half_sine + s.half_cosine * s.half_cosine), near<T>(T(1), square_ulps));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("sine and cosine of the half angle belong to the angle", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::cos;
    using std::sin;
    for (const auto& [name, m] : periodic_motions()) {
        for (const std::string time : {"0", "0.7", "-2.5", "T/8"}) {
            INFO(name << " at " << time);
            const auto s = state_of<T>(m, time);
            const T scale = at_least_one(s.theta);  // the cost of rounding theta alone
            CHECK_THAT(T(s.half_sine * s.half_cosine * 2), near<T>(T(sin(s.theta)), theta_ulps, scale));
            CHECK_THAT(T(s.half_cosine * s.half_cosine - s.half_sine * s.half_sine),
                       near<T>(T(cos(s.theta)), theta_ulps, scale));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the solution starts where it was told to", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    struct start {
        std::string theta0;
        std::string omega0;
    };
    const std::vector<start> starts{{"2.5", "-0.3"}, {"-1", "0.5"},    {"9.0", "0.1"},  {"100", "0"},
                                    {"-50", "-3"},   {"1e30", "1"},    {"7pi", "-1"},   {"0", "1"},
                                    {"2pi", "-1.9"}, {"120deg", "-1"}, {"3.1415", "0"}, {"1e-10", "1e-10"},
                                    {"-3pi/4", "0"}, {"3", "1e-6"}};
    for (const auto& [theta0, omega0] : starts) {
        INFO("(" << theta0 << ", " << omega0 << ")");
        const motion m = with_state(theta0, omega0);
        const auto s = state_of<T>(m, "0");
        const T theta = from_exact<T>(read_exact(theta0));
        CHECK_THAT(s.theta, near<T>(theta, theta_ulps, at_least_one(theta)));
        CHECK_THAT(s.omega, near<T>(from_exact<T>(read_exact(omega0)), omega_ulps, top_speed<T>(m)));
    }
}

TEMPLATE_LIST_TEST_CASE("after a period the motion is where it was, or one turn on", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& [name, m] : periodic_motions()) {
        INFO(name);
        const int turns = m.regime() == regime::rotation ? m.direction() : 0;
        const exact_solution<T> solution(m);
        const auto s = solution(read_exact("2T/7"));
        for (const int periods : {1, -1, 1000000}) {
            const auto later = solution(exact{rational(2, 7) + periods, unit::period, ""});
            const T expected = s.theta + pi<T>() * 2 * (turns * periods);
            CHECK_THAT(later.theta, near<T>(expected, 2, at_least_one(expected)));
            CHECK_THAT(later.omega, near<T>(s.omega, 1, top_speed<T>(m)));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("from rest the motion is the same backwards, and opposite half a period later",
                        "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const motion& m : {with_energy("1.71"), with_gap("1e-20"), with_state("-1", "0")}) {
        for (const std::string time : {"0.1", "1", "7.3", "1e6", "T/7"}) {
            INFO(time);
            const auto forward = state_of<T>(m, time);
            const auto backward = state_of<T>(m, "-" + time);
            CHECK(backward.theta == forward.theta);
            CHECK(backward.omega == -forward.omega);
        }
        const auto s = state_of<T>(m, "T/7");  // (newseries): theta(2 T* + t) = theta(2 T* - t) = -theta(t)
        CHECK_THAT(state_of<T>(m, "9T/14").theta, near<T>(T(-s.theta), 1, T(1)));
        CHECK_THAT(state_of<T>(m, "5T/14").theta, near<T>(T(-s.theta), 1, T(1)));
    }
}

TEMPLATE_LIST_TEST_CASE("clockwise is the mirror image of counterclockwise", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string time : {"0.7", "-13.5", "T/3", "5T/2"}) {
        INFO(time);
        const auto forward = state_of<T>(with_state("0.5", "3"), time);
        const auto mirrored = state_of<T>(with_state("-0.5", "-3"), time);
        CHECK(mirrored.theta == -forward.theta);
        CHECK(mirrored.omega == -forward.omega);
    }
}

TEMPLATE_LIST_TEST_CASE("half way down theta is 2 asin(k/sqrt(1+k'))", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const std::string energy : {"1e-3", "0.5", "1", "1.71", "1.9998"}) {
        INFO(energy);
        expected_value expected;
        {
            const precision_scope wide(220);
            const mpfr parameter = from_rational<mpfr>(rational(fraction(energy) / 2));
            expected = {asin(sqrt(parameter / (1 + sqrt(1 - parameter)))) * 2, mpfr(0)};
        }
        CHECK_THAT(state_of<T>(with_energy(energy), "T/8").theta, near<T>(expected, theta_ulps));
    }
}

TEMPLATE_LIST_TEST_CASE("fractions of the way down are fractions of T*", "[exact_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const motion& m : {with_energy("1.71"), with_gap("-1e-20")}) {
        const exact_solution<T> solution(m);
        const int quarters = quarters_per_period(m.regime());
        for (int eighths = 0; eighths <= 8; ++eighths) {
            INFO(eighths << "/8");
            const auto s = solution.from_top(T(eighths) / 8);
            const auto expected = solution(exact{rational(eighths, 8 * quarters), unit::period, ""});
            CHECK_THAT(s.theta, near<T>(expected.theta, theta_ulps, T(1)));
            CHECK_THAT(s.omega, near<T>(expected.omega, omega_ulps, T(1)));
        }
    }
    CHECK_THROWS_AS(exact_solution<T>(with_energy("2")).from_top(T(0)), libration::error);
}

TEMPLATE_LIST_TEST_CASE("states agree with the table", "[exact_solution][reference]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& row : reference_table("motions.csv")) {
        INFO("E " << row.at("energy") << ", gap " << row.at("gap") << ", " << row.at("theta0") << ", "
                  << row.at("omega0") << " " << row.at("direction") << " at " << row.at("time"));
        const motion m = motion_of(row);
        const auto s = state_of<T>(m, row.at("time"));
        const expected_value theta = decimal(row.at("theta"));
        CHECK_THAT(s.theta, near<T>(theta, theta_ulps, at_least_one(theta.value)));
        CHECK_THAT(s.omega, near<T>(decimal(row.at("omega")), omega_ulps, top_speed<T>(m)));
        if (row.at("theta") == "0") {
            CHECK(s.theta == 0);
        }
        if (row.at("omega") == "0") {
            CHECK(s.omega == 0);
        }
    }
}

}  // namespace pendulum_exact_solution_test
