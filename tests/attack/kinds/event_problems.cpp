#include "attack/kinds/event_problems.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace libration::attack {

namespace {

// The events after the initial time, in their order.
std::vector<known_event> after_start(std::vector<known_event> events) {
    std::erase_if(events, [](const known_event& each) { return sign_of(each.since) <= 0; });
    std::ranges::stable_sort(events, [](const known_event& a, const known_event& b) {
        return sign_of([&] { return mpfr(a.since() - b.since()); }) < 0;
    });
    return events;
}

// Levels: anywhere, near the initial value on either side, the initial value itself typed alike or differently.
constant level_near(const constant& start, choices& next) {
    switch (next.below(6)) {
        case 0: return start;
        case 1: return {"(" + start.text + "/3+2*" + start.text + "/3)", start.value};
        case 2: {
            const long k = next.between(10, 400);
            return {fmt::format("({}-1e-{})", start.text, k),
                    [=] { return mpfr(start.value() - pow(mpfr(10), mpfr(-k))); }};
        }
        case 3: {
            const long k = next.between(10, 60);
            return {fmt::format("({}+1e-{})", start.text, k),
                    [=] { return mpfr(start.value() + pow(mpfr(10), mpfr(-k))); }};
        }
        default: return any_constant(next);
    }
}

// x'' = -x from (p, q): R sin(s + phi).
asked_events oscillator(choices& next) {
    const constant p = any_constant(next);
    const constant q = any_constant(next);
    const rational origin = next.one_in(2) ? rational(0) : rational(next.between(-3, 3));
    const constant level = level_near(p, next);
    const truth size = [=] { return mpfr(hypot(p.value(), q.value())); };
    asked_events made;
    made.problem.origin = origin;
    made.problem.text = fmt::format("x'' = -x; x({0}) = {1}; x'({0}) = {2}", origin.str(), p.text, q.text);
    made.problem.columns = {"x", "x'"};
    made.problem.values = {[=](const mpfr& s) { return mpfr(p.value() * cos(s) + q.value() * sin(s)); },
                           [=](const mpfr& s) { return mpfr(q.value() * cos(s) - p.value() * sin(s)); }};
    made.condition = "x = " + level.text;
    const int inside = sign_of([=] { return mpfr(size() - level.value()); });
    made.all = inside < 0;
    for (long k = -1; inside > 0 && k < most_events / 2; ++k) {
        const auto at = [=](bool up) {
            return [=] {
                const mpfr turn = asin(mpfr(level.value() / size()));
                const mpfr here = up ? turn : mpfr(pi_value() - turn);
                return mpfr(here - atan2(p.value(), q.value()) + 2 * k * pi_value());
            };
        };
        made.events.push_back({at(true), 1});
        made.events.push_back({at(false), -1});
    }
    made.events = after_start(std::move(made.events));
    return made;
}

// y' = p'(t), y = k (t - r1) .. (t - rn): zeros at whole times, some of them double.
asked_events polynomial(choices& next) {
    const long degree = next.between(1, 4);
    std::vector<long> roots;
    for (long i = 0; i < degree; ++i) {
        roots.push_back(next.between(-2, 5));
    }
    std::ranges::sort(roots);
    std::string slope;
    std::string start = "1";
    for (long i = 0; i < degree; ++i) {
        std::string term = "1";
        for (long j = 0; j < degree; ++j) {
            term += j == i ? "" : fmt::format("*(t-({}))", roots[static_cast<std::size_t>(j)]);
        }
        slope += (i == 0 ? "" : "+") + term;
        start += fmt::format("*({})", -roots[static_cast<std::size_t>(i)]);
    }
    asked_events made;
    made.problem.text = fmt::format("y' = {}; y(0) = {}", slope, start);
    made.problem.columns = {"y"};
    made.problem.values = {[](const mpfr&) { return mpfr(0); }};
    made.condition = "y = 0";
    made.all = true;
    for (std::size_t i = 0; i < roots.size();) {
        const long root = roots[i];
        const auto times = std::ranges::count(roots, root);
        const auto behind = static_cast<long>(roots.size() - i) - times;
        made.events.push_back({[=] { return mpfr(root); }, times % 2 == 0 ? 0 : behind % 2 == 0 ? 1 : -1});
        i += static_cast<std::size_t>(times);
    }
    made.events = after_start(std::move(made.events));
    return made;
}

// y'' = -g; y(0) = h; y'(0) = v: one landing.
asked_events fall(choices& next) {
    const constant g = any_constant(next);
    const constant h = any_constant(next);
    const rational v(next.between(-9, 9), next.between(1, 4));
    asked_events made;
    made.problem.text = fmt::format("y'' = -{}; y(0) = {}; y'(0) = {}", g.text, h.text, v.str());
    made.problem.columns = {"y", "y'"};
    made.condition = "y = 0";
    made.all = true;
    const truth landing = [=] {
        const mpfr speed = real(v);
        return mpfr((speed + sqrt(mpfr(speed * speed + 2 * g.value() * h.value()))) / g.value());
    };
    made.problem.values = {[](const mpfr&) { return mpfr(0); },
                           [=](const mpfr& s) { return mpfr(real(v) - g.value() * s); }};
    made.events = {{landing, -1}};
    return made;
}

// A level that a monotone function passes once, or never, in other coordinates.
asked_events passage(choices& next) {
    const constant a = any_constant(next);
    const constant u = any_constant(next);
    const component moved = next.one_in(2) ? growth(a, u) : next.one_in(2) ? pole(a, u) : tangent(a, u);
    const constant level = level_near(u, next);
    asked_events made;
    if (next.one_in(2)) {
        made.problem = alone(moved);
        made.condition = "y = " + level.text;
    } else {
        // y = u + x^2: u does not influence x, but x influences y.
        made.problem = bent(growth(constant_of(-1), constant_of(1)), moved, 1);
        made.condition = "y-x^2 = " + level.text;
    }
    made.all = true;
    const auto time = moved.passes(level);
    if (time && rough(*time) < moved.forward) {
        made.events = {{*time, 1}};
    }
    return made;
}

}  // namespace

asked_events any_events(choices& next) {
    switch (next.below(8)) {
        case 0:
        case 1: return polynomial(next);
        case 2: return fall(next);
        case 3:
        case 4: return passage(next);
        default: return oscillator(next);
    }
}

}  // namespace libration::attack
