// Counters that resets alone change, in conditions of equations and events.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "attack/printed_values.hpp"
#include "attack/step_terms.hpp"

namespace libration::attack {

// n begins with `first`, grows by one whenever a period ends, and from `most` on begins with 0 again; z has one slope while
// a condition on n holds, and else another one.
outcome ask_mode(choices& next) {
    const rational period(next.between(1, 9), next.between(1, 4));
    const rational rate(next.between(1, 9), next.between(1, 3));
    const rational first_of_saw = next.one_in(2) ? rational(0) : rational(period / next.between(2, 4));
    const long first = next.between(-2, 2);
    const long most = next.between(1, 4);
    const bool begins_again = next.one_in(2) && first < most;
    const long level = next.between(-1, 3);
    const std::string relation = any_relation(next);
    const rational inside(next.between(-5, 5), 2);
    const rational outside(next.between(-5, 5), 3);
    // Of the first end of a period.
    const bool by_time = next.one_in(3);
    const rational until = by_time ? period : rational(period - first_of_saw);
    const std::string ends = by_time ? fmt::format("when mod(t, {}) == 0: m = m + 1", period.str())
                                     : fmt::format("when y > {}: y = 0; m = m + 1", rational(rate * period).str());
    printed_question question;
    question.problem =
        fmt::format("y' = {}; y(0) = {}; m' = 0; m(0) = {}; z' = if(m {} {}, {}, {}); z(0) = 0; {}{}", rate.str(),
                    rational(rate * first_of_saw).str(), first, relation, level, inside.str(), outside.str(), ends,
                    begins_again ? fmt::format("; when m >= {}: m = 0", most) : "");
    question.digits = next.between(2, 30);
    question.slides = false;
    question.unknowns = {{"m", {}}, {"z", {}}};
    std::array<rational, 2> times{rational(next.between(1, 60), 7), rational(next.between(1, 60), 11)};
    std::ranges::sort(times);
    for (const rational& time : times) {
        long n = first;
        rational z = 0;
        rational gone = 0;
        for (rational end = until;; end += period) {
            const rational last = std::min(end, time);
            z += (last - gone) * (holds(relation, n < level ? -1 : n > level ? 1 : 0) ? inside : outside);
            gone = last;
            if (end > time) {
                break;
            }
            ++n;
            n = begins_again && n >= most ? 0 : n;
        }
        question.times.push_back(time.str());
        question.unknowns[0].values.emplace_back([n] { return mpfr(n); });
        question.unknowns[1].values.emplace_back([z] { return real(z); });
    }
    return asked_program(question);
}

}  // namespace libration::attack
