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

// y' = slope, y(0) = start, at times in a unit.
printed_question question_of(const step_term& slope, const std::string& others, const std::string& unit,
                             const truth& unit_value, choices& next) {
    const rational start = next.one_in(2) ? rational(0) : rational(next.between(-4, 4), 3);
    printed_question question;
    question.problem = fmt::format("y' = {}; y(0) = {}{}", slope.text, as_typed(start), others);
    question.digits = next.between(2, 30);
    question.unknowns = {{"y", {}}};
    question.slides = false;
    for (long k = next.between(1, 2); k > 0; --k) {
        const rational time(next.between(1, 12 * most_time), 12);
        const rational grown = integral(slope, 0, time);
        question.times.push_back(time.str() + unit);
        question.unknowns.front().values.emplace_back([=] { return mpfr(real(start) + real(grown) * unit_value()); });
    }
    return question;
}

truth one() {
    return [] { return mpfr(1); };
}

}  // namespace

outcome ask_time_steps(choices& next) {
    if (next.one_in(4)) {
        const step_term time = linear_term("(t/pi)", {0, 1});
        return asked_program(
            question_of(term_choices(next, {time}, "t").any(next.between(1, 3)), "", "*pi", pi_value, next));
    }
    const step_term time = linear_term("t", {0, 1});
    return asked_program(question_of(term_choices(next, {time}, "pi*t").any(next.between(1, 3)), "", "", one(), next));
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
    return asked_program(question_of(term_choices(next, leaves).any(next.between(1, 3)), others, "", one(), next));
}

}  // namespace libration::attack
