#include "attack/sign_terms.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "attack/step_terms.hpp"

namespace libration::attack {

namespace {

// An argument whose sign is a function of the signs of u and v.
struct signed_argument {
    std::string text;
    std::function<int(int u, int v)> sign;
};

signed_argument any_argument(const std::string& u, const std::string& v, choices& next) {
    const bool first = next.one_in(2);
    const std::string one = first ? u : v;
    const auto of = [=](int a, int b) { return first ? a : b; };
    switch (next.below(14)) {
        case 0: return {fmt::format("max({}, 0)", one), [=](int a, int b) { return std::max(of(a, b), 0); }};
        case 1: return {fmt::format("min({}, 0)", one), [=](int a, int b) { return std::min(of(a, b), 0); }};
        case 2: return {fmt::format("abs({})", one), [=](int a, int b) { return std::abs(of(a, b)); }};
        case 3: return {fmt::format("sign({})", one), of};
        case 4: return {fmt::format("{} - 100 + 100*sign({})", v, u), [](int a, int b) { return a == 1 ? b : -1; }};
        case 5: return {fmt::format("{} + 100 + 100*sign({})", v, u), [](int a, int b) { return a == -1 ? b : 1; }};
        case 6:
            return {fmt::format("sign({}) + sign({})", u, v), [](int a, int b) {
                        return a + b > 0 ? 1 : a + b < 0 ? -1 : 0;
                    }};
        case 7: return {fmt::format("sign({})*sign({})", u, v), [](int a, int b) { return a * b; }};
        default: return {one, of};
    }
}

}  // namespace

sign_term sign_term_choices::number() {
    const long value = next_.between(-3, 3);
    return {value < 0 ? fmt::format("({})", value) : fmt::format("{}", value),
            [=](int, int) { return rational(value); }};
}

sign_term sign_term_choices::conditional(long depth) {
    const signed_argument argument = any_argument(u_, v_, next_);
    const std::string relation = any_relation(next_);
    const sign_term p = any(depth - 1);
    const sign_term q = any(depth - 1);
    return {fmt::format("if({} {} 0, {}, {})", argument.text, relation, p.text, q.text),
            [=](int u, int v) { return holds(relation, argument.sign(u, v)) ? p.value(u, v) : q.value(u, v); }};
}

// A polynomial of the sign of an argument.
sign_term sign_term_choices::smooth(long depth) {
    const signed_argument argument = any_argument(u_, v_, next_);
    const sign_term factor = any(depth - 1);
    const sign_term rest = number();
    const bool squared = next_.one_in(3);
    const bool mean = !squared && next_.one_in(3);
    const std::string step = fmt::format("{}({})", mean ? "heaviside" : "sign", argument.text);
    return {fmt::format("({} + {}*{}{})", rest.text, factor.text, step, squared ? "^2" : ""), [=](int u, int v) {
                const int sign = argument.sign(u, v);
                const rational value = squared ? rational(sign * sign) : mean ? rational(1 + sign, 2) : rational(sign);
                return rational(rest.value(u, v) + factor.value(u, v) * value);
            }};
}

sign_term sign_term_choices::any(long depth) {
    if (depth <= 0) {
        return number();
    }
    return next_.one_in(6) ? number() : next_.one_in(3) ? smooth(depth) : conditional(depth);
}

}  // namespace libration::attack
