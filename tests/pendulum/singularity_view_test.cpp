// Theorem A1: the contribution of the omitted poles is below its bound, and not far below.
#include "libration/pendulum/singularity_view.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/pendulum/expansion.hpp"
#include "pendulum/typed.hpp"
#include "proved.hpp"

namespace pendulum_singularity_view_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using namespace libration::tests;

namespace {

singularity_view<ball> view_of(const motion& m, const std::string& at) {
    return *view_from(m, phase_of(read_expansion_point(at), exact_solution<ball>(m)));
}

// sum |z|^-4 over both half planes, from the poles within a large reach: a lower bound of S4.
ball part_of_fourth_powers(const singularity_view<ball>& view, const ball& reach) {
    ball sum(0);
    for (const auto& pole : view.within(reach)) {
        sum += ball(pole.weight < 0 ? -2 * pole.weight : 2 * pole.weight) / (pole.square * pole.square);
    }
    return sum;
}

}  // namespace

TEST_CASE("the bound of S4 is above the sum, by no more than its simple form loses", "[singularity_view][ball]") {
    const precision_scope scope(30);
    struct place {
        std::string energy;
        std::string at;
        int most;  // bound/sum, rounded up
    };
    const std::vector<place> places{{"0.5", "top", 3},  {"1.71", "top", 4},    {"1.71", "bottom", 2},
                                    {"1.71", "T/8", 3}, {"2.02", "bottom", 2}, {"2.02", "T/8", 6},
                                    {"4", "top", 3},    {"100", "T/8", 3},     {"1e-6", "top", 6},
                                    {"2", "bottom", 2}, {"2", "3", 5}};
    for (const auto& [energy, at, most] : places) {
        INFO("E = " << energy << " about " << at);
        const auto view = view_of(with_energy(energy), at);
        const ball sum = part_of_fourth_powers(view, view.radius() * 40);
        const ball ratio = view.fourth_powers() / sum;
        INFO(text_of(ratio));
        CHECK(certainly_less(ball(1), ratio));
        CHECK(certainly_less(ratio, ball(most)));
    }
}

TEST_CASE("what is left out of the sum for a coefficient is below theorem A1", "[singularity_view][ball]") {
    const precision_scope scope(60);
    const int n = 40;
    for (const std::string energy : {"0.5", "1.71", "2.02", "4", "2"}) {
        for (const std::string at : {"bottom", "1.1"}) {
            INFO("E = " << energy << " about " << at);
            const motion m = with_energy(energy);
            const auto view = view_of(m, at);
            // The poles within R alone; the recurrence is the whole sum, at n = 40 or the next power that exists.
            const auto whole =
                expand_by(recurrence::symmetric_squares, exact_solution<ball>(m), read_expansion_point(at), n + 1);
            const long power = view.powers().next(n);
            ball sum(0);
            ball next = view.radius() * 100;
            for (const auto& pole : view.within(view.radius() * 30)) {
                if (certainly_less(view.radius() * view.radius() * 101 / 100, pole.square)) {
                    next = sqrt(pole.square);
                    break;
                }
                const ball size = pow(ball(view.radius() / sqrt(pole.square)), power);
                sum += size * sin(-atan2(pole.height, pole.along) * power) * pole.weight;
            }
            const ball left_out =
                whole.scaled[static_cast<int>(power)] * pow(view.radius() / whole.scale, power) + sum * 4 / power;
            const ball fourth = next * next * next * next * view.fourth_powers();
            const ball bound = fourth * pow(ball(view.radius() / next), power) * 2 / power;
            const ball ratio = bound / abs(left_out);
            INFO(text_of(ratio));
            CHECK(certainly_less(abs(left_out), bound));
            CHECK(certainly_less(ratio, ball(3000)));
        }
    }
}

}  // namespace pendulum_singularity_view_test
