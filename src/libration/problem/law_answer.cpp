#include "libration/problem/law_answer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "law_words.hpp"
#include "libration/asymptotics/coefficient_law.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/query/problem_coefficients.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "plane_work.hpp"

namespace libration {

namespace {

constexpr long bits_beyond_law_digits = 96;
constexpr int most_sharper_runs = 3;
constexpr long last_power_of_recurrence = 20'000;
constexpr long digits_beyond_recurrence = 6;

// The unknown and the derivative of a name such as th'.
struct shown_quantity {
    std::size_t unknown = 0;
    int derivative = 0;
    std::string name;
};

shown_quantity quantity_named(const ode::explicit_system& system, const std::string& text) {
    if (text.empty()) {
        return {0, 0, system.unknowns().front().name};
    }
    const auto primes = text.find_last_not_of('\'');
    const std::string name = text.substr(0, primes == std::string::npos ? 0 : primes + 1);
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        if (system.unknowns()[i].name == name) {
            return {i, static_cast<int>(text.size() - name.size()), text};
        }
    }
    throw error(error_kind::argument, error_subject::unknowns, text,
                "is not an unknown of the problem, or one with primes for a derivative");
}

// A double that is not below, the number itself if it is one.
double double_at_least(const exact& x) {
    const auto nearest = from_exact<double>(x);
    ball of;
    arb_set_d(of.handle(), nearest);
    const ball difference = from_exact<ball>(x) - of;
    const bool same = is_exact(difference) && contains_zero(difference);
    return same ? nearest : std::nextafter(nearest, std::numeric_limits<double>::infinity());
}

class law_values {
public:
    law_values(const ode::explicit_system& system, const shown_quantity& of, ode::coefficient_law& law, long digits)
        : system_(system), of_(of), law_(law), digits_(digits) {}

    // With as many digits of a_n as are proved, up to those of the request; by the recurrence if the law gives less.
    std::vector<answer_value> row(long n) {
        if (law_.vanishes(n)) {
            return {whole_value(n), {"0", "0"}, text_value("symmetry")};
        }
        known_value value;
        if (n >= law_.first()) {
            value = by_law(n);
        }
        std::string by = "law";
        if (!value.decimal && n <= last_power_of_recurrence) {
            value = by_recurrence(n);
            by = "recurrence";
        }
        if (!value.decimal) {
            complete_ = false;
            if (n >= law_.first()) {
                value = by_law(n, true);
                by = "law";
            }
        }
        return {whole_value(n),
                value.decimal ? answer_value{value.decimal->text, value.decimal->uncertainty}
                              : answer_value{"", value.bound},
                text_value(by)};
    }
    bool complete() const { return complete_; }

private:
    // The digits of the request or, with `fewer`, as many as are proved, else a bound.
    known_value by_law(long n, bool fewer = false) {
        known_value result;
        const auto bits_of_power = static_cast<long>(std::log2(static_cast<double>(n) + 2)) * 2;
        with_half_more_bits(
            bits_of_digits(digits_) + bits_of_power + bits_beyond_law_digits, most_sharper_runs, [&](long bits) {
                const precision_scope scope(decimal_digits(bits));
                if (sharp_ < bits) {
                    law_.sharpen();
                    sharp_ = bits;
                }
                const ball value = law_.value(n);
                const long proved = is_finite(value) ? proved_digits(value, digits_) : 0;
                if (proved == digits_ || (fewer && proved > 0)) {
                    result.decimal = to_proved_decimal(value, proved);
                } else if (is_finite(value)) {
                    result.bound = upper_bound_text(value);
                }
                // Where E_n is the larger part more bits do not help.
                const bool by_error = magnitude::radius_of(value) < magnitude(law_.error_bound(n)) * magnitude(2U);
                return proved == digits_ || by_error ? std::optional(true) : std::nullopt;
            });
        return result;
    }

    known_value by_recurrence(long n) const {
        const long power = n + of_.derivative;
        const auto list = ode::proved_coefficients({system_, power, power}, digits_ + digits_beyond_recurrence);
        const proved_decimal& of_unknown = list.values[of_.unknown];
        known_value result;
        if (of_.derivative == 0) {
            const precision_scope scope(digits_ + 30);
            result.decimal = to_proved_decimal(ball_of(of_unknown), digits_);
            return result;
        }
        const precision_scope scope(digits_ + 30);
        ball value = ball_of(of_unknown);
        for (long k = 1; k <= of_.derivative; ++k) {
            value *= n + k;
        }
        result.decimal = to_proved_decimal(value, digits_);
        return result;
    }

    static ball ball_of(const proved_decimal& value) {
        ball result;
        const std::string with_bound = value.text + " +/- " + value.uncertainty;
        arb_set_str(result.handle(), with_bound.c_str(), ball::working_bits());
        return result;
    }

    const ode::explicit_system& system_;
    const shown_quantity& of_;
    ode::coefficient_law& law_;
    long digits_;
    long sharp_ = 0;
    bool complete_ = true;
};

}  // namespace

law_report law_of(const ode::explicit_system& system, const law_question& asked, const request& how) {
    const whole_exponent_range exponents;
    const long digits = how.printed_digits();
    const shown_quantity shown = quantity_named(system, asked.show);
    plane_work work(how);
    ode::law_request request{.unknown = shown.unknown, .derivative = shown.derivative, .terms = asked.terms};
    request.watch = work.watch();
    if (asked.within) {
        request.within = double_at_least(*asked.within);
    }
    ode::coefficient_law law = ode::coefficient_law::of(system, request);
    law_report report;
    with_half_more_bits(bits_of_first_run(digits), most_sharper_runs, [&](long bits) {
        const precision_scope scope(decimal_digits(bits));
        law.sharpen();
        report.singularities = singularities_of_law(law, shown.name, asked.terms, digits);
        return std::optional(true);
    });
    report.coefficients = {.names = {"n", "value", "by"}, .rows = {}, .rigour = "proved"};
    law_values values(system, shown, law, digits);
    for (const long n : asked.orders) {
        report.coefficients.rows.push_back(values.row(n));
    }
    report.complete = values.complete();
    return report;
}

}  // namespace libration
