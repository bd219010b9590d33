// From run to run: how many bits the digits need that the last one did not prove.
#pragma once

#include <string>

#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

inline constexpr long first_guard_bits = 64;
inline constexpr long most_bits = 1'000'000;

inline long bits_of_digits(long digits) { return digits * 3322 / 1000 + 4; }

/// The time up to which a solution is proved to exist, rounded towards the start.
inline std::string proved_reach_text(const ball& reached, bool forward) {
    const precision_scope scope(20);
    const mpfr bound = midpoint_of(forward ? lower_bound(reached) : upper_bound(reached));
    return bound == 0 ? "0" : parts_of(bound, 12, forward ? MPFR_RNDD : MPFR_RNDU).text();
}

/// The bits of a run, and of the next one.
class needed_bits {
public:
    explicit needed_bits(long digits) : digits_(digits), now_(bits_of_digits(digits) + first_guard_bits) {}

    long now() const { return now_; }
    /// The decimal, or nothing, and then more bits. Throws error of the kind undecided for a value that several runs
    /// do not tell from 0: `subject` and `value` say whose it is.
    std::optional<proved_decimal> printed(const ball& value, const std::string& subject, const std::string& of) {
        auto decimal = to_proved_decimal(value, digits_);
        if (decimal) {
            return decimal;
        }
        if (!contains_zero(value)) {
            raise_to(now_ + bits_of_digits(digits_ - proved_digits(value, digits_)) + now_ / 32 + 8, subject, of);
        } else if (++runs_at_zero_ >= most_runs_at_zero) {
            throw error(error_kind::undecided, subject, of,
                        "has a value that " + std::to_string(now_) + " bits do not tell from 0");
        } else {
            raise_to(2 * now_, subject, of);
        }
        return std::nullopt;
    }
    void raise_to(long bits, const std::string& subject, const std::string& of) {
        now_ = bits;
        if (now_ > most_bits) {
            throw error(error_kind::undecided, subject, of, "is not proved by a million bits");
        }
    }

private:
    // A value that so many runs, each with more bits, do not tell from 0 is taken for one.
    static constexpr int most_runs_at_zero = 6;

    long digits_;
    long now_;
    int runs_at_zero_ = 0;
};

}  // namespace libration::ode
