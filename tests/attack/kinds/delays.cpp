// Solutions with a constant delay, which are polynomials between breaking points.
#include <fmt/core.h>

#include <vector>

#include "attack/question.hpp"
#include "libration/ode/delay/proved/delay_trajectory.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

// x' = a x(t - d), x = c for t <= 0: the sum over k of c a^k (t - (k - 1) d)^k/k!, for (k - 1) d < t.
struct delayed_growth {
    constant rate, delay, history;

    std::string text() const {
        return fmt::format("x' = {}*x(t - {}); x(t <= 0) = {}", rate.text, delay.text, history.text);
    }
    mpfr value(const rational& time) const {
        mpfr sum = 1;
        mpfr factor = 1;
        for (long k = 1;; ++k) {
            const mpfr s = real(time) - (k - 1) * delay.value();
            if (s <= 0) {
                return history.value() * sum;
            }
            factor *= rate.value() / k;
            sum += factor * pow(s, mpfr(k));
        }
    }
};

}  // namespace

outcome ask_delay(choices& next) {
    const delayed_growth growth{any_constant(next), constant_of(rational(next.between(3, 9), 5)), any_constant(next)};
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
                result, found, digits, [&] { return growth.value(time); }, "x");
        });
}

}  // namespace libration::attack
