#include "libration/pendulum/expansion.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/series/arithmetic.hpp"
#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_expansion_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

template <class T>
expansion<T> expanded(const motion& m, const std::string& at, int order) {
    return expand(exact_solution<T>(m), read_expansion_point(at), order);
}

}  // namespace

TEST_CASE("expansion points are names or times", "[expansion]") {
    using place = expansion_point::place;
    CHECK(read_expansion_point("top").where == place::top);
    CHECK(read_expansion_point("bottom").where == place::bottom);
    CHECK(read_expansion_point("start").where == place::start);
    const auto time = read_expansion_point("-3T/4");
    CHECK(time.where == place::time);
    CHECK(time.time.coefficient == rational(-3, 4));
    CHECK(time.time.measure == unit::period);
    CHECK(read_expansion_point("1.1").time.coefficient == rational(11, 10));
    for (const std::string bad : {"", "Top", "middle", "1/0", "nan", "90deg", "1.1.1"}) {
        INFO(bad);
        CHECK_THROWS_AS(read_expansion_point(bad), libration::error);
    }
}

TEMPLATE_LIST_TEST_CASE("top and bottom are those of the canonical motion", "[expansion]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    using std::acos;
    using std::sqrt;
    const auto half_cycle_top = expanded<T>(with_energy("0.5"), "top", 1);
    CHECK_THAT(half_cycle_top.scaled[0], near<T>(T(pi<T>() / 3), 3));  // arccos(1 - E)
    CHECK(half_cycle_top.scaled[1] == 0);
    const auto half_cycle_bottom = expanded<T>(with_energy("0.5"), "bottom", 1);
    CHECK(half_cycle_bottom.scaled[0] == 0);
    CHECK_THAT(T(half_cycle_bottom.scaled[1] / half_cycle_bottom.scale), near<T>(T(-1), 2));  // -sqrt(2E)
    for (const int direction : {1, -1}) {
        const auto top = expanded<T>(with_energy("10", direction), "top", 1);
        CHECK(top.scaled[0] == pi<T>());
        CHECK_THAT(T(top.scaled[1] / top.scale), near<T>(T(4 * direction), 3));  // +-sqrt(2E - 4)
        const auto bottom = expanded<T>(with_energy("10", direction), "bottom", 1);
        CHECK(bottom.scaled[0] == (direction > 0 ? T(pi<T>() * 2) : T(0)));
        CHECK_THAT(T(bottom.scaled[1] / bottom.scale), near<T>(T(sqrt(T(20)) * direction), 3));
    }
    const auto critical = expanded<T>(with_energy("2"), "bottom", 1);
    CHECK(critical.scaled[0] == 0);
    CHECK_THAT(T(critical.scaled[1] / critical.scale), near<T>(T(2), 1));
}

TEMPLATE_LIST_TEST_CASE("the start is the given state and a time is a time after it", "[expansion]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const motion m = with_state("2.5", "-0.3");
    const auto start = expanded<T>(m, "start", 6);
    CHECK_THAT(start.scaled[0], near<T>(from_rational<T>(fraction("2.5")), 2));
    CHECK_THAT(T(start.scaled[1] / start.scale), near<T>(from_rational<T>(fraction("-0.3")), 4, T(1)));
    CHECK(expanded<T>(m, "0", 6).scaled.coefficients() == start.scaled.coefficients());
    const motion canonical = with_energy("1.71");
    CHECK(expanded<T>(canonical, "T/4", 6).scaled.coefficients() ==
          expanded<T>(canonical, "bottom", 6).scaled.coefficients());
    CHECK(expanded<T>(canonical, "start", 6).scaled.coefficients() ==
          expanded<T>(canonical, "top", 6).scaled.coefficients());
}

TEMPLATE_LIST_TEST_CASE("the scale is the radius of convergence, and 1 where that is infinite", "[expansion]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto swing = expanded<T>(with_energy("1.71"), "1.1", 2);
    REQUIRE(swing.radius);
    CHECK(swing.scale == *swing.radius);
    for (const motion& m : {with_energy("0"), with_state("pi", "0")}) {
        const auto rest = expanded<T>(m, "start", 5);
        CHECK_FALSE(rest.radius);
        CHECK(rest.scale == 1);
        CHECK(rest.scaled[0] == (m.regime() == regime::stable_equilibrium ? T(0) : pi<T>()));
        for (int n = 1; n <= 5; ++n) {
            CHECK(rest.scaled[n] == 0);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("a series inside its radius gives the motion back", "[expansion]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const rational step(1, 10);
    for (const motion& m :
         {with_energy("1.71"), with_energy("2", -1), with_state("9.0", "-4").with_squared_frequency(1)}) {
        for (const std::string at : {"start", "1.3", "-20"}) {
            INFO(at);
            const exact_solution<T> solution(m);
            const auto e = expand(solution, read_expansion_point(at), 100);
            const rational center =
                at == "start" ? rational(0) : fraction(at[0] == '-' ? at.substr(1) : at) * (at[0] == '-' ? -1 : 1);
            const auto expected = solution(libration::exactly(rational(center + step)));
            const jet<T> there = evaluate(e.scaled, T(from_rational<T>(step) / e.scale));
            CHECK_THAT(there.value, near<T>(expected.theta, 6, T(16)));
            CHECK_THAT(T(there.slope / e.scale), near<T>(expected.omega, 6, T(8)));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("a motion of E = 2 has no top", "[expansion]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(expanded<T>(with_energy("2"), "top", 5), libration::error);
    CHECK_THROWS_AS(expanded<T>(with_state("120deg", "1"), "top", 5), libration::error);
    CHECK_THROWS_AS(expanded<T>(with_energy("2"), "T/4", 5), libration::error);
    CHECK_THROWS_AS(expanded<T>(with_energy("1"), "top", -1), libration::error);
}

}  // namespace pendulum_expansion_test
