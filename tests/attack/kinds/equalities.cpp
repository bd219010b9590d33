// Conditions whose two sides are equal for some time: parameters, steps, equal unknowns, and constants in different forms.
#include <fmt/core.h>

#include <array>

#include "attack/printed_values.hpp"
#include "attack/step_terms.hpp"

namespace libration::attack {

namespace {

// Forms of a whole number: constants, a parameter, unknowns that cancel, and steps of unknowns that keep their sign.
// k = 1, x = 1 + t, w = x, v = -t - 1.
constexpr const char* unknowns = "; x' = 1; x(0) = 1; w' = 1; w(0) = 1; v' = -1; v(0) = -1";

step_term zero(choices& next) {
    static constexpr std::array<const char*, 12> forms{
        "0",         "(k - 1)",           "(x - x)",         "(x - w)",       "(x + v)",      "max(v, 0)",
        "min(x, 0)", "(0.1 + 0.2 - 0.3)", "(sqrt(2)^2 - 2)", "(2*x - w - x)", "(x - abs(v))", "(t - x + 1)"};
    return constant_term(forms[next.below(forms.size())], 0);
}

step_term unit(choices& next) {
    static constexpr std::array<const char*, 12> forms{"1",          "k",           "sign(x)", "heaviside(w)",
                                                       "(-sign(v))", "(w - t)",     "(x - t)", "max(k, 1)",
                                                       "min(x, 1)",  "(1/3 + 2/3)", "sqrt(k)", "(sqrt(2)*sqrt(8)/4)"};
    return constant_term(forms[next.below(forms.size())], 1);
}

// A form of 0.3 whose parts are decimals, of which no sum is exact in double.
step_term three_tenths(choices& next) {
    static constexpr std::array<const char*, 5> forms{"0.3", "(0.1 + 0.2)", "3/10", "(3*0.1)", "(k - 0.7)"};
    return constant_term(forms[next.below(forms.size())], rational(3, 10));
}

struct equal_sides {
    step_term left, right;
};

// Equal on all of the time, on a part of it, or next to each other.
equal_sides any_sides(choices& next) {
    const step_term time = linear_term("t", {0, 1});
    const auto form = [&](long kind) { return kind == 0 ? zero(next) : kind == 1 ? unit(next) : three_tenths(next); };
    const long kind = next.between(0, 2);
    switch (next.below(6)) {
        case 0: return {floor_of(time, 1), number_term(next.between(0, 2))};
        case 1: return {extreme(next.one_in(2), time, unit(next)), unit(next)};
        case 2: return {heaviside(form(0)), constant_term("1/2", rational(1, 2))};
        case 3: return {form(kind), sum(form(kind), constant_term("1e-50", typed_fraction("1e-50")))};
        case 4: {
            const step_term square = square_wave(linear_term("(t)", {0, 1}), "pi*t");
            return {square, unit(next)};
        }
        default: return {form(kind), form(kind)};
    }
}

// if(apart^2 RELATION 0, p, q): apart changes its sign where the square touches 0.
step_term touching(const step_term& apart, const std::string& relation, const step_term& p, const step_term& q) {
    return {fmt::format("if(({})^2 {} 0, {}, {})", apart.text, relation, p.text, q.text),
            [=](const rational& inside) {
                const line value = apart.near(inside);
                const bool zero = value.constant == 0 && value.slope == 0;
                return (holds(relation, zero ? 0 : 1) ? p : q).near(inside);
            },
            [=](partition& ends) {
                for (const step_term& each : {apart, p, q}) {
                    each.divide(ends);
                }
            }};
}

// if(left RELATION right, p, q), or another step of their difference.
step_term compared(choices& next, const step_term& p, const step_term& q) {
    const auto [left, right] = any_sides(next);
    const step_term apart = sum(left, product(number_term(-1), right));
    switch (next.below(9)) {
        case 0: return sum(p, product(sign_of_term(apart), q));
        case 1: return product(heaviside(apart), p);
        case 2: return sum(absolute(apart), q);
        case 4: return touching(apart, any_relation(next), p, q);
        case 3: return conditional(sign_of_term(apart), any_relation(next), zero(next), p, q);
        default: return conditional(left, any_relation(next), right, p, q);
    }
}

}  // namespace

outcome ask_equality(choices& next) {
    const auto number = [&] { return number_term(next.between(-3, 5)); };
    const step_term p = next.one_in(3) ? compared(next, number(), number()) : number();
    const step_term slope = compared(next, p, number());
    const rational time(next.between(1, 36), 12);
    const rational grown = integral(slope, 0, time);
    printed_question question;
    question.problem = fmt::format("y' = {}; y(0) = 0{}{}", slope.text, unknowns,
                                   slope.text.find('k') == std::string::npos ? "" : "; k = 1");
    question.digits = next.between(2, 30);
    question.times = {time.str()};
    question.unknowns = {{"y", {[=] { return real(grown); }}}};
    question.slides = false;
    return asked_program(question);
}

}  // namespace libration::attack
