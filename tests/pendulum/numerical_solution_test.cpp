#include "libration/pendulum/numerical_solution.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_numerical_solution_test {

using namespace libration;
using namespace libration::series;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("times in any order have the states of a march through them in order", "[numerical_solution]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const jet<T> start{T(1), T(-1)};
    const T step = T(1) / 64;
    const auto states = numerical_solution<T>(start, {T(1), T(-2), T(0), T(3) / 10, T(-1)}, step);
    REQUIRE(states.size() == 5);
    runge_kutta_march<T> forwards(start, step);
    CHECK(states[2].value == forwards.advance_to(T(0)).value);
    CHECK(states[3].value == forwards.advance_to(T(T(3) / 10)).value);
    CHECK(states[0].slope == forwards.advance_to(T(1)).slope);
    runge_kutta_march<T> backwards(start, step);
    CHECK(states[4].value == backwards.advance_to(T(-1)).value);
    CHECK(states[1].slope == backwards.advance_to(T(-2)).slope);
    CHECK(states[1].value != states[4].value);
    CHECK(numerical_solution<T>(start, {}, step).empty());
}

TEMPLATE_LIST_TEST_CASE("the numerical solution is the exact one to the fourth power of the step",
                        "[numerical_solution]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const exact_solution<T> solution(with_energy("1.71"));
    const pendulum_state<T> start = solution(exact{});
    const auto states = numerical_solution<T>({start.theta, start.omega}, {T(2), T(-1)}, T(T(1) / 128));
    // h^4 = 3.7e-9, times a constant below 1 here.
    const mpfr allowed = widen(from_rational<T>(fraction("4e-9")));
    const auto expected = [&](const std::string& time) {
        return expected_value{widen(solution(read_exact(time)).theta), allowed};
    };
    CHECK_THAT(states[0].value, near<T>(expected("2"), 0));
    CHECK_THAT(states[1].value, near<T>(expected("-1"), 0));
}

}  // namespace pendulum_numerical_solution_test
