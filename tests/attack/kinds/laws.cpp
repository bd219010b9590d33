// Coefficients by the law of all coefficients, and what it proves of ratios, roots and their limits.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "attack/kinds/law_problems.hpp"
#include "libration/asymptotics/coefficient_law.hpp"
#include "libration/problem/proved_law.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/exponent_range.hpp"

namespace libration::attack {

// Each coefficient of the law counts as one statement.
outcome ask_law(choices& next) {
    const asked_law asked = any_law(next);
    const long order = next.one_in(8) ? 1000 : 200;
    const std::string command =
        fmt::format("libration asymptotics --problem \"{}\" --order 3,30,{}", asked.text, order);
    return answered(command, [&](outcome& result) {
        const whole_exponent_range exponents;
        const precision_scope scope(60);
        ode::law_request request;
        request.watch = [](ode::plane_step /*step*/) { require_time_left(); };
        const auto law = ode::coefficient_law::of(system_of(asked.text), request);
        for (const long n : {3L, 30L, 31L, 32L, order - 1, order}) {
            if (n >= law.first()) {
                result.add(judged_ball(law.value(n), [&] { return asked.coefficient(n); }),
                           fmt::format("coefficient {}", n));
            }
        }
    });
}

namespace {

// The digits and the bound of a number that may have fewer digits than requested.
void add_digits(outcome& to, const known_value& number, const truth& exact, const std::string& name) {
    long digits = 1;
    if (number.decimal) {
        const std::string& text = number.decimal->text;
        const std::string mantissa = text.substr(0, text.find_first_of("eE"));
        const std::size_t first = std::min(mantissa.find_first_of("123456789"), mantissa.size());
        digits = std::max(1L, static_cast<long>(std::count_if(mantissa.begin() + static_cast<long>(first),
                                                              mantissa.end(), [](char c) { return c != '.'; })));
    }
    add_number(to, number, digits, exact, name);
}

// |x - line| <= deviation, where only a decimal of the line is known.
void add_deviation(outcome& to, const known_value& from, const std::string& deviation, const truth& exact,
                   const std::string& name) {
    if (from.decimal && !deviation.empty()) {
        to.add(judged_distance(from.decimal->text, {deviation, from.decimal->uncertainty}, exact),
               fmt::format("|{} - {}| <= {}", name, from.decimal->text, deviation));
    }
}

void add_line(outcome& to, const proved_law& law, const nearest_singularity& nearest, int derivative, long digits) {
    const known_value limit = law.limit(digits);
    add_digits(to, law.radius(digits), nearest.modulus, "radius");
    if (!limit.decimal && limit.bound.empty()) {
        return;
    }
    if (!nearest.limit || nearest.power != law.stride()) {
        to.add(verdict::wrong, "a limit of ratios that have none");
        return;
    }
    add_digits(to, limit, nearest.limit, "limit");
    add_digits(
        to, law.exponent(digits), [&] { return real(rational(nearest.exponent - derivative)); }, "exponent");
}

}  // namespace

// The limit, the radius and the exponent, and the ratio, root and deviations of each n count as statements.
outcome ask_law_line(choices& next) {
    const asked_law asked = next.one_in(3) ? any_law(next) : any_closed_law(next);
    const int derivative = next.one_in(4) ? 1 : 0;
    const std::string name = asked.text.starts_with("x1") ? "x1" : "y";
    const std::string show = name + (derivative == 1 ? "'" : "");
    const long digits = next.between(3, 25);
    const std::vector<long> orders{0, next.between(1, 9), 200, next.one_in(6) ? 1000 : 203};
    const std::string command = fmt::format("libration study domb_sykes --problem \"{}\" --prove --orders {}  ({})",
                                            asked.text, orders.back(), show);
    return answered(command, [&](outcome& result) {
        request how = proved_digits(digits);
        how.stage = [](const std::string&) { require_time_left(); };
        const proved_law law(system_of(asked.text), {.show = show}, how);
        if (asked.nearest) {
            add_line(result, law, *asked.nearest, derivative, digits);
        }
        const long p = law.stride();
        const auto coefficient = [&](long n) { return asked.coefficient(n, derivative); };
        for (const long order : orders) {
            long n = std::max(order, 1L) + (order < 100 ? law.first() + p : 0);
            n += ((law.residue() - n) % p + p) % p;
            const auto by =
                n == orders.back() && n >= law.first() + p ? proved_law::source::any : proved_law::source::law;
            if (n < law.first() + p) {
                continue;
            }
            const truth ratio = [&] { return mpfr(coefficient(n) / coefficient(n - p)); };
            const truth root = [&] { return mpfr(pow(mpfr(abs(coefficient(n))), mpfr(mpfr(-1) / n))); };
            try {
                const law_ratio found = law.ratio(n, digits, by);
                add_digits(result, found.ratio, ratio, fmt::format("ratio {}", n));
                add_deviation(result, found.line, found.deviation, ratio, fmt::format("ratio {}", n));
                const law_root at = law.root(n, digits, by);
                add_digits(result, at.root, root, fmt::format("root {}", n));
                add_deviation(result, law.radius(digits), at.deviation, root, fmt::format("root {}", n));
            } catch (const error& refusal) {
                result.add(verdict::refused, refusal.what());
            }
        }
    });
}

}  // namespace libration::attack
