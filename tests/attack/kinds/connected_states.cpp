// States of solutions that limits at infinity determine: at the start, beyond the time from which on they are on a manifold, and at the ends.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

#include "attack/question.hpp"
#include "libration/problem/limit_solution.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

struct connected_solution {
    std::string text;
    std::vector<std::string> limits;
    std::string unknown;
    std::string quantity;
    std::function<mpfr(const mpfr& t)> value;
    truth amplitude;  ///< of the quantity at inf; empty if it has none
    bool two_ends = false;
    long most_digits = 30;
};

std::string guess_near(const mpfr& value, choices& next) {
    return fmt::format("{:.6f}", value.convert_to<double>() * (1 + 0.01 * static_cast<double>(next.between(-3, 3))));
}

// k sqrt(2/g) sech(k t).
connected_solution sech_soliton(choices& next) {
    const constant k = simple_constant(next);
    const constant g = simple_constant(next);
    const auto height = [=] { return mpfr(k.value() * sqrt(mpfr(2 / g.value()))); };
    return {fmt::format("u'' = {0}^2*u-{1}*u^3; u(0) = {2}; u'(0) = 0", k.text, g.text, guess_near(height(), next)),
            {"u(inf) = 0"},
            "u(0)",
            "u",
            [=](const mpfr& t) { return mpfr(height() / cosh(mpfr(k.value() * t))); },
            [=] { return mpfr(2 * height()); }};
}

// 1/(1 + exp(k t)), k = 1/sqrt 2: the amplitude at -inf is -1, which fixes t = 0.
connected_solution logistic_front(choices& next) {
    const rational a(next.between(1, 9), 20);
    const mpfr speed = mpfr(rational(1 - 2 * a)) / sqrt(mpfr(2));
    return {fmt::format("u'' + c*u' + u*(1-u)*(u-({}/{})) = 0; u(0) = 0; u'(0) = 0; c = {}", numerator(a).str(),
                        denominator(a).str(), guess_near(speed, next)),
            {"u(-inf) = 1", "u(inf) = 0"},
            "c",
            "u",
            [](const mpfr& t) { return mpfr(1 / (1 + exp(mpfr(t / sqrt(mpfr(2)))))); },
            [] { return mpfr(1); },
            true,
            25};
}

// x = sech^2((t - log 4)/2), which is exp(t) + .. and 16 exp(-t) + ..: y^2 = x^2 - x^3.
connected_solution cubic_loop(choices& next) {
    const constant a = simple_constant(next);
    return {fmt::format("x' = y; y' = x-3/2*x^2+(c-{0})*y-{1}*y*(y^2-x^2+x^3); x(0) = 0; y(0) = 0; c = {2}", a.text,
                        next.between(1, 3), guess_near(a.value(), next)),
            {"x(-inf) = 0", "y(-inf) = 0", "x(inf) = 0", "y(inf) = 0"},
            "c",
            "x",
            [](const mpfr& t) {
                const mpfr c = cosh(mpfr((t - log(mpfr(4))) / 2));
                return mpfr(1 / (c * c));
            },
            [] { return mpfr(16); },
            true,
            20};
}

// s = exp(-p t)/2, v = (v0 + t/4) exp(-2 p t), y = k s v: a resonance, where theta does not move linearly.
connected_solution resonant_graph(choices& next) {
    const long p = next.between(1, 3);
    const long k = next.between(1, 3);
    const constant v = simple_constant(next);
    return {fmt::format(
                "s' = -{0}*s; v' = -2*{0}*v + s^2; y' = y-{1}*s*v + {1}*(-3*{0}*s*v + s^3); s(0) = 1/2; v(0) = {2}; "
                "y(0) = {3}",
                p, k, v.text, guess_near(mpfr(k * v.value() / 2), next)),
            {"s(inf) = 0", "v(inf) = 0", "y(inf) = 0"},
            "y(0)",
            "y",
            [=](const mpfr& t) { return mpfr(k * (v.value() + t / 4) * exp(mpfr(-3 * p * t)) / 2); },
            nullptr,
            false,
            15};
}

connected_solution any_connected(choices& next) {
    switch (next.below(4)) {
        case 0: return sech_soliton(next);
        case 1: return logistic_front(next);
        case 2: return cubic_loop(next);
        default: return resonant_graph(next);
    }
}

known_value known_in(const answer& of, std::size_t row, const std::string& name) {
    const auto column = static_cast<std::size_t>(std::ranges::find(of.names, name) - of.names.begin());
    const answer_value& value = of.rows.at(row).at(column);
    return value.text.empty() ? known_value{std::nullopt, value.bound}
                              : known_value{proved_decimal{value.text, value.bound}, ""};
}

}  // namespace

outcome ask_connected_state(choices& next) {
    const precision_scope scope(60);
    const connected_solution asked = any_connected(next);
    const long digits = next.between(1, asked.most_digits);
    rational time(next.between(0, 12), next.between(1, 4));
    time *= next.one_in(4) ? 5 : 1;
    if (asked.two_ends && next.one_in(2)) {
        time = -time;
    }
    std::string typed = asked.text;
    for (const std::string& each : asked.limits) {
        typed += "; " + each;
    }
    return answered(
        fmt::format(
            "libration reference --problem \"{}\" --unknown \"{}\" --times \"{},inf\" --digits {} --show amplitude",
            typed, asked.unknown, time.str(), digits),
        [&](outcome& result) {
            request how = proved_digits(digits);
            how.reached = [](double, long) { require_time_left(); };
            const limit_solution of({problem(asked.text), {asked.unknown}, asked.limits, {}});
            const answer found = of.states({exactly(time), {0, unit::one, "inf"}}, {"amplitude"}, how);
            add_number(
                result, known_in(found, 0, asked.quantity), digits, [&] { return asked.value(mpfr(time)); },
                asked.quantity);
            if (asked.amplitude) {
                add_number(result, known_in(found, 1, "amplitude of " + asked.quantity), digits, asked.amplitude,
                           "amplitude");
            }
            if (found.at(1, asked.quantity) != "0") {
                throw std::logic_error("the limit is " + found.at(1, asked.quantity) + ", not 0");
            }
        });
}

}  // namespace libration::attack
