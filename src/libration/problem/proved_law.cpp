#include "libration/problem/proved_law.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "law_words.hpp"
#include "libration/asymptotics/ratio_line.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/query/problem_coefficients.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "plane_work.hpp"

namespace libration {

// The unknown and the derivative of a name such as th'.
struct shown_quantity {
    std::size_t unknown = 0;
    int derivative = 0;
    std::string name;
};

namespace {

constexpr long bits_beyond_law_digits = 96;
constexpr int most_sharper_runs = 3;
constexpr long last_power_of_recurrence = 20'000;
constexpr long last_power_of_fractions = 2'000;
constexpr long digits_beyond_recurrence = 6;
constexpr long guard_digits_of_recurrence = 30;

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

ode::coefficient_law law_for(const ode::explicit_system& system, const shown_quantity& of, const law_question& asked,
                             ode::plane_watch watch) {
    const whole_exponent_range exponents;
    ode::law_request request{.unknown = of.unknown, .derivative = of.derivative, .terms = asked.terms};
    request.watch = std::move(watch);
    if (asked.within) {
        request.within = double_at_least(*asked.within);
    }
    return ode::coefficient_law::of(system, request);
}

ball ball_of(const proved_decimal& value) {
    ball result;
    const std::string with_bound = value.text + " +/- " + value.uncertainty;
    arb_set_str(result.handle(), with_bound.c_str(), ball::working_bits());
    return result;
}

known_value exact_zero() { return {proved_decimal{"0", "0"}, ""}; }

// With the digits of the request or, with `fewer`, as many as are proved, else a bound.
known_value known_of(const ball& value, long digits, bool fewer) {
    known_value result;
    const long proved = is_finite(value) ? proved_digits(value, digits) : 0;
    if (proved == digits || (fewer && proved > 0)) {
        result.decimal = to_proved_decimal(value, proved);
    } else if (is_finite(value)) {
        result.bound = upper_bound_text(value);
    }
    return result;
}

}  // namespace

class proved_law::values {
public:
    values(const ode::explicit_system& system, const law_question& asked, const request& how)
        : system_(system),
          of_(quantity_named(system, asked.show)),
          terms_(asked.terms),
          how_(how),
          law_(law_for(system, of_, asked, work_.watch())) {}

    const ode::coefficient_law& law() const { return law_; }
    const std::string& name() const { return of_.name; }

    answer singularities(long digits) {
        answer result;
        at_bits(bits_of_first_run(digits), [&] { result = singularities_of_law(law_, of_.name, terms_, digits); });
        return result;
    }

    // A number of the coefficients n - back and n, and of what else has the working precision. `of` has both, 0 for the
    // first without a `back`.
    struct asked_number {
        long n = 0;
        long back = 0;
        std::function<ball(const ball& before, const ball& at)> of;
    };

    // By the law, by the recurrence if the law gives fewer digits, and then with as many as the law gives.
    // An exact 0 is that of the coefficient.
    coefficient_value number(const asked_number& asked, long digits, source by) {
        const bool has_law = asked.n - asked.back >= law_.first();
        if (by == source::law) {
            return {by_law(asked, digits, true), "law"};
        }
        known_value value;
        if (has_law) {
            value = by_law(asked, digits, false);
        }
        if (value.decimal) {
            return {value, "law"};
        }
        if (asked.n <= last_power_of_recurrence) {
            // Where the law does not distinguish it from 0, before the recurrence tries up to thousands of digits.
            if (has_law && !by_law(asked, digits, true).decimal && is_zero_by_fractions(asked)) {
                return {exact_zero(), "recurrence"};
            }
            try {
                value = by_recurrence(asked, digits);
            } catch (const error& reason) {
                if (has_law || reason.kind() != error_kind::undecided || !is_zero_by_fractions(asked)) {
                    throw;
                }
                value = exact_zero();
            }
            if (value.decimal) {
                return {value, "recurrence"};
            }
        }
        return {has_law ? by_law(asked, digits, true) : value, "law", false};
    }

    // A number of the law, std::nullopt where it proves none, with as many of the digits as it gives.
    template <class Of>
    known_value known(long digits, const Of& of) {
        known_value result;
        at_bits(bits_of_digits(digits) + bits_beyond_law_digits, [&] {
            const std::optional<ball> found = of(law_);
            result = found ? known_of(*found, digits, true) : known_value{};
        });
        return result;
    }

    struct compared_value {
        known_value value;
        std::string by;
        std::string deviation;  // a bound of the distance
    };
    // A number of coefficients and its distance from a number of the law, empty where that proves none.
    template <class Of>
    compared_value compared(const asked_number& asked, long digits, source by, const Of& number_of_law) {
        std::optional<ball> distance;
        const auto found = number({asked.n, asked.back,
                                   [&](const ball& before, const ball& at) {
                                       const ball result = asked.of(before, at);
                                       const std::optional<ball> from = number_of_law(law_);
                                       distance = from ? std::optional(abs(ball(result - *from))) : std::nullopt;
                                       return result;
                                   }},
                                  digits, by);
        return {found.value, found.by, distance && is_finite(*distance) ? upper_bound_text(*distance) : ""};
    }

private:
    template <class Of>
    void at_bits(long bits, const Of& of) {
        const whole_exponent_range exponents;
        with_half_more_bits(bits, most_sharper_runs, [&](long more) {
            const precision_scope scope(decimal_digits(more));
            sharpen(more);
            of();
            return std::optional(true);
        });
    }

    void sharpen(long bits) {
        if (sharp_ < bits) {
            law_.sharpen();
            sharp_ = bits;
        }
    }

    known_value by_law(const asked_number& asked, long digits, bool fewer) {
        const whole_exponent_range exponents;
        known_value result;
        const auto bits_of_power = static_cast<long>(std::log2(static_cast<double>(asked.n) + 2)) * 2;
        with_half_more_bits(
            bits_of_digits(digits) + bits_of_power + bits_beyond_law_digits, most_sharper_runs, [&](long bits) {
                const precision_scope scope(decimal_digits(bits));
                sharpen(bits);
                const ball before = asked.back > 0 ? law_.value(asked.n - asked.back) : ball(0);
                const ball at = law_.value(asked.n);
                result = known_of(asked.of(before, at), digits, fewer);
                const bool all = result.decimal && (!fewer || proved_digits(asked.of(before, at), digits) == digits);
                // Where E_n is the larger part more bits do not help.
                const bool by_error = magnitude::radius_of(at) < magnitude(law_.error_bound(asked.n)) * magnitude(2U);
                return all || by_error ? std::optional(true) : std::nullopt;
            });
        return result;
    }

    known_value by_recurrence(const asked_number& asked, long digits) const {
        const whole_exponent_range exponents;
        const long last = asked.n + of_.derivative;
        const auto list =
            ode::proved_coefficients({system_, last - asked.back, last}, digits + digits_beyond_recurrence);
        const precision_scope scope(digits + guard_digits_of_recurrence);
        const std::size_t width = system_.unknowns().size();
        const auto value = [&](long n, std::size_t row) {
            ball result = ball_of(list.values[row * width + of_.unknown]);
            for (long k = 1; k <= of_.derivative; ++k) {
                result *= n + k;
            }
            return result;
        };
        const ball at = value(asked.n, static_cast<std::size_t>(asked.back));
        return known_of(asked.of(asked.back > 0 ? value(asked.n - asked.back, 0) : ball(0), at), digits, false);
    }

    // Whether the coefficient n is exactly 0 without symmetry, as those of a polynomial are: balls do not decide it.
    bool is_zero_by_fractions(const asked_number& asked) const {
        if (asked.back > 0 || asked.n > last_power_of_fractions) {
            return false;
        }
        try {
            const long power = asked.n + of_.derivative;
            return ode::exact_coefficients({system_, power, power}).values[of_.unknown] == 0;
        } catch (const error&) {
            return false;  // not of fractions
        }
    }

    const ode::explicit_system system_;
    const shown_quantity of_;
    int terms_;
    const request how_;
    plane_work work_{how_};  // of each sharpening, too
    ode::coefficient_law law_;
    long sharp_ = 0;
};

proved_law::proved_law(const ode::explicit_system& system, const law_question& asked, const request& how)
    : values_(std::make_unique<values>(system, asked, how)) {}
proved_law::~proved_law() = default;
proved_law::proved_law(proved_law&& other) noexcept = default;
proved_law& proved_law::operator=(proved_law&& other) noexcept = default;

const std::string& proved_law::name() const { return values_->name(); }
double proved_law::rho() const { return values_->law().rho(); }
long proved_law::first() const { return values_->law().first(); }
int proved_law::stride() const { return values_->law().stride(); }
int proved_law::residue() const { return values_->law().residue(); }
answer proved_law::singularities(long digits) const { return values_->singularities(digits); }

namespace {

void require_coefficient(const proved_law& law, long n, long least) {
    if (n < least) {
        throw error(error_kind::argument, "order", std::to_string(n), "is below " + std::to_string(least));
    }
    if (law.stride() > 1 && (n - law.residue()) % law.stride() != 0) {
        throw error(error_kind::argument, "order", std::to_string(n),
                    "has the coefficient 0 by symmetry: those of " + std::to_string(law.residue()) + " mod " +
                        std::to_string(law.stride()) + " remain");
    }
}

}  // namespace

proved_law::coefficient_value proved_law::coefficient(long n, long digits) const {
    if (values_->law().vanishes(n)) {
        return {exact_zero(), "symmetry"};
    }
    return values_->number({n, 0, [](const ball&, const ball& at) { return at; }}, digits, source::any);
}

law_ratio proved_law::ratio(long n, long digits, source by) const {
    require_coefficient(*this, n, (by == source::law ? first() : 0) + stride());
    const auto line = [n](const ode::coefficient_law& law) {
        const auto found = ode::line_of_ratios(law);
        return found ? std::optional(found->at(n)) : std::nullopt;
    };
    const auto found = values_->compared({n, stride(), [](const ball& before, const ball& at) { return at / before; }},
                                         digits, by, line);
    const bool has_line = line(values_->law()).has_value();
    return {found.value, found.by, has_line ? values_->known(digits, line) : known_value{}, found.deviation};
}

law_root proved_law::root(long n, long digits, source by) const {
    require_coefficient(*this, n, by == source::law ? std::max(1L, first()) : 1);
    const auto root = [n](const ball&, const ball& at) { return pow(abs(at), ball(ball(-1) / n)); };
    const auto found = values_->compared({n, 0, root}, digits, by, ode::radius_of_law);
    if (found.value.decimal && found.value.decimal->text == "0") {  // of the coefficient, by fractions
        throw error(error_kind::argument, "order", std::to_string(n), "has the coefficient 0, which has no root");
    }
    return {found.value, found.by, found.deviation};
}

known_value proved_law::limit(long digits) const {
    return values_->known(digits, [](const ode::coefficient_law& law) {
        const auto line = ode::line_of_ratios(law);
        return line ? std::optional(line->limit) : std::nullopt;
    });
}

known_value proved_law::exponent(long digits) const {
    return values_->known(digits, [](const ode::coefficient_law& law) {
        const auto line = ode::line_of_ratios(law);
        return line ? std::optional(line->exponent) : std::nullopt;
    });
}

known_value proved_law::radius(long digits) const { return values_->known(digits, ode::radius_of_law); }

}  // namespace libration
