// Sums, products, quotients and roots of fixed-point balls; their radii are proved in ball_fixed.hpp.
#pragma once

#include "libration/scalar/ball/fixed_point.hpp"

namespace libration {

inline fixed_ball operator+(const fixed_ball& x, const fixed_ball& y) {
    const fixed_ball& a = x.size_ >= y.size_ ? x : y;
    const fixed_ball& b = x.size_ >= y.size_ ? y : x;
    fixed_ball z(x.n_);
    z.size_ = a.size_;
    const mp_limb_t carry = mpn_add(z.limbs_.data(), a.limbs_.data(), a.size_, b.limbs_.data(), b.size_);
    if (carry != 0) {
        fixed_ball::require(z.size_ <= z.n_);
        z.limbs_[static_cast<std::size_t>(z.size_++)] = carry;
    }
    z.radius_ = (x.radius_ + y.radius_) * fixed_ball::slack();
    return z;
}

inline fixed_ball operator-(const fixed_ball& x, const fixed_ball& y) {
    fixed_ball z(x.n_);
    fixed_ball::require(x.size_ >= y.size_);
    const mp_limb_t borrow = mpn_sub(z.limbs_.data(), x.limbs_.data(), x.size_, y.limbs_.data(), y.size_);
    fixed_ball::require(borrow == 0);
    z.take(x.size_);
    z.radius_ = (x.radius_ + y.radius_) * fixed_ball::slack();
    return z;
}

inline fixed_ball operator*(const fixed_ball& x, const fixed_ball& y) {
    fixed_ball z(x.n_);
    fixed_ball::words w;
    const int size = fixed_ball::product(w, x, y);
    z.take(w.data() + z.n_, size - z.n_);
    z.radius_ = fixed_ball::and_cut(fixed_ball::product_radius(x, y));
    return z;
}

inline fixed_ball operator/(const fixed_ball& x, const fixed_ball& y) {
    fixed_ball::require(y.divides());
    fixed_ball z(x.n_);
    fixed_ball::words w;
    fixed_ball::words quotient;
    std::array<mp_limb_t, fixed_ball::most_limbs + 2> rest;
    const int size = x.size_ == 0 ? 0 : x.size_ + x.n_;
    if (size >= y.size_) {
        std::fill_n(w.begin(), x.n_, mp_limb_t{0});
        std::copy_n(x.limbs_.begin(), x.size_, w.begin() + x.n_);
        mpn_tdiv_qr(quotient.data(), rest.data(), 0, w.data(), size, y.limbs_.data(), y.size_);
        z.take(quotient.data(), size - y.size_ + 1);
    }
    z.radius_ = fixed_ball::and_cut((x.radius_ + z.above() * y.radius_) / y.below());
    return z;
}

/// sqrt(x y), from the full product.
inline fixed_ball geometric_mean(const fixed_ball& x, const fixed_ball& y) {
    fixed_ball z(x.n_);
    fixed_ball::words w;
    std::array<mp_limb_t, fixed_ball::most_limbs + 2> root;
    const int size = fixed_ball::significant(w, fixed_ball::product(w, x, y));
    fixed_ball::require(size > 0);
    mpn_sqrtrem(root.data(), nullptr, w.data(), size);
    z.take(root.data(), (size + 1) / 2);
    const double product = fixed_ball::product_radius(x, y);
    const double lower = x.below() * y.below();
    fixed_ball::require(x.divides() && y.divides() && product <= lower * (fixed_ball::limb() / 1024));
    z.radius_ = fixed_ball::and_cut(product / z.below() * 513 / 1024);
    return z;
}

inline fixed_ball ldexp(const fixed_ball& x, int k) {
    fixed_ball z(x.n_);
    if (x.size_ > 0 && k > 0) {
        const mp_limb_t carry = mpn_lshift(z.limbs_.data(), x.limbs_.data(), x.size_, static_cast<unsigned>(k));
        z.size_ = x.size_;
        if (carry != 0) {
            fixed_ball::require(z.size_ <= z.n_);
            z.limbs_[static_cast<std::size_t>(z.size_++)] = carry;
        }
    } else if (x.size_ > 0) {
        mpn_rshift(z.limbs_.data(), x.limbs_.data(), x.size_, static_cast<unsigned>(-k));
        z.take(x.size_);
    }
    const auto factor = static_cast<double>(1UL << static_cast<unsigned>(std::abs(k)));
    z.radius_ = k > 0 ? x.radius_ * factor : fixed_ball::and_cut(x.radius_ / factor);
    return z;
}

inline fixed_ball fixed_ball::root_of_half(int n, const rational& q) {
    fixed_ball z(n);
    words w;
    std::array<mp_limb_t, most_limbs + 2> root;
    const auto* above = mpq_numref(q.backend().data());
    const auto* below = mpq_denref(q.backend().data());
    int size = 2 * n + 1;
    if (mpz_size(above) == 1 && mpz_size(below) == 1) {
        words shifted;
        std::fill_n(shifted.begin(), 2 * n, mp_limb_t{0});
        shifted[2 * static_cast<std::size_t>(n)] = mpz_getlimbn(above, 0);
        mpn_divrem_1(w.data(), 0, shifted.data(), size, mpz_getlimbn(below, 0));
    } else {
        const integer quotient = (numerator(q) << static_cast<unsigned>(2 * z.bits())) / denominator(q);
        const auto* digits = quotient.backend().data();
        size = static_cast<int>(mpz_size(digits));
        require(size <= 2 * n + 2);
        std::copy_n(mpz_limbs_read(digits), size, w.begin());
    }
    require(size > 0);
    mpn_rshift(w.data(), w.data(), size, 1);
    size = significant(w, size);
    require(size > 0);
    mpn_sqrtrem(root.data(), nullptr, w.data(), size);
    z.take(root.data(), (size + 1) / 2);
    z.radius_ = 1;
    return z;
}

}  // namespace libration
