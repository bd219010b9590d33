// Several stores with constant outflows, empty at different or equal times and refilled; what flows out of one is collected.
#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "attack/printed_values.hpp"
#include "attack/step_terms.hpp"

namespace libration::attack {

namespace {

// B' = inflow - rate while B > 0 or the inflow is larger, else 0; the inflow changes at `change`.
struct constant_store {
    rational start, rate, before, after, change;

    rational level(const rational& time) const {
        const rational first = std::min(time, change);
        const rational then = std::max(rational(0), rational(start + (before - rate) * first));
        return time <= change ? then : std::max(rational(0), rational(then + (after - rate) * (time - change)));
    }
};

constant_store any_store(choices& next) {
    const rational rate(next.between(1, 4), next.between(1, 2));
    return {rational(next.between(1, 9), next.between(1, 3)), rate, next.one_in(2) ? rational(0) : rational(rate / 2),
            rational(next.between(0, 6), 2), rational(next.between(1, 9), next.between(1, 5))};
}

std::string outflow_of(const constant_store& store, const std::string& name, choices& next) {
    const std::string rate = as_typed(store.rate);
    switch (next.below(3)) {
        case 0: return fmt::format("if({} > 0, {}, 0)", name, rate);
        case 1: return fmt::format("({})*heaviside({})", rate, name);
        default: return fmt::format("if({} <= 0, 0, {})", name, rate);
    }
}

}  // namespace

outcome ask_several_stores(choices& next) {
    const rational time(next.between(1, 90), 7);
    printed_question question;
    question.digits = next.between(2, 25);
    question.times = {time.str()};
    const long count = next.between(2, 4);
    for (long i = 0; i < count; ++i) {
        const constant_store store = any_store(next);
        const std::string name = fmt::format("B{}", i);
        const std::string out = outflow_of(store, name, next);
        const std::string in =
            next.one_in(2)
                ? fmt::format("if(t < {}, {}, {})", store.change.str(), store.before.str(), store.after.str())
                : fmt::format("{} + ({})*heaviside(t - {})", store.before.str(), as_typed(store.after - store.before),
                              as_typed(store.change));
        question.problem +=
            fmt::format("{}{}' = {} - {}; {}(0) = {}", i == 0 ? "" : "; ", name, in, out, name, as_typed(store.start));
        question.unknowns.push_back({name, {[=] { return real(store.level(time)); }}});
        if (i == 0 && store.before == 0 && time <= store.change) {
            question.problem += fmt::format("; Q' = {}; Q(0) = 0", out);
            question.unknowns.push_back({"Q", {[=] { return real(rational(store.start - store.level(time))); }}});
        }
    }
    return asked_program(question);
}

}  // namespace libration::attack
