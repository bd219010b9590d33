// Solutions across, from and up to a time at which the right-hand side has a root.
#include <fmt/core.h>

#include "attack/question.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

// y' = rate root y, y = start at tau + begins, with the root cbrt(t - tau), (t - tau)^(p/q) or (tau - t)^(p/q): y = start
// exp(rate (I(t) - I(tau + begins))), I = +-|t - tau|^(r + 1)/(r + 1) for the exponent r.
struct growth_with_root {
    constant tau, rate, start;
    rational exponent;
    int side;  // 1 or -1 where the root is real; 0 for both
    rational begins;

    std::string root() const {
        const std::string away = side < 0 ? fmt::format("({} - t)", tau.text) : fmt::format("(t - {})", tau.text);
        return side == 0 ? "cbrt" + away : fmt::format("{}^({})", away, exponent.str());
    }
    std::string time(const rational& away) const { return fmt::format("{}+({})", tau.text, away.str()); }
    std::string text() const {
        return fmt::format("y' = {}*{}*y; y({}) = {}", rate.text, root(), time(begins), start.text);
    }
    mpfr primitive(const rational& away) const {
        const mpfr power = real(rational(exponent + 1));
        const mpfr size = abs(real(away));
        const mpfr value = size == 0 ? mpfr(0) : mpfr(pow(size, power) / power);
        return side < 0 ? mpfr(-value) : value;
    }
    mpfr value(const rational& away) const {
        return start.value() * exp(mpfr(rate.value() * (primitive(away) - primitive(begins))));
    }
};

// 0, or up to 4, or far closer to 0.
rational distance(choices& next) {
    if (next.one_in(4)) {
        return 0;
    }
    return next.one_in(3) ? decimal_fraction(1, next.between(1, 60)) : decimal_fraction(next.between(1, 4000), 3);
}

growth_with_root any_growth(choices& next) {
    growth_with_root result{any_constant(next), any_constant(next), any_constant(next), rational(1, 3), 0, 0};
    const rational before = decimal_fraction(next.between(1, 3000), 3);
    if (next.one_in(2)) {
        result.begins = next.one_in(2) ? before : rational(-before);
        return result;
    }
    const long degree = next.between(2, 5);
    result.side = next.one_in(2) ? 1 : -1;
    const bool from_root = next.one_in(2);
    // Integrable where the solution begins, continuous where it ends.
    result.exponent = rational(next.between(from_root ? 1 - degree : 1, 2 * degree), degree);
    result.begins = from_root ? rational(0) : rational(result.side * before);
    return result;
}

}  // namespace

outcome ask_root_time(choices& next) {
    const growth_with_root growth = any_growth(next);
    rational away = distance(next);
    if (growth.side < 0 || (growth.side == 0 && next.one_in(2))) {
        away = -away;
    }
    const long digits = next.between(1, 40);
    const std::string typed = growth.time(away);
    return answered(
        fmt::format("libration reference --problem \"{}\" --time \"{}\" --digits {}", growth.text(), typed, digits),
        [&](outcome& result) {
            const auto found = ode::proved_part_of_trajectory(system_of(growth.text()), {time_number(typed)}, digits,
                                                              [](const ball&, long) { require_time_left(); });
            add_first_value(
                result, found, digits, [&] { return growth.value(away); }, "y");
        });
}

}  // namespace libration::attack
