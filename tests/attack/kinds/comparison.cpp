// Values by theorem G, and of six and more unknowns by theorem V: few and many unknowns, chained by squares, beside exact
// zeros, and backwards.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "attack/question.hpp"

namespace libration::attack {

namespace {

// x0 = u, x1 = v1 + k1 x0^2, x2 = v2 + k2 x1, x3 = v3 + k3 x2^2, .., each in terms of the one before it.
solved_problem chained(std::size_t size, choices& next) {
    const component u = any_component(next);
    solved_problem made = alone(u, "x0");
    std::string slope = u.slope("x0", "t");
    std::string start = u.start.text;
    std::string starts;
    for (std::size_t i = 1; i < size; ++i) {
        const component v = any_component(next);
        const long k = next.between(-2, 2);
        const bool squared = i % 2 == 1 && next.one_in(2);
        const std::string before = made.columns.back();
        const std::string name = "x" + std::to_string(i);
        const std::string added = fmt::format("({})*{}{}", k, before, squared ? "^2" : "");
        const std::string own = v.slope(fmt::format("({}-{})", name, added), "t");
        slope = fmt::format("{}+({})*{}({})", own, k, squared ? "2*" + before + "*" : "", slope);
        start = fmt::format("({})+({})*({}){}", v.start.text, k, start, squared ? "^2" : "");
        made.text += fmt::format("; {}' = {}", name, slope);
        starts += fmt::format("; {}(0) = {}", name, start);
        made.values.emplace_back([value = made.values.back(), v, k, squared](const mpfr& s) {
            const mpfr x = value(s);
            return mpfr(v.value(s) + k * (squared ? mpfr(x * x) : x));
        });
        made.columns.push_back(name);
        made.backward = std::min(made.backward, v.backward);
        made.forward = std::min(made.forward, v.forward);
    }
    made.text += starts;
    return made;
}

// The unknowns of a problem with others that stay 0, which its equations contain.
solved_problem with_zeros(solved_problem problem, choices& next) {
    const std::string other = problem.columns.front();
    const auto count = static_cast<std::size_t>(next.between(1, 3));
    for (std::size_t i = 0; i < count; ++i) {
        const std::string zero = "z" + std::to_string(i);
        const std::string after = "z" + std::to_string((i + 1) % count);
        problem.text += fmt::format("; {0}' = {0}*{1} - {2}^3 + {2}; {0}(0) = 0", zero, other, after);
        problem.columns.push_back(zero);
        problem.values.emplace_back([](const mpfr&) { return mpfr(0); });
    }
    return problem;
}

solved_problem any_compared_problem(choices& next) {
    switch (next.below(6)) {
        case 0: return chained(static_cast<std::size_t>(next.between(2, 8)), next);
        case 1: return chained(static_cast<std::size_t>(next.between(10, 14)), next);
        case 2: return with_zeros(alone(any_component(next), "x"), next);
        case 3: return with_zeros(chained(2, next), next);
        default: return any_problem(next);
    }
}

}  // namespace

outcome ask_comparison(choices& next) {
    const solved_problem problem = any_compared_problem(next);
    const rational since = reached_time(problem, next);
    const long digits = any_digits(next);
    // Of 6 and more unknowns also by theorem V, whose derivative of the flow is then a product of the Jacobian matrix.
    const auto integrator = problem.columns.size() >= 6 && next.one_in(2) ? ode::integrator_choice::taylor
                                                                          : ode::integrator_choice::comparison;
    if (next.one_in(2)) {
        return asked_enclosures(problem, since, 4 * digits + next.between(20, 64), integrator);
    }
    return asked_values(
        problem, since, digits, [](const std::string&) { return verdict::refused; }, integrator);
}

}  // namespace libration::attack
