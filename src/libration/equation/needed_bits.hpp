// Adapts the number of bits from run to run to the digits that the last run did not prove.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/digits/proved_value.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::ode {

inline constexpr long first_guard_bits = 64;
inline constexpr long most_bits = 1'000'000;

inline long bits_of_digits(long digits) { return digits * 3322 / 1000 + 4; }

/// The time up to which a solution is proved to exist, rounded towards the initial point.
inline std::string proved_reach_text(const ball& reached, bool forward) {
    const precision_scope scope(20);
    const mpfr bound = midpoint_of(forward ? lower_bound(reached) : upper_bound(reached));
    return bound == 0 ? "0" : parts_of(bound, 12, forward ? MPFR_RNDD : MPFR_RNDU).text();
}

/// A time as a decimal of at most 12 digits, the exact one if it is that short.
inline std::string text_of_time(const number& time) {
    const auto fraction = time.fraction();
    const auto exact = fraction ? to_finite_decimal(*fraction, 12) : std::nullopt;
    if (exact) {
        return *exact;
    }
    const precision_scope scope(20);
    return to_decimal(constant_value<mpfr>::of(time), 12);
}

inline constexpr long digits_of_bounds = 12;

// An exact number, rounded down or up.
inline std::string bound_text(const ball& exact, mpfr_rnd_t rounding) {
    const mpfr value = midpoint_of(exact);
    return value == 0 ? "0" : parts_of(value, digits_of_bounds, rounding).text();
}

// Decimals between which every number of the ball lies.
inline std::string bounds_text(const ball& x) {
    return "[" + bound_text(lower_bound(x), MPFR_RNDD) + ", " + bound_text(upper_bound(x), MPFR_RNDU) + "]";
}

/// Replaces a value without digits by what an enclosure of it proves: `digits` digits, else a bound.
inline void improve(known_value& known, const ball& value, long digits) {
    if (!known.decimal) {
        known.decimal = to_proved_decimal(value, digits);
        known.bound = known.decimal || !is_finite(value) ? "" : bound_text(value);
    }
}

/// The reason why the first value without digits, which contains 0, is left so after a run with so many bits.
inline std::string text_of_undecided(const std::vector<std::string>& names, const std::vector<known_value>& values,
                                     long bits) {
    const auto first = std::ranges::find_if(values, [](const known_value& each) { return !each.decimal; });
    const std::string& name = names[static_cast<std::size_t>(first - values.begin())];
    return "has a value of " + name + " that " + std::to_string(bits) + " bits do not distinguish from 0: |" + name +
           "| < " + first->bound;
}

/// The bits of a run, and of the next one.
class needed_bits {
public:
    explicit needed_bits(long digits) : digits_(digits), now_(bits_of_digits(digits) + first_guard_bits) {}

    long now() const { return now_; }
    /// The decimal; without one, requests more bits for the next run. Throws error of the kind undecided for a value
    /// that several runs do not distinguish from 0: `subject` and `value` name it.
    std::optional<proved_decimal> printed(const ball& value, const std::string& subject, const std::string& of) {
        auto decimal = to_proved_decimal(value, digits_);
        if (decimal) {
            return decimal;
        }
        if (!contains_zero(value)) {
            raise_for(value, subject, of);
        } else if (!raised_at_zero(0, subject, of)) {
            throw error(error_kind::undecided, subject, of,
                        "has a value that " + std::to_string(now_) + " bits do not distinguish from 0");
        }
        return std::nullopt;
    }
    /// Adds the number of bits that a value that excludes 0 lacks for its digits.
    void raise_for(const ball& value, const std::string& subject, const std::string& of) {
        raise_to(now_ + bits_of_digits(digits_ - proved_digits(value, digits_)) + now_ / 32 + 8, subject, of);
    }
    /// Doubles the bits for a value that contains 0, after a run of so many steps of the integrator. False after three
    /// such runs, or after six if the next one is short.
    bool raised_at_zero(long steps, const std::string& subject, const std::string& of) {
        const double next = 2 * static_cast<double>(now_);
        const bool is_short = static_cast<double>(steps) * next * next <= most_work_at_zero;
        if (++runs_at_zero_ >= (is_short ? most_runs_at_zero : usual_runs_at_zero)) {
            return false;
        }
        raise_to(2 * now_, subject, of);
        return true;
    }
    void raise_to(long bits, const std::string& subject, const std::string& of) {
        now_ = bits;
        if (now_ > most_bits) {
            throw error(error_kind::undecided, subject, of, "is not proved by a million bits");
        }
    }

private:
    // The maximum number of runs, each with more bits, that do not distinguish a value from 0: most of these are 0.
    static constexpr int usual_runs_at_zero = 3;
    static constexpr int most_runs_at_zero = 6;
    // The steps of a short run times the square of its bits; about a second.
    static constexpr double most_work_at_zero = 1L << 23;

    long digits_;
    long now_;
    int runs_at_zero_ = 0;
};

}  // namespace libration::ode
