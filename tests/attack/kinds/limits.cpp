// Limits at equilibria: of components that tend to a constant, alone and mixed.
#include <fmt/core.h>

#include "attack/question.hpp"
#include "libration/query/limit.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

// u' with u = c as its only equilibrium, which is stable; or with c from a positive start.
std::string slope_to(const constant& c, const std::string& u, choices& next) {
    const std::string distance = fmt::format("({}-{})", u, c.text);
    const std::string rate = any_constant(next).text;
    switch (next.below(3)) {
        case 0: return fmt::format("-{}*{}", rate, distance);
        case 1: return fmt::format("-{0}*{1}*(1+{1}^2)", rate, distance);
        default: return fmt::format("-{0}*{1}*exp(-{2})", rate, distance, u);
    }
}

}  // namespace

outcome ask_limit(choices& next) {
    // x = u + k v, y = v.
    const constant u = any_constant(next);
    const constant v = any_constant(next);
    const long k = next.between(-3, 3);
    const long digits = next.between(1, 40);
    const std::string moving = fmt::format("(x-({})*y)", k);
    const std::string slope = slope_to(v, "y", next);
    const std::string text =
        fmt::format("x' = {0} + ({1})*({2}); y' = {2}; x(0) = {3}; y(0) = {4}", slope_to(u, moving, next), k, slope,
                    any_constant(next).text, any_constant(next).text);
    return answered(fmt::format("libration reference --problem \"{}\" --time inf --digits {}", text, digits),
                    [&](outcome& result) {
                        const auto found = ode::limit_at_equilibrium(ode::explicit_system(ode::parse(text)), digits,
                                                                     [](const ball&, long) { require_time_left(); });
                        const truth x = [&] { return mpfr(u.value() + k * v.value()); };
                        add_number(result, found.states.front()[0], digits, x, "x");
                        add_number(result, found.states.front()[1], digits, v.value, "y");
                    });
}

}  // namespace libration::attack
