// Adapts the number of bits from run to run to the digits that the last run did not prove.
#pragma once

#include <string>

#include "libration/ode/constant_value.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/text/decimal.hpp"

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

inline std::string text_of_time(const number& time) {
    const precision_scope scope(20);
    return to_decimal(constant_value<mpfr>::of(time), 12);
}

// An event undecided with this number of bits, and this multiple of those of the first run, is rejected.
inline constexpr long most_undecided_bits = 4096;
inline constexpr long most_undecided_factor = 16;

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
        } else if (!raised_at_zero(subject, of)) {
            throw error(error_kind::undecided, subject, of,
                        "has a value that " + std::to_string(now_) + " bits do not distinguish from 0");
        }
        return std::nullopt;
    }
    /// Adds the number of bits that a value that excludes 0 lacks for its digits.
    void raise_for(const ball& value, const std::string& subject, const std::string& of) {
        raise_to(now_ + bits_of_digits(digits_ - proved_digits(value, digits_)) + now_ / 32 + 8, subject, of);
    }
    /// Doubles the bits for a value that contains 0; false after several such runs.
    bool raised_at_zero(const std::string& subject, const std::string& of) {
        if (++runs_at_zero_ >= most_runs_at_zero) {
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
    // The maximum number of runs, each with more bits, that do not distinguish a value from 0.
    static constexpr int most_runs_at_zero = 6;

    long digits_;
    long now_;
    int runs_at_zero_ = 0;
};

}  // namespace libration::ode
