// Values of stiff problems by collocation: decays at rates up to 10^8 to a solution with a closed form.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "attack/question.hpp"

namespace libration::attack {

namespace {

// Times 1 .. 10^highest.
constant any_rate(long highest, choices& next) {
    const constant a = any_constant(next);
    const long power = next.between(0, highest);
    return {fmt::format("({}*1e{})", a.text, power), [=] { return mpfr(a.value() * pow(mpfr(10), mpfr(power))); }};
}

// w' = -l w (1 + c w^2), c = 0 or 1.
component decay(const constant& l, const constant& start, bool cubic) {
    return {[=](const std::string& w, const std::string&) {
                return "-" + l.text + "*" + w + (cubic ? "*(1+" + w + "^2)" : "");
            },
            start,
            [=](const mpfr& s) {
                const mpfr w = start.value();
                const mpfr left = exp(mpfr(-l.value() * s));
                const mpfr square = cubic ? mpfr(w * w * (1 - left * left)) : mpfr(0);
                return mpfr(w * left / sqrt(mpfr(1 + square)));
            }};
}

component any_decay(choices& next) {
    return decay(any_rate(next.one_in(4) ? 8 : 4, next), any_constant(next), next.one_in(3));
}

// z = u, x = p + u, y = q + k u for p + i q = (p0 + i q0) exp((i m - l) s).
solved_problem spiral(const component& u, choices& next) {
    const constant l = any_rate(6, next);
    const constant m = any_rate(3, next);
    const constant p = any_constant(next);
    const constant q = any_constant(next);
    const long k = next.between(-3, 3);
    solved_problem made = alone(u, "z");
    const std::string f = u.slope("z", "t");
    made.text = fmt::format(
        "z' = {3}; x' = -{0}*(x-z)-{1}*(y-({2})*z)+{3}; y' = {1}*(x-z)-{0}*(y-({2})*z)+({2})*({3}); "
        "z(0) = {6}; x(0) = {4}+{6}; y(0) = {5}+({2})*{6}",
        l.text, m.text, k, f, p.text, q.text, u.start.text);
    const auto turned = [=](const mpfr& s, const truth& real_part, const truth& imaginary_part, int sign) {
        const mpfr angle = m.value() * s;
        return mpfr(exp(mpfr(-l.value() * s)) * (real_part() * cos(angle) + sign * imaginary_part() * sin(angle)));
    };
    made.columns = {"z", "x", "y"};
    made.values = {u.value, [=](const mpfr& s) { return mpfr(turned(s, p.value, q.value, -1) + u.value(s)); },
                   [=](const mpfr& s) { return mpfr(turned(s, q.value, p.value, 1) + k * u.value(s)); }};
    return made;
}

// x0 = u, x1 = w1 + k1 u, x2 = w2 + k2 x1, x3 = w3 + k3 u, and so on: the decays in pairs.
solved_problem star(const component& u, std::size_t pairs, choices& next,
                    const std::function<component(choices&)>& decay_by) {
    solved_problem made = alone(u, "x0");
    std::string starts;
    const auto attracted = [&](const std::string& to, const std::string& slope, const std::string& start,
                               const function& value) {
        const component w = decay_by(next);
        const long k = next.between(1, 3) * (next.one_in(2) ? 1 : -1);
        const std::string name = "x" + std::to_string(made.columns.size());
        const std::string its_slope =
            fmt::format("{}+({})*({})", w.slope(fmt::format("({}-({})*{})", name, k, to), "t"), k, slope);
        const std::string its_start = fmt::format("{}+({})*({})", w.start.text, k, start);
        made.text += fmt::format("; {}' = {}", name, its_slope);
        starts += fmt::format("; {}(0) = {}", name, its_start);
        made.columns.push_back(name);
        made.values.emplace_back([=](const mpfr& s) { return mpfr(w.value(s) + k * value(s)); });
        return std::pair(its_slope, its_start);
    };
    for (std::size_t i = 0; i < pairs; ++i) {
        const auto [slope, start] = attracted("x0", u.slope("x0", "t"), u.start.text, u.value);
        const function value = made.values.back();
        attracted(made.columns.back(), slope, start, value);
    }
    made.text += starts;
    return made;
}

struct stiff_question {
    solved_problem problem;
    rational since;
    long digits;
};

// From 50 unknowns on, frames are multiplied in double: slow decays and few digits, for the time that a question has.
stiff_question any_wide_question(choices& next) {
    const component u = any_component(next);
    const auto mild = [](choices& from) { return decay(any_rate(2, from), any_constant(from), false); };
    const long far = static_cast<long>(std::min(300.0, 900 * u.forward));
    return {star(u, static_cast<std::size_t>(next.between(25, 26)), next, mild),
            decimal_fraction(next.between(std::min(far, 50L), far), 3), next.between(1, 6)};
}

solved_problem any_stiff_problem(choices& next) {
    const component u = any_component(next);
    switch (next.below(6)) {
        case 0: return star(u, static_cast<std::size_t>(next.between(1, 2)), next, any_decay);
        case 1: return spiral(u, next);
        case 2: return beside({u, any_decay(next)});
        case 3: return bent(u, any_decay(next), next.between(1, 3));
        case 4: return bent(any_decay(next), u, next.between(1, 3));
        default: return mixed(u, any_decay(next), next);
    }
}

stiff_question any_stiff_question(choices& next) {
    solved_problem problem = any_stiff_problem(next);
    const double far = std::min(3.0, 0.9 * problem.forward);
    const rational since = decimal_fraction(next.between(1, std::max(1L, static_cast<long>(far * 1000))), 3);
    // Often within the decay.
    const rational early = since / pow(integer(10), static_cast<unsigned>(next.between(0, 6)));
    return {std::move(problem), next.one_in(2) ? early : since, next.between(1, 30)};
}

}  // namespace

outcome ask_stiff(choices& next) {
    const stiff_question asked = next.one_in(16) ? any_wide_question(next) : any_stiff_question(next);
    const auto integrator = next.one_in(4) ? ode::integrator_choice::automatic : ode::integrator_choice::collocation;
    if (next.one_in(3)) {
        return asked_values(
            asked.problem, asked.since, asked.digits, [](const std::string&) { return verdict::refused; }, integrator);
    }
    return asked_enclosures(asked.problem, asked.since, 4 * asked.digits + next.between(20, 64), integrator);
}

}  // namespace libration::attack
