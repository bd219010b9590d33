// Times that differ by less than 1e-40 from those of events, and times after events that are not proved.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "attack/printed_values.hpp"
#include "attack/step_terms.hpp"

namespace libration::attack {

namespace {

// 1 + units 10^-61: as typed, and its value.
struct near_time {
    long units;

    std::string text() const {
        return units == 0 ? "1" : fmt::format("1{}{}e-61", units < 0 ? "-" : "+", std::abs(units));
    }
    rational value() const { return 1 + decimal_fraction(units, 61); }
};

printed_question asked_at(const std::vector<near_time>& times, const std::function<rational(const near_time&)>& value,
                          const std::string& name) {
    printed_question question;
    question.unknowns = {{name, {}}};
    for (const near_time& each : times) {
        question.times.push_back(each.text());
        question.unknowns[0].values.emplace_back([=, exact = value(each)] { return real(exact); });
    }
    question.digits = 10;
    question.slides = false;
    return question;
}

// y jumps at 1 + k 1e-61, or has another slope from there on.
outcome ask_close(choices& next) {
    const near_time event{next.one_in(4) ? 0 : next.between(-20, 20)};
    std::vector<near_time> times;
    for (long k = next.between(1, 3); k > 0; --k) {
        const long units = event.units + next.between(1, 20) * (next.one_in(2) ? 1 : -1);
        const bool is_new = std::ranges::find(times, units, &near_time::units) == times.end();
        if (is_new) {
            times.push_back({units});
        }
    }
    const auto jumped = [=](const near_time& at, const rational& before) {
        return at.units > event.units ? rational(before + 1) : before;
    };
    printed_question question;
    switch (next.below(4)) {
        case 0:
            question = asked_at(
                times, [=](const near_time& at) { return jumped(at, at.value()); }, "x");
            question.problem = fmt::format("x' = 1; x(0) = 0; when t = {}: x = x+1", event.text());
            break;
        case 1:
            question = asked_at(
                times, [=](const near_time& at) { return jumped(at, 0); }, "y");
            question.problem = fmt::format("x' = 1; y' = 0; x(0) = 0; y(0) = 0; when x = {}: y = y+1", event.text());
            break;
        case 2:
            question = asked_at(
                times, [=](const near_time& at) { return jumped(at, 0); }, "y");
            question.problem =
                fmt::format("x' = -x; y' = 0; x(0) = 1; y(0) = 0; when x = exp(-({})): y = y+1", event.text());
            break;
        default:
            question = asked_at(
                times, [=](const near_time& at) { return std::max(rational(0), rational(at.value() - event.value())); },
                "y");
            question.problem = fmt::format("y' = if(t > {}, 1, 0); y(0) = 0", event.text());
    }
    return asked_program(question);
}

// Two functions of the time in conditions: (t - touched)^2 touches 0, where the path may end, and (t - crossed)^3 crosses
// it, where y changes. Their order, and that of the statements, is random.
outcome ask_undecided(choices& next) {
    const rational touched(next.between(2, 10), 2);
    rational crossed(next.between(2, 10), 2);
    if (crossed == touched) {
        crossed += 1;
    }
    const std::string touch = "when a = 0: w = 1";
    const std::string cross = "when z = 0: y = y+1";
    const bool first = next.one_in(2);
    printed_question question;
    question.problem = fmt::format(
        "a' = 2*(t - {0}); a(0) = {0}^2; z' = 3*(t - {1})^2; z(0) = -{1}^3; y' = 0; y(0) = 0; w' = 0; w(0) = 0; {2}; "
        "{3}",
        as_typed(touched), as_typed(crossed), first ? touch : cross, first ? cross : touch);
    question.unknowns = {{"y", {}}};
    question.slides = false;
    rational time = 0;
    for (long k = next.between(1, 3); k > 0; --k) {
        time += rational(2 * next.between(1, 4) - 1, 3);
        question.times.push_back(time.str());
        question.unknowns[0].values.emplace_back([=] { return mpfr(time > crossed ? 1 : 0); });
    }
    if (next.one_in(2)) {
        std::ranges::reverse(question.times);
        std::ranges::reverse(question.unknowns[0].values);
    }
    return asked_program(question);
}

}  // namespace

outcome ask_near_times(choices& next) { return next.one_in(10) ? ask_undecided(next) : ask_close(next); }

}  // namespace libration::attack
