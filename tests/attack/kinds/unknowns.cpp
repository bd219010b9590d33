// Parameters and initial values that satisfy a condition, and periodic orbits.
#include <fmt/core.h>

#include <cmath>

#include "attack/facts.hpp"
#include "attack/question.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"
#include "libration/query/shooting/proved_unknowns.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

// A problem with an unknown number that is `value`, with a guess nearby.
struct asked_unknown {
    std::string text, name, condition;
    truth value;
    long derivative = 0;
};

std::string near_to(const truth& value, choices& next) {
    const precision_scope scope(30);
    const double about = value().convert_to<double>() * (1 + 0.02 * static_cast<double>(next.between(-3, 3)));
    return fmt::format("{:.5f}", about);
}

asked_unknown of_rate(choices& next) {
    const constant c = any_constant(next);
    const rational time(next.between(1, 5), next.between(1, 4));
    const truth value = [=] { return mpfr(log(mpfr(3 * c.value())) / real(time)); };
    return {fmt::format("y' = k*y; y(0) = 1/3; k = {}", near_to(value, next)), "k",
            fmt::format("y({}) = {}", time.str(), c.text), value};
}

asked_unknown of_pole(choices& next) {
    const constant a = any_constant(next);
    const constant c = any_constant(next);
    const truth value = [=] { return mpfr(c.value() / (1 + a.value() * c.value() / 2)); };
    return {fmt::format("y' = {}*y^2; y(0) = {}", a.text, near_to(value, next)), "y(0)",
            fmt::format("y(1/2) = {}", c.text), value};
}

asked_unknown of_oscillator(choices& next) {
    const constant c = any_constant(next);
    const constant p = any_constant(next);
    const truth value = [=] { return mpfr((c.value() - p.value() * cos(mpfr(1))) / sin(mpfr(1))); };
    return {fmt::format("y'' = -y; y(0) = {}; y'(0) = {}", p.text, near_to(value, next)), "y'(0)",
            fmt::format("y(1) = {}", c.text), value};
}

// Y = v + u^2, v' = a v, u' = u: the initial value of Y from its value later.
asked_unknown of_bent(choices& next) {
    const constant a = any_constant(next);
    const constant c = any_constant(next);
    const truth value = [=] {
        const mpfr later = c.value() - exp(mpfr(2));
        return mpfr(later * exp(mpfr(-a.value())) + 1);
    };
    return {fmt::format("x' = x; y' = {}*(y-x^2)+2*x*x; x(0) = 1; y(0) = {}", a.text, near_to(value, next)), "y(0)",
            fmt::format("y(1) = {}", c.text), value};
}

// A parameter that moves the initial value, y = p^2 e^(a t), or the initial point, y = e^(a (t - p)).
asked_unknown of_moved_start(choices& next) {
    const constant a = any_constant(next);
    const constant c = any_constant(next);
    const bool value_moves = next.one_in(2);
    const truth value = [=] {
        return value_moves ? mpfr(sqrt(mpfr(c.value() * exp(mpfr(-2 * a.value())))))
                           : mpfr(2 - log(c.value()) / a.value());
    };
    return {fmt::format("y' = {}*y; {}; p = {}", a.text, value_moves ? "y(0) = p^2" : "y(p) = 1", near_to(value, next)),
            "p", fmt::format("y(2) = {}", c.text), value};
}

asked_unknown any_unknown(choices& next) {
    switch (next.below(5)) {
        case 0: return of_rate(next);
        case 1: return of_pole(next);
        case 2: return of_oscillator(next);
        case 3: return of_moved_start(next);
        default: return of_bent(next);
    }
}

ode::conditions_at_times condition_of(const ode::equation_system& system, const std::string& text) {
    ode::conditions_at_times only;
    ode::add_condition(only, system, text);
    return only;
}

}  // namespace

outcome ask_unknown(choices& next) {
    const asked_unknown asked = any_unknown(next);
    const long digits = next.between(1, 60);
    return answered(fmt::format("libration find --problem \"{}\" --unknown \"{}\" --such-that \"{}\" --digits {}",
                                asked.text, asked.name, asked.condition, digits),
                    [&](outcome& result) {
                        const auto system = ode::parse(asked.text);
                        const auto found =
                            ode::proved_unknowns(system, {asked.name}, condition_of(system, asked.condition), digits,
                                                 {}, [](const ball&, long) { require_time_left(); })
                                .front();
                        result.add(judged(found, digits, asked.value), fmt::format("{} = {}", asked.name, found.text));
                    });
}

// u' = a u - w v - b u (u^2 + v^2), v' = w u + a v - b v (u^2 + v^2): the circle of radius sqrt(a/b), period 2 pi/w;
// X = u, Y = v + k u^2.
outcome ask_orbit(choices& next) {
    // The orbit attracts like exp(-2 a t): within one period not beyond the default precision.
    const constant a = next.one_in(2) ? near_one(next) : constant_of(rational(1, next.between(1, 9)));
    const constant w = next.one_in(2) ? near_one(next) : constant_of(next.between(1, 9));
    const long b = next.between(1, 4);
    const long k = next.between(0, 2);
    const truth radius = [=] { return mpfr(sqrt(mpfr(a.value() / b))); };
    const std::string v = k == 0 ? "y" : fmt::format("(y-{}*x^2)", k);
    const std::string square = fmt::format("(x^2+{}^2)", v);
    const std::string of_u = fmt::format("{}*x-{}*{}-{}*x*{}", a.text, w.text, v, b, square);
    const std::string of_v = fmt::format("{}*x+{}*{}-{}*{}*{}", w.text, a.text, v, b, v, square);
    double about = 0;
    {
        const precision_scope scope(30);
        about = radius().convert_to<double>();
    }
    const double near = about * (1 + 0.01 * static_cast<double>(next.between(-3, 3)));
    const std::string text = fmt::format("x' = {0}; y' = {1}+{2}*x*({0}); x(0) = {3:.6f}; y(0) = {4:.6f}", of_u, of_v,
                                         2 * k, near, static_cast<double>(k) * near * near);
    const long digits = next.between(1, 30);
    return answered(
        fmt::format("libration find --problem \"{}\" --periodic --digits {}", text, digits), [&](outcome& result) {
            const auto orbit =
                ode::proved_periodic_orbit(system_of(text), digits, {}, [](const ball&, long) { require_time_left(); });
            const truth period = [=] { return mpfr(8 * atan(mpfr(1)) / w.value()); };
            result.add(judged(orbit.period, digits, period), "period = " + orbit.period.text);
            // One coordinate is fixed: at (r, 0) the other one moves along the section. With k = 0 that is y = 0.
            if (k == 0) {
                result.add(judged(orbit.start[0], digits, radius), "x = " + orbit.start[0].text);
            }
        });
}

}  // namespace libration::attack
