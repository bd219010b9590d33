// Enclosures of all solutions of a set: they contain those from its ends.
#include <fmt/core.h>

#include <algorithm>

#include "attack/question.hpp"
#include "libration/ode/proved/sets/set_events.hpp"
#include "libration/ode/proved/sets/solution_sets.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

// x' = -a x or x' = -a x^3, whose solutions from x(0) > 0 depend on x(0) and on a > 0 monotonically.
mpfr decayed(bool cubic, const mpfr& start, const mpfr& rate, const mpfr& time) {
    return cubic ? mpfr(start / sqrt(mpfr(1 + 2 * rate * start * start * time)))
                 : mpfr(start * exp(mpfr(-rate * time)));
}

// Whether an end of an enclosure, exact, is on the right side of a value.
verdict judged_end(const ball& end, const truth& exact, int side) {
    const int sign = sign_of([&] {
        const precision_scope scope(std::max<unsigned>(mpfr::thread_default_precision(), 400));
        return mpfr(exact() - midpoint_of(end));
    });
    return sign * side <= 0 ? verdict::right : verdict::wrong;
}

// When x reaches a part of its start: later from larger ones, and at smaller rates.
mpfr time_of_decay(bool cubic, const mpfr& start, const mpfr& rate, const mpfr& end) {
    return cubic ? mpfr((1 / (end * end) - 1 / (start * start)) / (2 * rate)) : mpfr(log(mpfr(start / end)) / rate);
}

outcome ask_event_of_set(choices& next) {
    const bool cubic = next.one_in(2);
    const constant least = any_constant(next);
    const constant rate = any_constant(next);
    const rational width(next.one_in(2) ? 0 : next.between(1, 20), 100);
    const rational growth(next.between(0, 20), 100);
    const rational share(next.between(2, 9), 10);
    const std::string text = fmt::format("x' = -a*x{0}; x(0) = [{1}, {1} + {2}]; a = [{3}, {3} + {4}]",
                                         cubic ? "^3" : "", least.text, width.str(), rate.text, growth.str());
    const std::string condition = fmt::format("x = {}*{}", share.str(), least.text);
    return answered(
        fmt::format("libration reference --problem \"{}\" --until \"{}\"", text, condition), [&](outcome& result) {
            const auto found = ode::enclosed_events(ode::parse(text), {.condition = condition, .most_parts = 8},
                                                    [](const ball&, long) { require_time_left(); });
            const auto time = [&](const rational& wider, const rational& faster) {
                return time_of_decay(cubic, least.value() + real(wider), rate.value() + real(faster),
                                     real(share) * least.value());
            };
            for (const auto& event : found.events) {
                result.add(judged_end(
                               event.time.lower, [&] { return time(0, growth); }, -1),
                           "the lower bound of the time");
                result.add(judged_end(
                               event.time.upper, [&] { return time(width, 0); }, 1),
                           "the upper bound of the time");
            }
            if (found.missing) {
                result.add(verdict::refused, found.missing->what());
            }
        });
}

outcome ask_values_of_set(choices& next) {
    const bool cubic = next.one_in(2);
    const constant least = any_constant(next);
    const constant rate = any_constant(next);
    const rational width(next.one_in(2) ? 0 : next.between(1, 20), 100);
    const rational growth(next.between(0, 20), 100);
    const rational time = decimal_fraction(next.between(1, 2000), 3);
    const std::string text = fmt::format("x' = -a*x{0}; x(0) = [{1}, {1} + {2}]; a = [{3}, {3} + {4}]",
                                         cubic ? "^3" : "", least.text, width.str(), rate.text, growth.str());
    return answered(fmt::format("libration reference --problem \"{}\" --time {}", text, time.str()),
                    [&](outcome& result) {
                        const auto found = ode::enclosed_solutions(
                            ode::parse(text), {.spans = {ode::at_time(time_number(time.str()))}, .most_parts = 8},
                            [](const ball&, long) { require_time_left(); });
                        if (!found.values.front().empty()) {
                            const auto& within = found.values.front().front();
                            const truth below = [&] {
                                return decayed(cubic, least.value(), rate.value() + real(growth), real(time));
                            };
                            const truth above = [&] {
                                return decayed(cubic, least.value() + real(width), rate.value(), real(time));
                            };
                            result.add(judged_end(within.lower, below, -1), "the lower bound of x");
                            result.add(judged_end(within.upper, above, 1), "the upper bound of x");
                        }
                        if (found.missing) {
                            result.add(verdict::refused, found.missing->what());
                        }
                    });
}

}  // namespace

outcome ask_set(choices& next) { return next.one_in(2) ? ask_event_of_set(next) : ask_values_of_set(next); }

}  // namespace libration::attack
