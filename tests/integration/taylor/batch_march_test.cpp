// Solutions in lock step are those of taylor_march, to the last bit, and those of closed forms.
#include "libration/integration/taylor/batch_march.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/function/ball_values.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/integration/taylor/varied_problem.hpp"
#include "libration/scalar/vector_instructions.hpp"

namespace integration_taylor_batch_march_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr double epsilon_of_double = std::numeric_limits<double>::epsilon();
const double missing = std::numeric_limits<double>::quiet_NaN();

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }

std::vector<double> run(batch_march& by, double begin, const std::vector<double>& states,
                        const std::vector<double>& times) {
    std::vector<double> values(states.size() / by.size() * times.size() * by.written());
    by.run({begin, states, times}, values);
    return values;
}

// So many states of two numbers near 1/2, none a multiple of another.
std::vector<double> states_near_half(std::size_t solutions, std::size_t size) {
    std::vector<double> states;
    for (std::size_t i = 0; i < solutions * size; ++i) {
        states.push_back(0.5 + 0.3 * std::sin(static_cast<double>(i)));
    }
    return states;
}

// One solution after the other, by taylor_march, the times forwards and then backwards.
std::vector<double> one_by_one(const explicit_system& system, double begin, const std::vector<double>& states,
                               const std::vector<double>& times, const step_accuracy& accuracy) {
    const std::size_t size = names_of_state(system).size();
    std::vector<std::size_t> order(times.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::ranges::stable_sort(
        order, {}, [&](std::size_t i) { return times[i] >= begin ? std::pair(0, times[i]) : std::pair(1, -times[i]); });
    std::vector<double> values(states.size() / size * times.size() * size, missing);
    taylor_march<double> march(system, accuracy);
    for (std::size_t k = 0; k < states.size() / size; ++k) {
        solution_state<double> state;
        auto from = states.begin() + static_cast<std::ptrdiff_t>(k * size);
        for (const unknown_function& each : system.unknowns()) {
            state.emplace_back(from, from + each.order);
            from += each.order;
        }
        march.begin_at(begin, state);
        for (const std::size_t i : order) {
            double* to = values.data() + (k * times.size() + i) * size;
            for (const auto& of_unknown : march.advance_to(times[i])) {
                to = std::ranges::copy(of_unknown, to).out;
            }
        }
    }
    return values;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// Every operation of a tape that has vectors, and some that have none.
const std::vector<std::string> equations{
    "x' = (x - 3*y)^2/9 + x*y/(1 + y^2) - sqrt(2 + x^2); y' = sin(x) - y/(2 + x) + t*x/7; x(0) = 0; y(0) = 0",
    "x' = exp(-x)*cos(t) + log(2 + x); y' = tanh(x) - sinh(y/3) + tan(y/9); x(0) = 0; y(0) = 0",
    "x'' = -x/(x^2 + 1)^(1/3) + cosh(x')/5; x(0) = 0; x'(0) = 0",
    "x' = sinc(x - y) + atan(y); y' = asin(x/9) - cbrt(1 + x^2)*y/2 + t^3; x(0) = 0; y(0) = 0",
};

}  // namespace

TEST_CASE("solutions in lock step have the bits of solutions alone", "[ode][batch]") {
    const std::vector<double> times{0.75, 0, -0.5, 1.5, 0.25, -1};
    for (const std::string& text : equations) {
        const explicit_system system = system_of(text);
        for (const step_accuracy& accuracy : {step_accuracy{0, 21}, step_accuracy{45, 24}}) {
            batch_march together(system, accuracy);
            for (const std::size_t solutions : {std::size_t{1}, batch_lanes + 1, 2 * batch_lanes + 3}) {
                const auto states = states_near_half(solutions, 2);
                CHECK(
                    same_bits(run(together, 0.125, states, times), one_by_one(system, 0.125, states, times, accuracy)));
            }
        }
    }
}

TEST_CASE("every set of vector instructions gives the same bits", "[ode][batch]") {
    const auto states = states_near_half(batch_lanes + 3, 2);
    for (const std::string& text : equations) {
        const explicit_system system = system_of(text);
        batch_march together(system);
        const auto expected = run(together, 0, states, {1.25});
        for (const std::string& instructions : vector_instructions()) {
            const vector_instructions_scope by(instructions);
            CHECK(same_bits(run(together, 0, states, {1.25}), expected));
        }
    }
}

TEST_CASE("no solutions, and no times", "[ode][batch]") {
    batch_march spring(system_of("x'' = -x; x(0) = 1; x'(0) = 0"));
    CHECK(run(spring, 0, {}, {1, 2}).empty());
    CHECK(run(spring, 0, {1, 0, 2, 0}, {}).empty());
}

// Steps of an error of some units each, of solutions of the size 1; the sine of a phase loses 3 units of its size.
TEST_CASE("harmonic motions in lock step", "[ode][batch]") {
    batch_march spring(system_of("x'' = -x; x(0) = 1; x'(0) = 0"));
    std::vector<double> states;
    for (int i = 0; i < 50; ++i) {
        states.insert(states.end(), {std::cos(0.1 * i), -std::sin(0.1 * i)});
    }
    const std::vector<double> times{20, -3, 7, 0};
    const auto values = run(spring, 0, states, times);
    for (std::size_t i = 0; i < 50; ++i) {
        for (std::size_t j = 0; j < times.size(); ++j) {
            const double phase = 0.1 * static_cast<double>(i) + times[j];
            const double* const found = values.data() + (i * times.size() + j) * 2;
            CHECK(std::abs(found[0] - std::cos(phase)) <= 200 * epsilon_of_double);
            CHECK(std::abs(found[1] + std::sin(phase)) <= 200 * epsilon_of_double);
        }
    }
}

// theta = 2 asin(k cd(t, k)) with k = sin(theta_0/2): some 20 steps, and a relative error of k of one unit changes the
// period by as much, times the growth of asin near 1.
TEST_CASE("pendulums in lock step are elliptic functions", "[ode][batch]") {
    batch_march pendulum(system_of("x'' = -sin(x); x(0) = 1; x'(0) = 0"));
    std::vector<double> states;
    for (int i = 1; i <= 25; ++i) {
        states.insert(states.end(), {0.1 * i, 0});
    }
    const auto values = run(pendulum, 0, states, {10});
    for (std::size_t i = 0; i < 25; ++i) {
        const double k = std::sin(states[2 * i] / 2);
        CHECK(std::abs(values[2 * i] - 2 * std::asin(k * boost::math::jacobi_cd(k, 10.0))) <= 1000 * epsilon_of_double);
    }
}

TEST_CASE("a singularity ends its own solution alone", "[ode][batch]") {
    // y = c/(1 - c t): a pole at 1/c, which only some reach, on either side.
    batch_march pole(system_of("y' = y^2; y(0) = 1"));
    std::vector<double> states;
    for (int i = 0; i < 40; ++i) {
        states.push_back(i % 3 == 0 ? 2.0 : i % 3 == 1 ? -1.25 : 0.1);
    }
    const std::vector<double> times{-1, 0.25, 1, -0.75, 2};
    const auto values = run(pole, 0, states, times);
    for (std::size_t i = 0; i < states.size(); ++i) {
        for (std::size_t j = 0; j < times.size(); ++j) {
            const double found = values[i * times.size() + j];
            const double gap = 1 - states[i] * times[j];
            if (gap <= 0) {
                CHECK(std::isnan(found));
            } else {  // an error of c or t of one unit grows by 1/gap
                CHECK(std::abs(found * gap / states[i] - 1) <= 100 * epsilon_of_double / gap);
            }
        }
    }
}

TEST_CASE("solutions of different lengths of steps end where they end alone", "[ode][batch]") {
    // x = sin(w t)/w with w = 1, 2, .., 40: the first ones are done long before the last.
    const auto problem = parse("x'' = -w^2*x; x(0) = 0; x'(0) = 1; w = 1");
    const varied_problem varied(problem, {"w"});
    batch_march march(varied.system(), varied.parameters());
    CHECK(march.size() == 3);
    REQUIRE(march.written() == 2);
    std::vector<double> states;
    for (int w = 1; w <= 40; ++w) {
        const std::array<double, 1> value{static_cast<double>(w)};
        varied.append_state(value, states);
    }
    const auto values = run(march, 0, states, {3});
    for (int w = 1; w <= 40; ++w) {
        // Some 12 w steps, each of an error of some units of the size of x'.
        const double* const found = values.data() + static_cast<std::size_t>(w - 1) * 2;
        CHECK(std::abs(found[0] - std::sin(3.0 * w) / w) <= 20 * w * epsilon_of_double);
        CHECK(std::abs(found[1] - std::cos(3.0 * w)) <= 20 * w * epsilon_of_double);
    }
}

TEST_CASE("parameters in lanes are those in the text", "[ode][batch]") {
    const std::string lorenz = "x' = s*(y - x); y' = x*(r - z) - y; z' = x*y - b*z; x(0) = r/28; y(0) = 0; z(0) = b/4";
    const varied_problem varied(parse(lorenz + "; s = 10; r = 28; b = 2"), {"r", "b"});
    batch_march together(varied.system(), varied.parameters());
    std::vector<double> states;
    for (int i = 0; i < 20; ++i) {
        const std::array<double, 2> value{20.0 + i, 0.5 * i};
        varied.append_state(value, states);
    }
    const auto values = run(together, 0, states, {1});
    for (int i = 0; i < 20; ++i) {
        taylor_march<double> alone(
            system_of(lorenz + "; s = 10; r = " + std::to_string(20 + i) + "; b = " + std::to_string(i) + "/2"));
        const auto& expected = alone.advance_to(1);
        for (std::size_t k = 0; k < 3; ++k) {
            // The first steps differ in rounding, by units of the largest component, and the flow stretches them by up
            // to 50.
            const double found = values[static_cast<std::size_t>(i) * 3 + k];
            CHECK(std::abs(found - expected[k][0]) <= 50 * 64 * epsilon_of_double);
        }
    }
}

TEST_CASE("parameters on either side of an operation, and functions of them alone", "[ode][batch]") {
    const varied_problem varied(
        parse("u' = k^2*(1 + u); v' = v/k - sqrt(k); w' = sin(k)*w; u(0) = 0; v(0) = 0; w(0) = 1; k = 1"), {"k"});
    batch_march march(varied.system(), varied.parameters());
    std::vector<double> states;
    for (int i = 1; i <= 20; ++i) {
        const std::array<double, 1> value{0.25 + 0.05 * i};
        varied.append_state(value, states);
    }
    const auto values = run(march, 0, states, {1});
    for (std::size_t i = 0; i < 20; ++i) {
        const double k = 0.25 + 0.05 * static_cast<double>(i + 1);
        const double* const found = values.data() + 3 * i;
        // A few steps, and an error of k of one unit, which counts 1/k times.
        CHECK(std::abs(found[0] - std::expm1(k * k)) <= 32 * epsilon_of_double * std::exp(k * k));
        CHECK(std::abs(found[1] + k * std::sqrt(k) * std::expm1(1 / k)) <=
              32 / k * epsilon_of_double * std::exp(1 / k));
        CHECK(std::abs(found[2] - std::exp(std::sin(k))) <= 64 * epsilon_of_double);
    }
}

TEST_CASE("initial values vary together with the parameters on which they depend", "[ode][batch]") {
    const auto problem = parse("y' = k*y; x' = y; y(0) = 2*k; x(0) = 1; k = 1");
    const varied_problem varied(problem, {"x(0)", "k"});
    CHECK(varied.names() == 2);
    std::vector<double> states;
    const std::array<double, 2> value{5, -0.5};
    varied.append_state(value, states);
    batch_march march(varied.system(), varied.parameters());
    const auto values = run(march, 0, states, {2});
    REQUIRE(values.size() == 2);
    CHECK(values[0] == Approx(-std::exp(-1.0)).epsilon(1e-14));
    CHECK(values[1] == Approx(5 + 2 * (std::exp(-1.0) - 1)).epsilon(1e-14));
    const std::array<double, 2> other{3, 7};
    states.clear();
    varied.append_state(value, other, states);
    CHECK(run(march, 1, states, {1}) == std::vector<double>{3, 7});
    CHECK_THROWS_WITH(varied_problem(problem, {"m"}), Catch::Matchers::Contains("neither a parameter nor"));
    CHECK_THROWS_WITH(varied_problem(parse("y'' + 2*y'/t + k*y = 0; y(0) = 1; y'(0) = 0; k = 1"), {"k"}),
                      Catch::Matchers::Contains("singular initial point"));
}

TEST_CASE("progress counts solutions, and an exception of it ends them", "[ode][batch]") {
    batch_march spring(system_of("x'' = -x; x(0) = 1; x'(0) = 0"));
    const auto states = states_near_half(3 * batch_lanes, 2);
    const std::vector<double> times{1};
    std::vector<double> values(states.size());
    std::size_t last = 0;
    spring.run({0, states, times}, values, [&](std::size_t finished) {
        CHECK(finished >= last);
        last = finished;
    });
    CHECK(last == 3 * batch_lanes);
    CHECK_THROWS_AS(spring.run({0, states, times}, values, [](std::size_t) { throw std::runtime_error("enough"); }),
                    std::runtime_error);
}

}  // namespace integration_taylor_batch_march_test
