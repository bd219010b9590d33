// Chains of n masses to t = 1: the CPU time of 20 proved digits by theorem V (the derivative of the flow) and by theorem G (a
// comparison system), and of one solution in double, on one thread, once each.
//
//   ./run bench large
//
// Theorem V is left out where it would take minutes. The decimals of both theorems must be the same, and doubles differ from
// them by at most 10^-12: exits with status 1 if one does not. Values that the bits of the last run do not distinguish
// from 0 are those of masses in the middle that only the ends move.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/query/states.hpp"

namespace {

using namespace libration;

constexpr int largest_by_columns = 25;
constexpr double allowed_in_double = 1e-12;

ode::explicit_system chain(int n) {
    return ode::explicit_system(ode::parse(
        fmt::format("q[i]' = p[i] for i = 1..{0}; p[i]' = q[i+1] - 2*q[i] + q[i-1] + ((q[i+1] - q[i])^2 - (q[i] - "
                    "q[i-1])^2)/4 for i = "
                    "1..{0}; q[0] = 0; q[{1}] = 0; q[i](0) = (i mod 3)/5 for i = 1..{0}; p[i](0) = 0 for i = 1..{0}",
                    n, n + 1)));
}

struct timed_states {
    ode::partial_trajectory found;
    double seconds = 0;
};

double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

timed_states proved(const ode::explicit_system& system, ode::integrator_choice by) {
    ode::proof_route route;
    route.integrator = by;
    const double begin = seconds_now();
    auto found = ode::proved_part_of_trajectory(system, {ode::number(rational(1))}, 20, {}, route);
    return {std::move(found), seconds_now() - begin};
}

// Whether the decimals that both have are the same.
bool agree(const ode::partial_trajectory& a, const ode::partial_trajectory& b) {
    for (std::size_t k = 0; k < a.states[0].size(); ++k) {
        const auto& one = a.states[0][k].decimal;
        const auto& other = b.states[0][k].decimal;
        if (one && other && one->text != other->text) {
            return false;
        }
    }
    return true;
}

bool agrees_in_double(const ode::partial_trajectory& proved, const ode::solution_state<double>& rounded) {
    for (std::size_t k = 0; k < rounded.size(); ++k) {
        const auto& decimal = proved.states[0][k].decimal;
        const double exact = decimal ? std::stod(decimal->text) : 0;
        if (!(std::abs(rounded[k][0] - exact) <= allowed_in_double)) {
            return false;
        }
    }
    return true;
}

bool print_row(int n) {
    const ode::explicit_system system = chain(n);
    const timed_states by_box = proved(system, ode::integrator_choice::comparison);
    const auto by_columns =
        n <= largest_by_columns ? std::optional(proved(system, ode::integrator_choice::taylor)) : std::nullopt;
    const double begin = seconds_now();
    ode::taylor_march<double> march(system);
    const auto rounded = march.advance_to(1);
    const double in_double = seconds_now() - begin;
    std::size_t open = 0;
    for (const known_value& each : by_box.found.states[0]) {
        open += each.decimal ? 0 : 1;
    }
    fmt::print("{:>6} {:>12} {:>12.2f} {:>12.4f} {:>20}\n", n,
               by_columns ? fmt::format("{:.2f}", by_columns->seconds) : "-", by_box.seconds, in_double, open);
    return (!by_columns || agree(by_columns->found, by_box.found)) && agrees_in_double(by_box.found, rounded);
}

}  // namespace

int main() {
    fmt::print("{:>6} {:>12} {:>12} {:>12} {:>20}\n", "masses", "V, s", "G, s", "double, s", "not told from 0");
    bool correct = true;
    for (const int n : {10, 25, 50, 100, 300, 1000}) {
        correct = print_row(n) && correct;
        std::fflush(stdout);
    }
    return correct ? 0 : 1;
}
