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

// y'' = a y^p + b y^q: y'^2/2 is the integral of it from 0 to y, and y decays like a power of the time.
asked_connection of_power_decay(choices& next) {
    const constant a = simple_constant(next);
    const constant b = simple_constant(next);
    const constant start = simple_constant(next);
    const rational p(next.between(3, 7), next.one_in(2) ? 1 : 2);
    const rational q = p + next.between(1, 3);
    const bool has_second = !next.one_in(3);
    const truth slope = [=] {
        const auto part = [&](const constant& of, const rational& power) {
            return mpfr(2 * of.value() * pow(start.value(), mpfr(rational(power + 1))) / mpfr(rational(power + 1)));
        };
        return mpfr(-sqrt(has_second ? mpfr(part(a, p) + part(b, q)) : part(a, p)));
    };
    const auto text = [](const rational& power) {
        return fmt::format("({}/{})", numerator(power).str(), denominator(power).str());
    };
    return {fmt::format("y'' = {}*y^{} + {}*y^{}; y(0) = {}; y'(0) = {}", a.text, text(p), has_second ? b.text : "0",
                        text(q), start.text, near_value(slope, next)),
            {"y(inf) = 0"},
            "y'(0)",
            slope,
            25};
}

// Thomas and Fermi in any scaling, y'' = c y^(3/2)/sqrt t: with t = L s, y = y(0) u, L^(3/2) c sqrt(y(0)) = 1 [digits of Boyd2013 and others].
// Or with the solution A/t^m of y'' + k y'/t = c t^p y^q itself, m = (p+2)/(q-1).
asked_connection of_atom(choices& next) {
    const constant c = simple_constant(next);
    if (next.one_in(2)) {
        const constant start = simple_constant(next);
        const truth slope = [=] {
            const mpfr length = pow(mpfr(1 / (c.value() * sqrt(start.value()))), mpfr(mpfr(2) / 3));
            return mpfr(mpfr("-1.588071022611375312718684509423950109453") * start.value() / length);
        };
        return {
            fmt::format("y'' = {}*y^(3/2)/sqrt(t); y(0) = {}; y'(0) = {}", c.text, start.text, near_value(slope, next)),
            {"y(inf) = 0"},
            "y'(0)",
            slope,
            25};
    }
    const long m = next.between(2, 3);
    const long k = next.between(0, 2);
    const long q = next.between(2, 3);
    const long p = m * (q - 1) - 2;
    const long t = next.between(1, 3);
    const truth start = [=] {  // A^(q-1) c = m (m + 1 - k)
        const mpfr scale = pow(mpfr(mpfr(m * (m + 1 - k)) / c.value()), mpfr(mpfr(1) / mpfr(q - 1)));
        return mpfr(scale / pow(mpfr(t), mpfr(m)));
    };
    const truth slope = [=] { return mpfr(-mpfr(m) * start() / mpfr(t)); };
    return {fmt::format("y'' = {}*t^{}*y^{} - {}*y'/t; y({}) = (({})/{})^(1/{})/{}^{}; y'({}) = {}", c.text, p, q, k, t,
                        m * (m + 1 - k), c.text, q - 1, t, m, t, near_value(slope, next)),
            {"y(inf) = 0"},
            fmt::format("y'({})", t),
            slope,
            25};
}

// y = u - k/t solves y'' = c^2 y - g y^2, y = 3 c^2/(2 g) sech^2(c (t - t_0)/2).
asked_connection of_moving_field(choices& next) {
    const constant c = simple_constant(next);
    const constant g = simple_constant(next);
    const long k = next.between(0, 3);
    const long t = next.between(1, 3);
    const truth start = [=] { return mpfr(3 * c.value() * c.value() / (2 * g.value()) + mpfr(k) / mpfr(t)); };
    return {fmt::format("u'' = {0}^2*(u-{1}/t) - {2}*(u-{1}/t)^2 + 2*{1}/t^3; u'({3}) = -{1}/{3}^2; u({3}) = {4}",
                        c.text, k, g.text, t, near_value(start, next)),
            {"u(inf) = 0"},
            fmt::format("u({})", t),
            start,
            20};
}

// u'' + (D-1) u'/t = c u - d u^P is scaled from c = d = 1 [digits of another program, by sign changes; literature: 2.20620, 4.19169, 4.33739].
asked_connection of_ground_state(choices& next) {
    struct ground_state {
        long dimension, power;
        const char* start;
    };
    static constexpr ground_state known[] = {{2, 3, "2.2062008646507460747836340645789"},
                                             {3, 2, "4.1916829544425191267766360373"},
                                             {3, 3, "4.3373876799769943565221091738"}};
    const ground_state& of = known[next.below(3)];
    const constant c = simple_constant(next);
    const constant d = simple_constant(next);
    const truth start = [=] {
        const mpfr ratio = c.value() / d.value();
        return mpfr(mpfr(of.start) * (of.power == 2 ? ratio : mpfr(sqrt(ratio))));
    };
    return {fmt::format("u'' + {}*u'/t - {}*u + {}*u^{} = 0; u'(0) = 0; u(0) = {}", of.dimension - 1, c.text, d.text,
                        of.power, near_value(start, next)),
            {"u(inf) = 0"},
            "u(0)",
            start,
            20};
}

// y'' + p y' = q y with q = h' + h^2 + p h has the solution y'/y = h, here -(a + b t + c t^2) + e/(t + 9), which tends to 0. If q < 0
// at infinity, others may tend to 0 too: then no answer is true.
asked_connection of_linear_decay(choices& next) {
    struct damping {
        const char* text;
        double (*value)(double t);
    };
    static constexpr damping dampings[] = {{"0", [](double) { return 0.; }},
                                           {"2", [](double) { return 2.; }},
                                           {"t", [](double t) { return t; }},
                                           {"4*t^3", [](double t) { return 4 * t * t * t; }},
                                           {"(-1/(t^2+1))", [](double t) { return -1 / (t * t + 1); }},
                                           {"2/(t+5)", [](double t) { return 2 / (t + 5); }}};
    const damping& p = dampings[next.below(6)];
    const long degree = next.between(0, 2);
    const long a = degree == 0 ? next.between(1, 3) : next.between(-2, 2);
    const long b = degree == 0 ? 0 : degree == 1 ? next.between(1, 3) : next.between(-2, 2);
    const long c = degree == 2 ? next.between(1, 3) : 0;
    const long e = next.between(0, 2);
    const std::string h = fmt::format("({}/(t+9) - ({} + {}*t + {}*t^2))", e, a, b, c);
    const rational t(next.between(-6, 12), next.one_in(2) ? 4 : 3);
    const constant start = simple_constant(next);
    const double far = 1e6;
    const double slope = -(static_cast<double>(a) + static_cast<double>(b) * far + static_cast<double>(c) * far * far);
    const bool is_determined = slope * (slope + p.value(far)) >= 0;
    const truth value = [=] {
        const rational rate = rational(e) / (t + 9) - (a + b * t + c * t * t);
        return mpfr(start.value() * mpfr(rate) + (is_determined ? 0 : 1));
    };
    const std::string point = fmt::format("({}/{})", numerator(t).str(), denominator(t).str());
    return {fmt::format("y'' + {0}*y' = ({1}^2 + {0}*{1} - {2}/(t+9)^2 - {3} - 2*{4}*t)*y; y({5}) = {6}; y'({5}) = -1",
                        p.text, h, e, b, c, point, start.text),
            {"y(inf) = 0"},
            fmt::format("y'({})", point),
            value};
}

// m + a tanh(b t) and m + 4 atan(tanh(b t/2)) with y(0) = m, m + a sech^2(b t) with y'(0) = 0, which reversals of time map
// to themselves. With friction there are no such orbits: then no answer is true.
asked_connection of_symmetric_orbit(choices& next) {
    const constant a = simple_constant(next);
    const constant b = simple_constant(next);
    const long m = next.between(-3, 3);
    const long t = next.between(-2, 2);
    const bool is_true = !next.one_in(4);
    const std::string friction = is_true ? "" : " + y'/7";
    if (next.one_in(3)) {
        const truth start = [=] { return mpfr(a.value() + m + (is_true ? 0 : 1)); };
        return {fmt::format("y'' = 4*{0}^2*(y-({1})) - 6*{0}^2/{2}*(y-({1}))^2{3}; y'({4}) = 0; y({4}) = {5}", b.text,
                            m, a.text, friction, t, near_value(start, next)),
                {fmt::format("y(-inf) = {}", m), fmt::format("y(inf) = {}", m)},
                fmt::format("y({})", t),
                start};
    }
    const bool of_sine = next.one_in(2);
    const std::string half = of_sine ? "pi" : a.text;
    const std::string field = of_sine ? fmt::format("-{}^2*sin(y-({}))", b.text, m)
                                      : fmt::format("2*{0}^2/{1}^2*(y-({2}))*((y-({2}))^2-{1}^2)", b.text, a.text, m);
    const truth slope = [=] { return mpfr(b.value() * (of_sine ? mpfr(2) : a.value()) + (is_true ? 0 : 1)); };
    return {fmt::format("y'' = {}{}; y({}) = {}; y'({}) = {}", field, friction, t, m, t, near_value(slope, next)),
            {fmt::format("y(-inf) = {} - {}", m, half), fmt::format("y(inf) = {} + {}", m, half)},
            fmt::format("y'({})", t),
            slope};
}

// m + a sech^2(b (t - s)) has the amplitude A = 4 a exp(2 b s), and y(0) = m + 4 a/(q + 2 + 1/q), q = A/(4 a).
asked_connection of_amplitude(choices& next) {
    const constant a = simple_constant(next);
    const constant b = simple_constant(next);
    const constant amplitude = any_constant(next);
    const long m = next.between(-3, 3);
    const truth start = [=] {
        const mpfr q = amplitude.value() / (4 * a.value());
        return mpfr(m + 4 * a.value() / (q + 2 + 1 / q));
    };
    return {fmt::format("y'' = 4*{0}^2*(y-({1})) - 6*{0}^2/{2}*(y-({1}))^2; y(0) = 1; y'(0) = 1", b.text, m, a.text),
            {fmt::format("y(inf) = {} with amplitude {}", m, amplitude.text)},
            "y(0)",
            start,
            40,
            {"y'(0)"}};
}

asked_connection any_connection(choices& next) {
    switch (next.below(16)) {
        case 15: return of_amplitude(next);
        case 14: return of_symmetric_orbit(next);
        case 9: return of_power_decay(next);
        case 10: return of_atom(next);
        case 11: return of_moving_field(next);
        case 12: return of_ground_state(next);
        case 13: return of_linear_decay(next);
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
