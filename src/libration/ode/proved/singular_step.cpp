#include "libration/ode/proved/singular_step.hpp"

#include <algorithm>
#include <optional>

#include "libration/ode/ball/fast_product.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/scalar/proved.hpp"
#include "set_values.hpp"

namespace libration::ode {

namespace {

// The step is at most 2^-bits_a_power of the proved radius.
constexpr long bits_a_power = 3;
constexpr int more_powers = 24;

[[noreturn]] void refuse_start(const std::string& why) {
    throw error(error_kind::argument, "problem", "", "starts where its equation is singular, " + why);
}

void require_polynomials(const tape& of) {
    if (of.root() != 1) {
        refuse_start("with powers of a root of the distance, which is not proved: choose another start");
    }
    for (const tape_state& each : of.states()) {
        if (each.derivative > 1) {
            refuse_start("with second derivatives, which is not proved: choose another start");
        }
    }
    using enum operation;
    for (const tape_step& each : of.steps()) {
        switch (each.kind) {
            case constant:
            case variable:
            case state:
            case sum:
            case difference:
            case scaled:
            case raised:
            case delayed:
            case product:
            case square: break;
            default: refuse_start("with more than products of its unknowns, which is not proved: choose another start");
        }
    }
}

int longest_lag(const tape& of) {
    int longest = 0;
    for (const tape_step& each : of.steps()) {
        longest = std::max(longest, each.lag);
    }
    return longest;
}

std::optional<tail_bound> singular_tail_near(const tape& of, const taylor_expansion<ball>& expansion, int degree,
                                             double log_of_radius) {
    magnitude radius = power_of_two(log_of_radius);
    for (int half = 0; half < tried_halves; ++half) {
        radius *= magnitude::of(1, -1);
        if (auto bound = bounded_singular_tail(of, expansion, degree, radius)) {
            return bound;
        }
    }
    return std::nullopt;
}

// |e^(l)| at a distance of at most `distance` for e = O(s^(N+1)) of the norm `error`: n .. (n-l+1) distance^(n-l)/rho^n
// is largest at n = N + 1 where distance <= rho/8.
magnitude derivative_of_tail(const tail_bound& tail, std::size_t unknown, const magnitude& distance, unsigned long l) {
    const auto first = static_cast<unsigned long>(tail.degree) + 1;
    magnitude result = tail.error[unknown] * pow(distance / tail.radius, first - l);
    for (unsigned long j = 0; j < l; ++j) {
        result = result * magnitude(first - j) / tail.radius;
    }
    return result;
}

}  // namespace

singular_step proved_singular_step(const explicit_system& system, long bits) {
    const precision_scope scope(decimal_digits(bits) + 10);
    const tape of = tape::about_start(system);
    require_polynomials(of);
    const int degree = static_cast<int>(bits / bits_a_power) + more_powers;
    taylor_expansion<ball> expansion(of, degree + longest_lag(of) + 1, fast_product<ball>());
    expansion.about_start();
    const std::size_t unknowns = system.unknowns().size();
    magnitude size;
    for (std::size_t i = 0; i < unknowns; ++i) {
        size = std::max(size, magnitude(expansion.coefficients(static_cast<int>(i))[0]));
    }
    const double radius = estimated_radius(expansion, unknowns, size.is_zero() ? magnitude(1U) : size);
    const auto tail = singular_tail_near(of, expansion, degree, radius < no_radius ? radius : 0);
    if (!tail) {
        throw precision_exhausted("the first step from a singular start");
    }
    const long exponent = tail->radius.exponent() - 1 - bits_a_power;
    const magnitude distance = magnitude::of(1, exponent);
    const auto values_within = [&](const ball& s) {
        std::vector<ball> values;
        const auto state = expansion.at(s);
        for (std::size_t i = 0; i < unknowns; ++i) {
            for (std::size_t l = 0; l < state[i].size(); ++l) {
                values.push_back(widened(state[i][l], derivative_of_tail(*tail, i, distance, l)));
            }
        }
        return values;
    };
    const first_order_form form(system);
    const rational step = exponent < 0 ? rational(1, integer(1) << static_cast<unsigned>(-exponent))
                                       : rational(integer(1) << static_cast<unsigned>(exponent));
    return {explicit_system::first_order(form.leaves, form.slopes, system.point() + number(step)),
            values_within(distance.exact()), values_within(hull(ball(0), distance.exact()))};
}

}  // namespace libration::ode
