// Enclosures of all solutions of a set contain those from its ends, and the numbers of events those of the ends.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "attack/question.hpp"
#include "libration/query/sets/event_counts.hpp"
#include "libration/query/sets/set_events.hpp"
#include "libration/query/sets/solution_sets.hpp"
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

// Equations whose solutions from x(0) > 0 are monotone in the time, in x(0) and in a > 0.
struct monotone_family {
    std::string slope;
    bool grows;  ///< with the time and with a; else it decays with both
    std::function<mpfr(const mpfr& start, const mpfr& rate, const mpfr& time)> value;
    /// When the solution ends; empty if it does not.
    std::function<mpfr(const mpfr& start, const mpfr& rate)> end = {};
    std::string others = {};  ///< equations that the slope needs
};

// x' = -a, which ends where x leaves the domain of a function of x whose coefficient remains 0; another unknown has a
// function of the same x with a larger domain.
monotone_family any_end_of_domain(choices& next) {
    const std::vector<std::string> functions = {"log(x)", "sqrt(x)", "1/x", "x^(-3/2)", "sin(x)/x"};
    const std::vector<std::string> others = {"sin(x)", "exp(x)", "x^2", "cos(x) - x", "1/(1 + x^2)"};
    return {"-a + w*" + functions[next.below(functions.size())], false,
            [](const auto& c, const auto& a, const auto& t) { return mpfr(c - a * t); },
            [](const auto& c, const auto& a) { return mpfr(c / a); },
            "; w' = 0; w(0) = 0; v' = " + others[next.below(others.size())] + "; v(0) = 1"};
}

monotone_family any_family(choices& next) {
    switch (next.below(5)) {
        case 0:
            return {"-a*x", false, [](const auto& c, const auto& a, const auto& t) { return decayed(false, c, a, t); }};
        case 1:
            return {"-a*x^3", false,
                    [](const auto& c, const auto& a, const auto& t) { return decayed(true, c, a, t); }};
        case 2:
            return {"a*x^2", true,
                    [](const auto& c, const auto& a, const auto& t) { return mpfr(c / (1 - a * c * t)); },
                    [](const auto& c, const auto& a) { return mpfr(1 / (a * c)); }};
        case 3: return any_end_of_domain(next);
        default:
            return {"a*(1 + x^2)", true,
                    [](const auto& c, const auto& a, const auto& t) { return mpfr(tan(mpfr(a * t + atan(c)))); },
                    [](const auto& c, const auto& a) { return mpfr((pi_value() / 2 - atan(c)) / a); }};
    }
}

// [c, c + width], or c itself, in half of the cases without a width.
std::string interval(const constant& c, const rational& width, choices& next) {
    return width == 0 && next.one_in(2) ? c.text : fmt::format("[{0}, {0} + {1}]", c.text, width.str());
}

// Equations that do not change x: with sets, with single solutions, and with a set that has no effect.
std::string any_others(choices& next) {
    const std::vector<std::string> others = {"; y' = y; y(0) = 0", "; y' = b*y; y(0) = 1; b = [1, 2]",
                                             "; y' = -y; y(0) = b - b; b = [1, 2]",
                                             "; y' = x*y; y(0) = 0*b; b = [-1, 1]"};
    return next.one_in(3) ? "" : others[next.below(others.size())];
}

// An unknown z that remains 0, and its part of x', defined for x > 0.
struct constant_zero {
    std::string term, equation;
};

constant_zero any_constant_zero(choices& next) {
    if (!next.one_in(3)) {
        return {};
    }
    const std::vector<std::string> terms = {"z", "z*sin(x)", "z/x", "z*log(x)", "sin(z)*sqrt(x)"};
    const std::vector<std::string> slopes = {"0", "z*x", "sin(z)", "z/x", "x*(exp(z) - 1)"};
    const std::vector<std::string> starts = {"0", "[0, 0]"};
    return {" + " + terms[next.below(terms.size())],
            "; z' = " + slopes[next.below(slopes.size())] + "; z(0) = " + starts[next.below(starts.size())]};
}

outcome ask_values_of_set(choices& next) {
    const monotone_family family = any_family(next);
    const constant least = any_constant(next);
    const constant rate = any_constant(next);
    const rational width(next.one_in(2) ? 0 : next.between(1, 20), 100);
    const rational growth(next.one_in(2) ? 0 : next.between(1, 20), 100);
    const truth end = [&] {
        return family.end(least.value() + real(family.grows ? width : rational(0)), rate.value() + real(growth));
    };
    // Also times at which some of the solutions or all of them have ended.
    constexpr double beyond_the_end = 1.3;
    const double longest = family.end ? beyond_the_end * rough(end) : 2;
    const rational to = decimal_fraction(next.between(1, std::max(1L, std::lround(longest * 1000))), 3);
    const rational from = next.one_in(3) ? rational(to * next.between(0, 4) / 5) : to;
    const constant_zero zero = any_constant_zero(next);
    const std::string others = family.others + any_others(next) + zero.equation;
    // At least one set, hence a = [c, c] beside a single initial value if nothing else is one.
    const std::string start = interval(least, width, next);
    const bool is_set = start.front() == '[' || others.find('[') != std::string::npos;
    const std::string text = fmt::format(
        "x' = {}{}; x(0) = {}; a = {}{}", family.slope, zero.term, start,
        is_set ? interval(rate, growth, next) : fmt::format("[{0}, {0} + {1}]", rate.text, growth.str()), others);
    const std::string when = from == to ? "--times " + to.str() : fmt::format("--over {}:{}", from.str(), to.str());
    return answered(fmt::format("libration reference --problem \"{}\" {}", text, when), [&](outcome& result) {
        const auto found = ode::enclosed_solutions(
            ode::parse(text), {.spans = {{time_number(from.str()), time_number(to.str())}}, .most_parts = 8},
            [](const ball&, long) { require_time_left(); });
        if (!found.values.front().empty()) {
            const auto& within = found.values.front().front();
            const bool ended = family.end && sign_of([&] { return mpfr(real(to) - end()); }) >= 0;
            const auto extreme = [&](bool greatest) {
                const bool late = greatest == family.grows;
                return [&, greatest, late] {
                    return family.value(least.value() + real(greatest ? width : rational(0)),
                                        rate.value() + real(late ? growth : rational(0)), real(late ? to : from));
                };
            };
            const auto add = [&](const ball& bound, bool upper, const std::string& name) {
                result.add(ended ? verdict::wrong : judged_end(bound, extreme(upper), upper ? 1 : -1), name);
            };
            add(within.lower, false, "the lower bound of x");
            add(within.upper, true, "the upper bound of x");
        }
        if (found.missing) {
            result.add(verdict::refused, found.missing->what());
        }
    });
}

// How often a sin t changes from one side of a level to the other before a time.
long crossings(const truth& a, const truth& level, const rational& before) {
    long count = 0;
    for (bool later = sign_of([&] { return mpfr(a() - level()); }) > 0; later; ++count) {
        const auto time = [&] {
            const mpfr first = asin(mpfr(level() / a()));
            return mpfr((count % 2 == 0 ? first : mpfr(pi_value() - first)) + 2 * pi_value() * (count / 2));
        };
        if (sign_of([&] { return mpfr(real(before) - time()); }) <= 0) {
            break;
        }
    }
    return count;
}

outcome ask_counts_of_set(choices& next) {
    const constant least = any_constant(next);
    const constant level = any_constant(next);
    const rational width(next.one_in(3) ? 0 : next.between(1, 50), 100);
    const rational before(next.between(1, 1200), 100);
    const std::string text = fmt::format("x'' = -x; x(0) = 0; x'(0) = [{0}, {0} + {1}]", least.text, width.str());
    const std::string condition = "x = " + level.text;
    return answered(
        fmt::format("libration reference --problem \"{}\" --until \"{}\" --before {} --how-many", text, condition,
                    before.str()),
        [&](outcome& result) {
            const auto found = ode::event_counts(
                ode::parse(text), {.condition = condition, .before = time_number(before.str()), .most_parts = 8},
                [](const ball&, long) { require_time_left(); });
            if (found.missing) {
                result.add(verdict::refused, found.missing->what());
                return;
            }
            for (const rational& more : {rational(0), rational(width / 2), width}) {
                const long count = crossings([&] { return mpfr(least.value() + real(more)); }, level.value, before);
                const bool listed = std::ranges::find(found.counts, count) != found.counts.end();
                result.add(listed ? verdict::right : verdict::wrong,
                           fmt::format("{} events for the least value + {}", count, more.str()));
            }
        });
}

}  // namespace

outcome ask_set(choices& next) {
    switch (next.below(5)) {
        case 0: return ask_counts_of_set(next);
        case 1:
        case 2: return ask_event_of_set(next);
        default: return ask_values_of_set(next);
    }
}

}  // namespace libration::attack
