// Right-hand sides of nested steps of the time and of unknowns that are known functions of the time.
#include <fmt/core.h>

#include "attack/printed_values.hpp"
#include "attack/step_terms.hpp"

namespace libration::attack {

namespace {

constexpr long most_time = 5;

// An unknown with a known course, from time 0 on.
struct moving_unknown {
    std::string equations;
    step_term value;
};

rational velocity(choices& next) {
    const rational size(next.between(1, 4), next.between(1, 2));
    return next.one_in(2) ? size : rational(-size);
}

// With a constant velocity, with one that changes at a time, or with one that changes where the unknown passes a level.
moving_unknown any_unknown(const std::string& name, choices& next) {
    const rational start(next.between(-6, 6), 2);
    const std::string begins = fmt::format("{}(0) = {}", name, as_typed(start));
    const rational first = velocity(next);
    if (!next.one_in(3)) {
        const rational constant = next.one_in(8) ? rational(0) : first;
        return {fmt::format("{}' = {}; {}", name, as_typed(constant), begins), linear_term(name, {start, constant})};
    }
    const bool by_time = next.one_in(2);
    const rational time(next.between(1, 6), 2);
    const rational other = velocity(next);
    const rational second = by_time || other.sign() == first.sign() ? other : rational(-other);
    const rational level = start + first * time;
    // first is the velocity before: below the level if it is positive.
    const bool below = by_time || first.sign() > 0;
    return {fmt::format("{}' = if({} {} {}, {}, {}); {}", name, by_time ? "t" : name, below ? "<" : ">",
                        as_typed(by_time ? time : level), as_typed(first), as_typed(second), begins),
            bent_term(name, {start, first}, time, {level - second * time, second})};
}

// y' = slope with a start at `origin`, at later times in a unit.
struct asked_slope {
    step_term slope;
    std::string others = "";  // the equations of unknowns in it
    rational origin = 0;
    std::string unit = "";
    truth unit_value = [] { return mpfr(1); };
};

outcome ask(const asked_slope& asked, choices& next) {
    const rational start = next.one_in(2) ? rational(0) : rational(next.between(-4, 4), 3);
    printed_question question;
    question.problem =
        fmt::format("y' = {}; y({}) = {}{}", asked.slope.text, asked.origin.str(), as_typed(start), asked.others);
    question.digits = next.between(2, 30);
    question.unknowns = {{"y", {}}};
    question.slides = false;
    for (long k = next.between(1, 2); k > 0; --k) {
        const rational time = asked.origin + rational(next.between(1, 12 * most_time), 12);
        const rational grown = integral(asked.slope, asked.origin, time);
        question.times.push_back(time.str() + asked.unit);
        question.unknowns.front().values.emplace_back(
            [=, unit = asked.unit_value] { return mpfr(real(start) + real(grown) * unit()); });
    }
    return asked_program(question);
}

}  // namespace

outcome ask_time_steps(choices& next) {
    if (next.one_in(4)) {
        const step_term turns = linear_term("(t/pi)", {0, 1});
        const step_term slope = term_choices(next, {turns}, "t").any(next.between(1, 3));
        return ask({.slope = slope, .unit = "*pi", .unit_value = pi_value}, next);
    }
    const step_term slope = term_choices(next, {linear_term("t", {0, 1})}, "pi*t").any(next.between(1, 3));
    return ask({.slope = slope, .origin = next.one_in(2) ? rational(0) : rational(next.between(-4, 4), 2)}, next);
}

outcome ask_state_steps(choices& next) {
    std::vector<step_term> leaves{linear_term("t", {0, 1})};
    std::string others;
    for (const char* const name : {"x", "z"}) {
        const moving_unknown made = any_unknown(name, next);
        others += "; " + made.equations;
        leaves.push_back(made.value);
        if (next.one_in(2)) {
            break;
        }
    }
    term_choices terms(next, leaves);
    const long depth = next.between(1, 3);
    return ask({.slope = next.one_in(2) ? terms.any(depth) : terms.against_steps(depth), .others = others}, next);
}

}  // namespace libration::attack
