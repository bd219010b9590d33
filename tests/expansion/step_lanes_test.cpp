// Steps in the lanes of vectors give the same values as single steps, to the last bit.
#include "libration/expansion/step_lanes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/scalar/precision_scope.hpp"
#include "libration/scalar/vector_instructions.hpp"

namespace expansion_step_lanes_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr int order = 41;

// Two unknowns u, v with every step that has lanes, some that have none, and initial values that depend on the number.
std::string equations(int number, const std::string& suffix) {
    const std::string u = "u" + suffix;
    const std::string v = "v" + suffix;
    const std::string start = std::to_string(number + 1);
    return u + "' = (" + u + " - 3*" + v + ")^2 + " + u + "*" + v + "/(1 + " + v + "^2) - sqrt(2 + " + u + "^2); " + v +
           "' = sin(" + u + ") - " + v + "/(2 + " + u + "); " + u + "(0) = 1/" + start + "; " + v + "(0) = " + start +
           "/7";
}

explicit_system systems_together(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += (i > 0 ? "; " : "") + equations(i, std::to_string(i));
    }
    return explicit_system(parse(text));
}

// The initial point of the system, not an integer multiple of anything.
solution_state<double> state_of(const explicit_system& system) {
    const tape start = tape::about_start(system);
    taylor_expansion<double> expansion(start, 2);
    expansion.about_start();
    solution_state<double> state;
    for (int i = 0; i < static_cast<int>(start.orders().size()); ++i) {
        state.push_back({expansion.coefficients(i)[0] + 1e-3 * i});
    }
    return state;
}

// The steps that run together; none if there are no groups.
std::size_t groups_of(const tape& of) {
    std::vector<double> arrays(of.steps().size());
    const step_lanes lanes(of, arrays.data(), 1, std::vector<double>(of.steps().size(), 1));
    std::size_t groups = 0;
    for (const step_lanes::entry& each : lanes.order()) {
        groups += each.alone ? 0 : each.count;
    }
    return groups;
}

}  // namespace

TEST_CASE("steps in lanes give the coefficients of steps alone to the last bit", "[ode]") {
    const precision_scope scope(30);
    for (const int count : {3, 6, 8, 17}) {
        const explicit_system together = systems_together(count);
        const tape tape_of_all = tape::about_points(together);
        CHECK(groups_of(tape_of_all) > 0);
        const solution_state<double> state = state_of(together);
        std::vector<std::string> sets = vector_instructions();
        for (const std::string& instructions : sets) {
            const vector_instructions_scope by(instructions);
            taylor_expansion<double> all(tape_of_all, order);
            for (int pass = 0; pass < 2; ++pass) {  // the arrays are reused
                all.about(0.25, state);
            }
            for (int i = 0; i < count; ++i) {
                INFO(instructions << ", system " << i << " of " << count);
                const explicit_system alone = explicit_system(parse(equations(i, "")));
                const tape tape_of_one = tape::about_points(alone);
                CHECK(groups_of(tape_of_one) == 0);
                taylor_expansion<double> one(tape_of_one, order);
                one.about(0.25, {state[static_cast<std::size_t>(2 * i)], state[static_cast<std::size_t>(2 * i + 1)]});
                for (int unknown = 0; unknown < 2; ++unknown) {
                    for (int n = 0; n <= order; ++n) {
                        INFO("coefficient " << n);
                        REQUIRE(all.coefficients(2 * i + unknown)[n] == one.coefficients(unknown)[n]);
                    }
                }
            }
        }
    }
}

TEST_CASE("right sides and watched expressions are there when their steps run in lanes", "[ode]") {
    const precision_scope scope(30);
    const explicit_system together = systems_together(6);
    std::vector<ode::expression> watched;
    for (int i = 0; i < 6; ++i) {
        const std::string number = std::to_string(i);
        watched.push_back(ode::unknown("u" + number) * ode::unknown("v" + number));
    }
    const tape of = tape::about_points(together, watched);
    taylor_expansion<double> expansion(of, order);
    expansion.about(0, state_of(together));
    for (int i = 0; i < 6; ++i) {
        const double* const u = expansion.coefficients(2 * i);
        const double* const v = expansion.coefficients(2 * i + 1);
        for (int n = 0; n < order; ++n) {
            // y'_n = (n + 1) y_{n+1}, a quotient and a product that round once each.
            CHECK(std::abs(expansion.right_side(2 * i)[n] - u[n + 1] * (n + 1)) <=
                  2 * epsilon<double>() * std::abs(u[n + 1] * (n + 1)));
            double product = 0;
            double size = 0;
            for (int k = 0; k <= n; ++k) {
                product += u[k] * v[n - k];
                size += std::abs(u[k] * v[n - k]);
            }
            // Two sums of n + 1 products, each product and each sum rounded.
            CHECK(std::abs(expansion.watched(i)[n] - product) <= 2 * (n + 2) * epsilon<double>() * size);
        }
    }
}

}  // namespace expansion_step_lanes_test
