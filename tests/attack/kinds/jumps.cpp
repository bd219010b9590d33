// Solutions with jumps, and of piecewise right-hand sides: a bouncing ball, and two constant velocities.
#include <fmt/core.h>

#include <algorithm>

#include "attack/question.hpp"
#include "libration/query/hybrid_trajectory.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

// The part of the velocity that a bounce leaves: near one, or a tenth to nine.
constant restitution(choices& next) {
    return next.one_in(2) ? near_one(next) : constant_of(rational(next.between(1, 9), 10));
}

struct bouncing_ball {
    constant gravity, height, kept;

    std::string text() const {
        return fmt::format("y'' = -{}; y(0) = {}; y'(0) = 0; when y = 0 down: y' = -{}*y'", gravity.text, height.text,
                           kept.text);
    }
    // Of the first fall.
    mpfr duration() const { return sqrt(mpfr(2 * height.value() / gravity.value())); }
    // Of bounce n, from 0 on.
    mpfr time(long n) const {
        mpfr sum = 1;
        mpfr power = 1;
        for (long i = 0; i < n; ++i) {
            power *= kept.value();
            sum += 2 * power;
        }
        return duration() * sum;
    }
    mpfr velocity(long n) const { return -gravity.value() * duration() * pow(kept.value(), mpfr(n)); }
};

}  // namespace

outcome ask_jump(choices& next) {
    const bouncing_ball ball{any_constant(next), any_constant(next), restitution(next)};
    const long count = next.between(1, 6);
    const long digits = next.between(1, 40);
    const std::string text = ball.text();
    const std::string command = fmt::format(
        "libration reference --problem \"{}\" --until \"y = 0\" --count {} --digits {}", text, count, digits);
    return answered(command, [&](outcome& result) {
        const auto given = ode::parse(text);
        const auto report = ode::searched_hybrid_events(
            ode::hybrid_system(given), {.g = ode::parse_condition(given, "y = 0"), .count = count}, digits, {},
            [](const auto&, long, const auto&) { require_time_left(); });
        for (std::size_t i = 0; i < report.events.size(); ++i) {
            const auto n = static_cast<long>(i);
            const std::string bounce = fmt::format("bounce {}, ", n + 1);
            add_number(
                result, report.events[i].time, digits, [&ball, n] { return ball.time(n); }, bounce + "time");
            add_number(
                result, report.events[i].values[1], digits, [&ball, n] { return ball.velocity(n); }, bounce + "y'");
        }
        if (report.missing) {
            result.add(verdict::refused, report.missing->what());
        }
    });
}

outcome ask_branch(choices& next) {
    // From x = 0 with the velocity a up to x = c, then with b.
    const constant a = any_constant(next);
    const constant b = any_constant(next);
    const constant c = any_constant(next);
    const rational time = decimal_fraction(next.between(1, 4000), 3);
    const long digits = next.between(1, 40);
    const std::string text = fmt::format("x' = if(x < {}, {}, {}); x(0) = 0", c.text, a.text, b.text);
    const std::string typed = time.str();
    return answered(fmt::format("libration reference --problem \"{}\" --time {} --digits {}", text, typed, digits),
                    [&](outcome& result) {
                        const auto found =
                            ode::proved_part_of_hybrid(ode::hybrid_system(ode::parse(text)), {time_number(typed)},
                                                       digits, [](const ball&, long) { require_time_left(); });
                        const truth exact = [&] {
                            const mpfr until = c.value() / a.value();
                            const mpfr t = real(time);
                            return t <= until ? mpfr(a.value() * t) : mpfr(c.value() + b.value() * (t - until));
                        };
                        add_first_value(result, found, digits, exact, "x");
                    });
}

}  // namespace libration::attack
