// Solutions with a constant delay, which are polynomials between breaking points.
#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "attack/question.hpp"
#include "libration/query/delay_events.hpp"
#include "libration/query/delay_trajectory.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

// x' = a x(t - d), x = c for t <= 0: the sum over k of c a^k (t - (k - 1) d)^k/k!, for (k - 1) d < t.
struct delayed_growth {
    constant rate, delay, history;

    std::string text() const {
        return fmt::format("x' = {}*x(t - {}); x(t <= 0) = {}", rate.text, delay.text, history.text);
    }
    mpfr value(const mpfr& time) const {
        mpfr sum = 1;
        mpfr factor = 1;
        for (long k = 1;; ++k) {
            const mpfr s = time - (k - 1) * delay.value();
            if (s <= 0) {
                return history.value() * sum;
            }
            factor *= rate.value() / k;
            sum += factor * pow(s, mpfr(k));
        }
    }
};

// When the solution, which increases, has a value that it reaches before a time: by halving the interval, to the
// precision.
mpfr time_of_value(const delayed_growth& growth, const mpfr& value, const mpfr& before) {
    mpfr first = 0;
    mpfr last = before;
    for (unsigned digit = 0; digit < 4 * mpfr::thread_default_precision(); ++digit) {
        const mpfr middle = (first + last) / 2;
        (growth.value(middle) < value ? first : last) = middle;
    }
    return first;
}

outcome ask_event_of_delay(const delayed_growth& growth, choices& next) {
    constexpr long before = 8;
    const rational factor(next.between(11, 60), 10);
    const long digits = next.between(1, 30);
    const std::string condition = fmt::format("x = {}*{}", factor.str(), growth.history.text);
    return answered(
        fmt::format("libration reference --problem \"{}\" --until \"{}\" --before {} --digits {}", growth.text(),
                    condition, before, digits),
        [&](outcome& result) {
            const auto given = ode::parse(growth.text());
            const auto report = ode::searched_delay_events(
                ode::delay_system(given), {.g = ode::parse_condition(given, condition), .before = ode::number(before)},
                digits, [](const auto&, long, const auto&) { require_time_left(); });
            for (const auto& event : report.events) {
                add_number(
                    result, event.time, digits,
                    [&] { return time_of_value(growth, real(factor) * growth.history.value(), before); }, "time");
            }
            if (report.missing) {
                result.add(verdict::refused, report.missing->what());
            }
        });
}

// x' = b x'(t - d) + c t, x = s t for t <= 0: the slope is b^(n + 1) s and the sum over k = 0 .. n of c b^k (t - k d)
// between n d and (n + 1) d.
outcome ask_neutral(choices& next) {
    const constant b = any_constant(next);
    const constant c = any_constant(next);
    const constant s = any_constant(next);
    const rational delay(next.between(3, 9), 5);
    const rational time = decimal_fraction(next.between(1, 6000), 3);
    const long digits = next.between(1, 40);
    const std::string text =
        fmt::format("x' = {}*x'(t - {}) + {}*t; x(t <= 0) = {}*t", b.text, constant_of(delay).text, c.text, s.text);
    const std::string typed = time.str();
    const truth exact = [&] {
        mpfr sum = 0;
        mpfr power = 1;
        for (long k = 0; delay * k < time; ++k) {
            const mpfr rest = real(rational(time - delay * k));
            sum += c.value() * power * rest * rest / 2;
            power *= b.value();
            sum += power * s.value() * real(std::min(delay, rational(time - delay * k)));
        }
        return sum;
    };
    return answered(fmt::format("libration reference --problem \"{}\" --time {} --digits {}", text, typed, digits),
                    [&](outcome& result) {
                        const ode::number at = time_number(typed);
                        const auto found =
                            ode::proved_part_of_delay(ode::delay_system(ode::parse(text), at), {at}, digits,
                                                      [](const ball&, long) { require_time_left(); });
                        add_first_value(result, found, digits, exact, "x");
                    });
}

}  // namespace

outcome ask_delay(choices& next) {
    if (next.one_in(3)) {
        return ask_neutral(next);
    }
    const delayed_growth growth{any_constant(next), constant_of(rational(next.between(3, 9), 5)), any_constant(next)};
    if (next.one_in(2)) {
        return ask_event_of_delay(growth, next);
    }
    const rational time = decimal_fraction(next.between(1, 6000), 3);
    const long digits = next.between(1, 40);
    const std::string typed = time.str();
    return answered(
        fmt::format("libration reference --problem \"{}\" --time {} --digits {}", growth.text(), typed, digits),
        [&](outcome& result) {
            const auto found =
                ode::proved_part_of_delay(ode::delay_system(ode::parse(growth.text())), {time_number(typed)}, digits,
                                          [](const ball&, long) { require_time_left(); });
            add_first_value(
                result, found, digits, [&] { return growth.value(real(time)); }, "x");
        });
}

}  // namespace libration::attack
