// Derivatives of solutions with respect to initial values and parameters, smooth and across events.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>

#include "attack/question.hpp"
#include "libration/query/flow_derivatives.hpp"
#include "libration/query/hybrid_derivatives.hpp"

namespace libration::attack {

namespace {

// An unknown of the state at the time, and its derivatives with respect to the numbers in order.
struct differentiated_unknown {
    std::string name;
    truth value;
    std::vector<truth> by;
};

struct differentiated_problem {
    std::string text;
    std::vector<std::string> numbers;
    rational time;
    std::vector<differentiated_unknown> unknowns;
    bool has_events = false;
};

rational any_time(choices& next) { return decimal_fraction(next.between(1, 4000), 3); }

// y = s e + c (e - 1)/k, e = e^(k t).
differentiated_problem differentiated_linear(choices& next) {
    const constant k = any_constant(next);
    const constant c = any_constant(next);
    const constant s = any_constant(next);
    const rational time = any_time(next);
    const auto growth = [=] { return mpfr(exp(mpfr(k.value() * real(time)))); };
    const truth value = [=] { return mpfr(s.value() * growth() + c.value() * (growth() - 1) / k.value()); };
    const truth by_k = [=] {
        const mpfr t = real(time);
        const mpfr rate = k.value();
        return mpfr(s.value() * t * growth() + c.value() * (t * growth() / rate - (growth() - 1) / (rate * rate)));
    };
    const truth by_c = [=] { return mpfr((growth() - 1) / k.value()); };
    return {fmt::format("y' = k*y + c; y(0) = {}; k = {}; c = {}", s.text, k.text, c.text),
            {"k", "y(0)", "c"},
            time,
            {{"y", value, {by_k, growth, by_c}}}};
}

// y = v/(1 - a v t) from v = 1 + p^2, up to 9 tenths of its end.
differentiated_problem differentiated_pole(choices& next) {
    const constant a = any_constant(next);
    const constant p = any_constant(next);
    const auto start = [=] { return mpfr(1 + p.value() * p.value()); };
    const rational time(next.between(-90, 90), 100 * (2 + static_cast<long>(a.rough() * rough(start))));
    const auto factor = [=] { return mpfr(1 / (1 - a.value() * start() * real(time))); };
    const auto squared = [=] { return mpfr(factor() * factor()); };
    return {fmt::format("y' = a*y^2; y(0) = 1 + p^2; a = {}; p = {}", a.text, p.text),
            {"p", "y(0)", "a"},
            time,
            {{"y",
              [=] { return mpfr(start() * factor()); },
              {[=] { return mpfr(2 * p.value() * squared()); }, squared,
               [=] { return mpfr(start() * start() * real(time) * squared()); }}}}};
}

// y = p cos w t + q sin(w t)/w, typed with its velocity.
differentiated_problem differentiated_oscillator(choices& next) {
    const constant w = any_constant(next);
    const constant p = any_constant(next);
    const constant q = any_constant(next);
    const rational time = any_time(next);
    const auto t = [=] { return real(time); };
    const auto cosine = [=] { return mpfr(cos(mpfr(w.value() * t()))); };
    const auto sine = [=] { return mpfr(sin(mpfr(w.value() * t()))); };
    const differentiated_unknown place{
        "y",
        [=] { return mpfr(p.value() * cosine() + q.value() * sine() / w.value()); },
        {cosine, [=] { return mpfr(sine() / w.value()); },
         [=] {
             const mpfr f = w.value();
             return mpfr(-p.value() * t() * sine() + q.value() * (t() * cosine() / f - sine() / (f * f)));
         }}};
    const differentiated_unknown velocity{
        "y'",
        [=] { return mpfr(-p.value() * w.value() * sine() + q.value() * cosine()); },
        {[=] { return mpfr(-w.value() * sine()); }, cosine,
         [=] { return mpfr(-p.value() * (sine() + w.value() * t() * cosine()) - q.value() * t() * sine()); }}};
    return {fmt::format("y'' = -w^2*y; y(0) = {}; y'(0) = {}; w = {}", p.text, q.text, w.text),
            {"y(0)", "y'(0)", "w"},
            time,
            {place, velocity}};
}

// Two solutions beside each other, of any size: each derivative of one with respect to a number of the other is 0.
differentiated_problem differentiated_pair(choices& next) {
    const constant a = constant_of(next.between(-900, 900));
    const constant b = any_constant(next);
    const constant s = any_constant(next);
    const rational time = any_time(next);
    const truth zero = [] { return mpfr(0); };
    const auto fast = [=] { return mpfr(exp(mpfr(a.value() * real(time)))); };
    const auto slow = [=] { return mpfr(exp(mpfr(b.value() * real(time)))); };
    return {fmt::format("x' = a*x; y' = b*y; x(0) = {}; y(0) = b; a = {}; b = {}", s.text, a.text, b.text),
            {"a", "x(0)", "b", "y(0)"},
            time,
            {{"x",
              [=] { return mpfr(s.value() * fast()); },
              {[=] { return mpfr(s.value() * real(time) * fast()); }, fast, zero, zero}},
             {"y",
              [=] { return mpfr(b.value() * slow()); },
              {zero, zero, [=] { return mpfr((1 + b.value() * real(time)) * slow()); }, slow}}}};
}

// The parameter p moves the initial point: y = s e^(c (t - p)).
differentiated_problem differentiated_point(choices& next) {
    const constant c = any_constant(next);
    const constant s = any_constant(next);
    const constant p = any_constant(next);
    const rational time = any_time(next);
    const truth value = [=] { return mpfr(s.value() * exp(mpfr(c.value() * (real(time) - p.value())))); };
    const truth by_c = [=] { return mpfr((real(time) - p.value()) * value()); };
    const truth by_p = [=] { return mpfr(-c.value() * value()); };
    const std::string text = fmt::format("y' = c*y; y(p) = {}; c = {}; p = {}", s.text, c.text, p.text);
    if (next.one_in(2)) {
        return {text, {"c"}, time, {{"y", value, {by_c}}}};
    }
    return {text, {"c", "p"}, time, {{"y", value, {by_c, by_p}}}};
}

// From 0 with the velocity a up to c, then with b.
differentiated_problem differentiated_branch(choices& next) {
    const constant a = any_constant(next);
    const constant b = any_constant(next);
    const constant c = any_constant(next);
    const rational time = any_time(next);
    const auto reached = [=] { return real(time) > mpfr(c.value() / a.value()); };
    const auto later = [=](const truth& after, const truth& before) -> truth {
        return [=] { return reached() ? after() : before(); };
    };
    const truth zero = [] { return mpfr(0); };
    const truth one = [] { return mpfr(1); };
    const truth ratio = [=] { return mpfr(b.value() / a.value()); };
    const truth by_a = later([=] { return mpfr(ratio() * c.value() / a.value()); }, [=] { return real(time); });
    const truth by_b = later([=] { return mpfr(real(time) - c.value() / a.value()); }, zero);
    const truth by_c = later([=] { return mpfr(1 - ratio()); }, zero);
    const truth value = later([=] { return mpfr(c.value() + b.value() * (real(time) - c.value() / a.value())); },
                              [=] { return mpfr(a.value() * real(time)); });
    return {fmt::format("x' = if(x < c, a, b); x(0) = 0; a = {}; b = {}; c = {}", a.text, b.text, c.text),
            {"x(0)", "a", "b", "c"},
            time,
            {{"x", value, {later(ratio, one), by_a, by_b, by_c}}},
            true};
}

// Bounce n of a ball is at T = u (1 + 2 (k + ... + k^n)), u = sqrt(2 h/g), with the velocity V = g u k^(n+1) after it.
struct ball_at {
    mpfr gravity, height, kept;
    mpfr moment, speed;  // T and V; 0 before the first bounce
    mpfr moment_by_kept, speed_by_kept;
    mpfr since;  // t - T

    ball_at(const mpfr& g, const mpfr& h, const mpfr& k, const mpfr& t) : gravity(g), height(h), kept(k), since(t) {
        const mpfr fall = sqrt(mpfr(2 * h / g));
        mpfr next = fall;
        mpfr next_by_kept = 0;
        mpfr power = 1;
        for (long n = 1; next < t; ++n) {
            moment = next;
            moment_by_kept = next_by_kept;
            speed_by_kept = g * fall * n * power;
            power *= k;
            speed = g * fall * power;
            next += 2 * fall * power;
            next_by_kept += 2 * fall * n * power / k;
        }
        since -= moment;
    }

    bool has_bounced() const { return speed > 0; }
    mpfr place() const { return (has_bounced() ? mpfr(speed * since) : height) - gravity * since * since / 2; }
    // T and V are proportional to sqrt(h/g) and sqrt(g h).
    mpfr by_height() const {
        return has_bounced() ? mpfr((speed * since - (speed - gravity * since) * moment) / (2 * height)) : mpfr(1);
    }
    mpfr by_gravity() const {
        return has_bounced()
                   ? mpfr((speed * since + (speed - gravity * since) * moment) / (2 * gravity) - since * since / 2)
                   : mpfr(-since * since / 2);
    }
    mpfr by_kept() const { return speed_by_kept * since - (speed - gravity * since) * moment_by_kept; }
    mpfr velocity() const { return speed - gravity * since; }
    mpfr velocity_by_height() const {
        return has_bounced() ? mpfr((speed + gravity * moment) / (2 * height)) : mpfr(0);
    }
    mpfr velocity_by_gravity() const {
        return has_bounced() ? mpfr((speed - gravity * moment) / (2 * gravity) - since) : mpfr(-since);
    }
    mpfr velocity_by_kept() const { return speed_by_kept + gravity * moment_by_kept; }
};

differentiated_problem differentiated_ball(choices& next) {
    const constant g = any_constant(next);
    const constant h = any_constant(next);
    const constant k = next.one_in(2) ? near_one(next) : constant_of(rational(next.between(1, 9), 10));
    // In the flight after some bounces.
    const long bounces = next.between(0, 5);
    double start = 0;
    double flight = std::sqrt(2 * h.rough() / g.rough());
    for (long i = 0; i < bounces; ++i) {
        start += flight;
        flight *= (i == 0 ? 2 : 1) * k.rough();
    }
    const double about = start + flight * static_cast<double>(next.between(1, 9)) / 10;
    const rational time = decimal_fraction(static_cast<long>(about * 1000), 3);
    const auto of = [=](mpfr (ball_at::*part)() const) -> truth {
        return [=] { return (ball_at(g.value(), h.value(), k.value(), real(time)).*part)(); };
    };
    return {fmt::format("y'' = -g; y(0) = {}; y'(0) = 0; when y = 0 down: y' = -k*y'; g = {}; k = {}", h.text, g.text,
                        k.text),
            {"y(0)", "g", "k"},
            time,
            {{"y", of(&ball_at::place), {of(&ball_at::by_height), of(&ball_at::by_gravity), of(&ball_at::by_kept)}},
             {"y'",
              of(&ball_at::velocity),
              {of(&ball_at::velocity_by_height), of(&ball_at::velocity_by_gravity), of(&ball_at::velocity_by_kept)}}},
            true};
}

differentiated_problem any_differentiated(choices& next) {
    switch (next.below(7)) {
        case 0: return differentiated_linear(next);
        case 1: return differentiated_pole(next);
        case 2: return differentiated_oscillator(next);
        case 3: return differentiated_pair(next);
        case 4: return differentiated_point(next);
        case 5: return differentiated_branch(next);
        default: return differentiated_ball(next);
    }
}

}  // namespace

outcome ask_derivative(choices& next) {
    const differentiated_problem asked = any_differentiated(next);
    const long digits = next.between(1, 40);
    const std::string time = asked.time.str();
    return answered(fmt::format("libration reference --problem \"{}\" --time={} --derivatives \"{}\" --digits {}",
                                asked.text, time, fmt::join(asked.numbers, ", "), digits),
                    [&](outcome& result) {
                        const auto system = ode::parse(asked.text);
                        const std::vector<ode::number> times{time_number(time)};
                        const ode::march_watch watch = [](const ball&, long) { require_time_left(); };
                        const auto found =
                            asked.has_events
                                ? ode::proved_derivatives_of_hybrid(system, times, asked.numbers, digits, watch)
                                : ode::proved_derivatives(system, times, asked.numbers, digits, watch);
                        const auto& values = found.trajectory.states.front();
                        const auto& by = found.by.front();
                        for (std::size_t i = 0; i < values.size(); ++i) {
                            const auto& unknown = asked.unknowns[i];
                            add_number(result, values[i], digits, unknown.value, unknown.name);
                            for (std::size_t j = 0; j < asked.numbers.size(); ++j) {
                                add_number(result, by.at(i).at(j), digits, unknown.by[j],
                                           fmt::format("d{}/d{}", unknown.name, asked.numbers[j]));
                            }
                        }
                        if (found.trajectory.missing) {
                            result.add(verdict::refused, found.trajectory.missing->what());
                        }
                    });
}

}  // namespace libration::attack
