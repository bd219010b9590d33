// Upper bounds on sizes: numbers of 30 bits with every operation rounded up.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// A number >= 0, or infinity, with unbounded exponents [Arb, mag_t]: sums, products and quotients are at least the
/// exact ones of the operands, and larger by a factor of at most 1 + 2^-28. Exact as an operand.
class magnitude {
public:
    magnitude() { mag_init(value_); }
    template <std::unsigned_integral I>
    explicit magnitude(I n) : magnitude() {
        mag_set_ui(value_, n);
    }
    /// A bound on |x| for every number x of the ball.
    explicit magnitude(const ball& x) : magnitude() { arb_get_mag(value_, x.handle()); }
    magnitude(const magnitude& other) : magnitude() { mag_set(value_, other.value_); }
    magnitude(magnitude&& other) noexcept : magnitude() { mag_swap(value_, other.value_); }
    magnitude& operator=(const magnitude& other) {
        mag_set(value_, other.value_);
        return *this;
    }
    magnitude& operator=(magnitude&& other) noexcept {
        mag_swap(value_, other.value_);
        return *this;
    }
    ~magnitude() { mag_clear(value_); }

    /// The radius of a ball.
    static magnitude radius_of(const ball& x) {
        magnitude result;
        mag_set(result.value_, arb_radref(x.handle()));
        return result;
    }
    /// A lower bound on |x| for every number x of the ball; 0 if one of them is 0.
    static magnitude below(const ball& x) {
        magnitude result;
        arb_get_mag_lower(result.value_, x.handle());
        return result;
    }
    /// m 2^e, exactly if m has at most 30 bits.
    static magnitude of(unsigned long m, long e) {
        magnitude result;
        mag_set_ui_2exp_si(result.value_, m, e);
        return result;
    }

    /// x 2^e or more, for finite x >= 0.
    static magnitude at_least(double x, long e) {
        magnitude result;
        mag_set_d(result.value_, x);
        mag_mul_2exp_si(result.value_, result.value_, e);
        return result;
    }
    /// A bound on |midpoint of x|.
    static magnitude midpoint_of(const ball& x) {
        magnitude result;
        arf_get_mag(result.value_, arb_midref(x.handle()));
        return result;
    }

    mag_srcptr handle() const { return value_; }

    magnitude& operator+=(const magnitude& b) {
        mag_add(value_, value_, b.value_);
        return *this;
    }
    magnitude& operator*=(const magnitude& b) {
        mag_mul(value_, value_, b.value_);
        return *this;
    }
    /// += a b.
    void add_product(const magnitude& a, const magnitude& b) { mag_addmul(value_, a.value_, b.value_); }
    friend magnitude operator+(magnitude a, const magnitude& b) { return a += b; }
    friend magnitude operator*(magnitude a, const magnitude& b) { return a *= b; }
    /// Infinity if b is 0.
    friend magnitude operator/(const magnitude& a, const magnitude& b) {
        magnitude result;
        mag_div(result.value_, a.value_, b.value_);
        return result;
    }
    friend magnitude operator/(const magnitude& a, unsigned long n) {
        magnitude result;
        mag_div_ui(result.value_, a.value_, n);
        return result;
    }
    /// At most a - b, and at least 0.
    static magnitude difference_below(const magnitude& a, const magnitude& b) {
        magnitude result;
        mag_sub_lower(result.value_, a.value_, b.value_);
        return result;
    }
    friend magnitude pow(const magnitude& a, unsigned long n) {
        magnitude result;
        mag_pow_ui(result.value_, a.value_, n);
        return result;
    }
    /// At least exp(a).
    friend magnitude exponential(const magnitude& a) {
        magnitude result;
        mag_exp(result.value_, a.value_);
        return result;
    }
    /// At least sqrt(a^2 + b^2).
    friend magnitude hypotenuse(const magnitude& a, const magnitude& b) {
        magnitude result;
        mag_hypot(result.value_, a.value_, b.value_);
        return result;
    }
    friend bool operator<(const magnitude& a, const magnitude& b) { return mag_cmp(a.value_, b.value_) < 0; }
    friend bool operator<=(const magnitude& a, const magnitude& b) { return mag_cmp(a.value_, b.value_) <= 0; }

    bool is_zero() const { return mag_is_zero(value_) != 0; }
    bool is_finite() const { return mag_is_finite(value_) != 0; }
    /// e with 2^(e-1) <= this < 2^e; for finite nonzero values, within the range of long.
    long exponent() const { return fmpz_get_si(MAG_EXPREF(value_)); }
    /// This times 2^e, exactly.
    magnitude shifted(long e) const {
        magnitude result;
        mag_mul_2exp_si(result.value_, value_, e);
        return result;
    }
    /// At least this, if it is in the range of double.
    double above() const { return mag_get_d(value_); }
    /// The exact number.
    ball exact() const {
        ball result;
        arf_set_mag(arb_midref(result.handle()), value_);
        return result;
    }

private:
    mag_t value_;
};

/// log2 x to a few units in the last place of a double, for choices on which no proof depends; minus infinity for 0.
inline double log_of(const magnitude& x) {
    if (x.is_zero()) {
        return -std::numeric_limits<double>::infinity();
    }
    const long exponent = x.exponent();
    return std::log2(mag_get_d((x * magnitude::of(1, -exponent)).handle())) + static_cast<double>(exponent);
}

/// 2^x rounded to 16 bits, for the same purpose.
inline magnitude power_of_two(double x) {
    const double whole = std::floor(x);
    return magnitude::of(static_cast<unsigned long>(std::exp2(x - whole + 15)), static_cast<long>(whole) - 15);
}

/// x with its radius enlarged by a bound: all numbers at most that far from one of x.
inline ball widened(ball x, const magnitude& by) {
    arb_add_error_mag(x.handle(), by.handle());
    return x;
}

}  // namespace libration
