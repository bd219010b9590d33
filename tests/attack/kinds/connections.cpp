// Solutions with limits at infinity: manifolds that are graphs, solitons, fronts, moving walls, scaled boundary layers.
#include <fmt/core.h>

#include <vector>

#include "attack/question.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/query/connection/connection.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

struct asked_connection {
    std::string text;
    std::vector<std::string> limits;
    std::string name;
    truth value;
    long most_digits = 40;
    std::vector<std::string> others = {};  // further unknowns
};

std::string near_value(const truth& value, choices& next) {
    return fmt::format("{:.6f}", rough(value) * (1 + 0.01 * static_cast<double>(next.between(-3, 3))));
}

long small(choices& next) { return next.between(1, 4); }

// The linear field s' = -p s, u' = q u with Y = u + k s^2, or also v' = -r v and k s v: the manifold is u = 0.
asked_connection of_graph(choices& next) {
    const constant p = simple_constant(next);
    const constant q = any_constant(next);
    const long k = next.between(1, 5);
    const constant s = simple_constant(next);
    const truth start = [=] { return mpfr(k * s.value() * s.value()); };
    return {fmt::format("s' = -{0}*s; y' = {1}*(y-{2}*s^2)-2*{0}*{2}*s^2; s(0) = {3}; y(0) = {4}", p.text, q.text, k,
                        s.text, near_value(start, next)),
            {"s(inf) = 0", "y(inf) = 0"},
            "y(0)",
            start};
}

// The same with a resonance, r = 2 p, and two stable directions: the manifold is u = 0, Y = u + k s v.
asked_connection of_resonance(choices& next) {
    const long p = small(next);
    const long k = next.between(1, 3);
    const constant v = simple_constant(next);
    const truth start = [=] { return mpfr(k * v.value() / 2); };
    return {fmt::format(
                "s' = -{0}*s; v' = -2*{0}*v + s^2; y' = y-{1}*s*v + {1}*(-3*{0}*s*v + s^3); s(0) = 1/2; v(0) = {2}; "
                "y(0) = {3}",
                p, k, v.text, near_value(start, next)),
            {"s(inf) = 0", "v(inf) = 0", "y(inf) = 0"},
            "y(0)",
            start,
            25};
}

// s' = -p s + j v, v' = -r v with r = p or nearly so: the manifold is u = 0, Y = u + k s v.
asked_connection of_equal_rates(choices& next) {
    const long p = small(next);
    const long k = next.between(1, 3);
    const std::string rate =
        next.one_in(2) ? fmt::format("{}", p) : fmt::format("({}/1000)", 1000 * p + next.between(-3, 3));
    const std::string coupling =
        next.one_in(3) ? "0" : fmt::format("({}/{})", next.between(-4, 4), next.one_in(2) ? 1 : 100);
    const constant v = simple_constant(next);
    const truth start = [=] { return mpfr(k * v.value() / 2); };
    const std::string slope_of_s = fmt::format("(-{}*s + {}*v)", p, coupling);
    const std::string slope_of_v = fmt::format("(-{}*v)", rate);
    return {fmt::format("s' = {0}; v' = {1}; y' = y-{2}*s*v + {2}*({0}*v + s*{1}); s(0) = 1/2; v(0) = {3}; y(0) = {4}",
                        slope_of_s, slope_of_v, k, v.text, near_value(start, next)),
            {"s(inf) = 0", "v(inf) = 0", "y(inf) = 0"},
            "y(0)",
            start,
            25};
}

// u'' = k^2 u - g u^3 has u(0) = k sqrt(2/g); u'' = k^2 u - g u^2 has 3 k^2/(2 g).
asked_connection of_soliton(choices& next) {
    const constant k = simple_constant(next);
    const constant g = simple_constant(next);
    const bool cubic = next.one_in(2);
    const truth start = [=] {
        return cubic ? mpfr(k.value() * sqrt(mpfr(2 / g.value()))) : mpfr(3 * k.value() * k.value() / (2 * g.value()));
    };
    return {fmt::format("u'' = {0}^2*u-{1}*u^{2}; u(0) = {3}; u'(0) = 0", k.text, g.text, cubic ? 3 : 2,
                        near_value(start, next)),
            {"u(inf) = 0"},
            "u(0)",
            start};
}

// u'' + c u' + u (1 - u)(u - a) = 0 from 1 to 0: c = (1 - 2 a)/sqrt 2.
asked_connection of_front(choices& next) {
    const rational a(next.between(1, 9), 20);
    const truth speed = [=] { return mpfr(mpfr(rational(1 - 2 * a)) / sqrt(mpfr(2))); };
    return {fmt::format("u'' + c*u' + u*(1-u)*(u-({}/{})) = 0; u(0) = 0; u'(0) = 0; c = {}", numerator(a).str(),
                        denominator(a).str(), near_value(speed, next)),
            {"u(-inf) = 1", "u(inf) = 0"},
            "c",
            speed,
            30};
}

// y^2 = x^2 - x^3 is an orbit from 0 to 0 for c = a alone, whatever k > 0 is.
asked_connection of_homoclinic(choices& next) {
    const constant a = simple_constant(next);
    const truth parameter = [=] { return a.value(); };
    return {fmt::format("x' = y; y' = x-3/2*x^2+(c-{0})*y-{1}*y*(y^2-x^2+x^3); x(0) = 0; y(0) = 0; c = {2}", a.text,
                        small(next), near_value(parameter, next)),
            {"x(-inf) = 0", "y(-inf) = 0", "x(inf) = 0", "y(inf) = 0"},
            "c",
            parameter,
            25};
}

// f = s + (1 - exp(-l t))/l, l^2 - s l - 1 - M = 0.
asked_connection of_moving_wall(choices& next) {
    const constant s = simple_constant(next);
    const constant m = simple_constant(next);
    const truth slope = [=] {
        const mpfr half = s.value() / 2;
        return mpfr(-(half + sqrt(mpfr(half * half + 1 + m.value()))));
    };
    return {fmt::format("f''' + f*f'' - f'^2 - {}*f' = 0; f(0) = {}; f'(0) = 1; f''(0) = {}", m.text, s.text,
                        near_value(slope, next)),
            {"f'(inf) = 0"},
            "f''(0)",
            slope,
            30};
}

// f''' + a f f'' = 0 with f'(inf) = L: f''(0) = 0.4696.. sqrt(a L) L [Blasius, 38 digits of another program].
asked_connection of_layer(choices& next) {
    const constant a = simple_constant(next);
    const constant limit = simple_constant(next);
    const truth slope = [=] {
        return mpfr(mpfr("0.46959998836101330450933365344758845872") * sqrt(mpfr(a.value() * limit.value())) *
                    limit.value());
    };
    return {fmt::format("f''' + {}*f*f'' = 0; f(0) = 0; f'(0) = 0; f''(0) = {}", a.text, near_value(slope, next)),
            {fmt::format("f'(inf) = {}", limit.text)},
            "f''(0)",
            slope,
            30};
}

// The same with heat, T'' + a f T' = 0: T = T(0) (1 - f'/L), so that T'(0) = -T(0) f''(0)/L.
asked_connection of_heat(choices& next) {
    const constant a = simple_constant(next);
    const constant limit = simple_constant(next);
    const constant wall = simple_constant(next);
    const truth slope = [=] {
        return mpfr(mpfr("-0.46959998836101330450933365344758845872") * sqrt(mpfr(a.value() * limit.value())) *
                    wall.value());
    };
    const truth bend = [=] { return mpfr(-slope() * limit.value() / wall.value()); };
    return {fmt::format(
                "f''' + {0}*f*f'' = 0; T'' + {0}*f*T' = 0; f(0) = 0; f'(0) = 0; T(0) = {1}; T'(0) = -1; f''(0) = {2}",
                a.text, wall.text, near_value(bend, next)),
            {fmt::format("f'(inf) = {}", limit.text), "T(inf) = 0"},
            "T'(0)",
            slope,
            25,
            {"f''(0)"}};
}

asked_connection any_connection(choices& next) {
    switch (next.below(9)) {
        case 0: return of_graph(next);
        case 1: return of_resonance(next);
        case 2: return of_soliton(next);
        case 3: return of_front(next);
        case 4: return of_moving_wall(next);
        case 5: return of_equal_rates(next);
        case 6: return of_heat(next);
        case 7: return of_homoclinic(next);
        default: return of_layer(next);
    }
}

}  // namespace

outcome ask_connection(choices& next) {
    const asked_connection asked = any_connection(next);
    const long digits = next.between(1, asked.most_digits);
    std::string command =
        fmt::format("libration find --problem \"{}\" --unknown \"{}\" --digits {}", asked.text, asked.name, digits);
    for (const std::string& each : asked.others) {
        command += fmt::format(" --unknown \"{}\"", each);
    }
    for (const std::string& each : asked.limits) {
        command += fmt::format(" --such-that \"{}\"", each);
    }
    return answered(command, [&](outcome& result) {
        ode::connection_question question{ode::parse(asked.text), {asked.name}, {}, {}, digits};
        question.unknowns.insert(question.unknowns.end(), asked.others.begin(), asked.others.end());
        for (const std::string& each : asked.limits) {
            question.limits.push_back(ode::parse_limit(question.system, each));
        }
        const auto found =
            ode::proved_connection(question, {}, [](const ball&, long) { require_time_left(); }).values.front();
        result.add(judged(found, digits, asked.value), fmt::format("{} = {}", asked.name, found.text));
    });
}

}  // namespace libration::attack
