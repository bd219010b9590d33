// Fixed-point balls: midpoints >= 0 with n limbs after the point and one before it, which up to 1200 bits or so are
// several times cheaper than the floating-point balls of Arb; they are converted to and from those for Arb's functions.
//
// A fixed_ball represents a real X with |X - x| <= r u, x = m u, u = 2^(-64 n), m an integer of up to n+1 limbs. Every
// operation rounds its exact result on the midpoints down to a multiple of u, an error of less than 1 unit, and adds
// the effect of the radii r of x and s of y:
//   x +- y      r + s, without rounding;
//   x y         |XY - xy| <= x s u + y r u + r s u^2: x s + y r + r s u units;
//   x/y         |X/Y - x/y| = |(X-x) - (x/y)(Y-y)|/Y <= (r + (x/y) s) u/(y - s u);
//   sqrt(w)     for |W - w| <= d: D = |sqrt W - sqrt w| = |W-w|/(sqrt W + sqrt w) <= d/sqrt w. If that is at most
//               2^-10 sqrt w, sqrt W >= (1 - 2^-10) sqrt w, so D <= d/((2 - 2^-10) sqrt w) < d (513/1024)/sqrt w.
// Radii are doubles, all >= 0. Each is computed in fewer than 16 operations with a relative rounding error of 2^-53,
// from bounds on the midpoints; the factor `slack` = 1 + 2^-20 makes them upper bounds again. Divisors and roots are at
// least 2^-30 and known to a relative 2^-24, so y - s u >= y (1 - 2^-24), and the first limb, used for y itself, is
// below it by a relative 2^-33 at most: slack covers both. Overflow throws precision_exhausted; nothing wraps.
#pragma once

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// The arithmetic above. Operands have the same n. Cost: one call of GMP's mpn layer and a few flops per operation.
/// Throws precision_exhausted for results below 0 or beyond 2^64, and for divisors and roots that are too small or too
/// wide.
class fixed_ball {
public:
    static constexpr int most_limbs = 20;

    /// To be assigned to.
    fixed_ball() = default;
    fixed_ball(const fixed_ball& other) { *this = other; }
    // Only the limbs in use.
    fixed_ball& operator=(const fixed_ball& other) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(other.size_); ++i) {
            limbs_[i] = other.limbs_[i];
        }
        n_ = other.n_;
        size_ = other.size_;
        radius_ = other.radius_;
        return *this;
    }
    ~fixed_ball() = default;
    /// 0, with n limbs after the point, 1 <= n <= most_limbs.
    explicit fixed_ball(int n) : n_(n) {}
    /// An integer.
    fixed_ball(int n, mp_limb_t value) : n_(n), size_(value == 0 ? 0 : n + 1) {
        std::fill_n(limbs_.begin(), n, mp_limb_t{0});
        limbs_[static_cast<std::size_t>(n)] = value;
    }
    /// |midpoint| of a ball, with its radius.
    fixed_ball(int n, const ball& x) : n_(n) {
        fmpz_t integer_part;
        fmpz_init(integer_part);
        arf_get_fmpz_fixed_si(integer_part, arb_midref(x.handle()), -bits());
        fmpz_abs(integer_part, integer_part);
        const auto count = static_cast<int>(fmpz_size(integer_part));
        if (count <= n_ + 1) {
            fmpz_get_ui_array(limbs_.data(), n_ + 1, integer_part);
        }
        fmpz_clear(integer_part);
        mag_t units;
        mag_init(units);
        mag_mul_2exp_si(units, arb_radref(x.handle()), bits());
        const bool wide = count > n_ + 1 || mag_cmp_2exp_si(units, 40) > 0;
        radius_ = wide ? 0 : and_cut(mag_get_d(units));
        mag_clear(units);
        require(!wide);
        take(n_ + 1);
    }
    /// sqrt(q/2), q > 0: of q/2 in twice the limbs, both rounded down, so less than 1 unit off.
    static fixed_ball root_of_half(int n, const rational& q);

    int limbs() const { return n_; }
    long bits() const { return long{64} * n_; }
    bool is_zero() const { return size_ == 0; }
    /// Bounds on the midpoint from its first limbs, and the radius in units.
    double above() const { return (below() + 1 / limb()) * slack(); }
    double below() const { return static_cast<double>(at(n_)) + static_cast<double>(at(n_ - 1)) / limb(); }
    double radius() const { return radius_; }
    /// An l with X <= 2^-l.
    long smallness() const {
        const long used = size_ == 0 ? 0 : long{64} * size_ - __builtin_clzl(at(size_ - 1));
        // m < 2^used and r < 2^wide.
        const long wide = std::ilogb(radius_ + 1) + 1;
        return bits() - std::max(used, wide) - 1;
    }
    /// The same midpoint with the radius enlarged by this number of units.
    fixed_ball& widen_by(double units) {
        radius_ = (radius_ + units) * slack();
        return *this;
    }
    ball to_ball() const {
        ball result;
        if (size_ > 0) {
            arf_set_mpn(arb_midref(result.handle()), limbs_.data(), size_, 0);
        }
        mag_set_d(arb_radref(result.handle()), radius_ * slack());
        arb_mul_2exp_si(result.handle(), result.handle(), -bits());
        return result;
    }

    friend fixed_ball operator+(const fixed_ball& x, const fixed_ball& y);
    friend fixed_ball operator-(const fixed_ball& x, const fixed_ball& y);
    friend fixed_ball operator*(const fixed_ball& x, const fixed_ball& y);
    friend fixed_ball operator/(const fixed_ball& x, const fixed_ball& y);
    friend fixed_ball geometric_mean(const fixed_ball& x, const fixed_ball& y);
    /// x 2^k, 0 < |k| < 64.
    friend fixed_ball ldexp(const fixed_ball& x, int k);

private:
    using words = std::array<mp_limb_t, 2 * most_limbs + 4>;

    static constexpr double limb() { return static_cast<double>(1UL << 32U) * static_cast<double>(1UL << 32U); }
    static constexpr double slack() { return 1 + 1 / static_cast<double>(1UL << 20U); }
    // A radius plus the unit for rounding down.
    static double and_cut(double radius) { return (radius * slack() + 1) * slack(); }
    // Separate, so that the compiler inlines the test wherever it is used.
    [[noreturn]] static void refuse() { throw precision_exhausted("a number in fixed point"); }
    static void require(bool holds) {
        if (!holds) {
            refuse();
        }
    }
    mp_limb_t at(int i) const { return i < size_ ? limbs_[static_cast<std::size_t>(i)] : 0; }
    // Keeps `size` limbs, without leading zeros.
    void take(int size) {
        while (size > 0 && limbs_[static_cast<std::size_t>(size - 1)] == 0) {
            --size;
        }
        size_ = size;
    }
    // Copies a result of this number of limbs.
    void take(const mp_limb_t* from, int size) {
        while (size > 0 && from[size - 1] == 0) {
            --size;
        }
        require(size <= n_ + 1);
        size_ = std::max(size, 0);
        for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) {
            limbs_[i] = from[i];
        }
    }
    // x y into w; returns the number of its limbs.
    static int product(words& w, const fixed_ball& x, const fixed_ball& y) {
        if (x.size_ == 0 || y.size_ == 0) {
            return 0;
        }
        if (&x == &y) {
            mpn_sqr(w.data(), x.limbs_.data(), x.size_);
        } else {
            const bool longer = x.size_ >= y.size_;
            const fixed_ball& a = longer ? x : y;
            const fixed_ball& b = longer ? y : x;
            mpn_mul(w.data(), a.limbs_.data(), a.size_, b.limbs_.data(), b.size_);
        }
        return x.size_ + y.size_;
    }
    // Without leading zeros.
    static int significant(const words& w, int size) {
        while (size > 0 && w[static_cast<std::size_t>(size - 1)] == 0) {
            --size;
        }
        return size;
    }
    // Of the product, in units.
    static double product_radius(const fixed_ball& x, const fixed_ball& y) {
        return (x.above() * y.radius_ + y.above() * x.radius_ + x.radius_ * y.radius_ / limb()) * slack();
    }
    // Whether it is large and narrow enough as a divisor: at least 2^-30, and known to a relative 2^-24.
    bool divides() const {
        const double size = below();
        return size * static_cast<double>(1UL << 30U) >= 1 &&
               radius_ * static_cast<double>(1UL << 24U) <= size * limb();
    }

    std::array<mp_limb_t, most_limbs + 2> limbs_;
    int n_ = 0;
    int size_ = 0;
    double radius_ = 0;
};

}  // namespace libration
