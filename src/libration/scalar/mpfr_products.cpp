// Sums of products of MPFR numbers in fixed point: a loop of mpfr_fma aligns, rounds and normalises
// every term, this only the sum.
#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "libration/scalar/mpfr_traits.hpp"

namespace libration {

namespace {

constexpr int limb_bits = GMP_NUMB_BITS;

// Bits that the sum has below the rounding of its largest product.
constexpr int guard_bits = 32;

// |x| = 0.limbs 2^exponent, the last limb the highest.
struct significand {
    const mp_limb_t* limbs;
    mp_size_t size;

    // Without low zero limbs, which integers and values of lower precision have.
    explicit significand(const mpfr& x)
        : limbs(static_cast<const mp_limb_t*>(mpfr_custom_get_significand(handle(x)))),
          size((mpfr_get_prec(handle(x)) - 1) / limb_bits + 1) {
        while (size > 1 && *limbs == 0) {
            ++limbs;
            --size;
        }
    }
    void keep_highest(mp_size_t count) {
        if (size > count) {
            limbs += size - count;
            size = count;
        }
    }
};

// Memory for this number of limbs, on the stack if they are few.
class limb_buffer {
public:
    explicit limb_buffer(mp_size_t size) : far_(size > few ? static_cast<std::size_t>(size) : 0) {
        data_ = far_.empty() ? near_.data() : far_.data();
    }
    limb_buffer(const limb_buffer&) = delete;
    limb_buffer& operator=(const limb_buffer&) = delete;
    ~limb_buffer() = default;
    mp_limb_t* data() { return data_; }

private:
    static constexpr mp_size_t few = 64;
    std::array<mp_limb_t, few> near_;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
    std::vector<mp_limb_t> far_;
    mp_limb_t* data_;
};

// A fixed-point number, below 2^(top + limb_bits - 1), of `size` limbs below 2^top; in two's complement.
class fixed_sum {
public:
    fixed_sum(mpfr_exp_t top, mp_size_t size) : top_(top), size_(size), sum_(size + 1), product_(2 * size + 5) {
        mpn_zero(sum_.data(), size_ + 1);
    }

    // Adds x y, 0 < |x y| < 2^top, without the part below two units of the last place.
    void add(const mpfr& x, const mpfr& y) {
        const auto down = static_cast<mp_size_t>(top_ - mpfr_get_exp(handle(x)) - mpfr_get_exp(handle(y)));
        const mp_size_t reached = size_ - down / limb_bits;
        if (reached <= 0) {
            return;
        }
        significand a(x);
        significand b(y);
        a.keep_highest(reached + 1);
        b.keep_highest(reached + 1);
        // One zero limb below the product, so that no bit of it is lost to the shift.
        mp_limb_t* const product = product_.data();
        product[0] = 0;
        multiply(product + 1, a, b);
        const mp_size_t size = a.size + b.size + 1;
        if (const auto shift = static_cast<unsigned>(down % limb_bits); shift > 0) {
            mpn_rshift(product, product, size, shift);
        }
        const mp_size_t taken = std::min(size, reached);
        const bool negative = (mpfr_sgn(handle(x)) < 0) != (mpfr_sgn(handle(y)) < 0);
        accumulate(product + (size - taken), taken, reached, negative);
    }

    // Rounded to the precision of the result.
    void round_to(mpfr& result) {
        mp_limb_t* const limbs = sum_.data();
        const bool negative = (limbs[size_] >> (limb_bits - 1)) != 0;
        if (negative) {
            mpn_neg(limbs, limbs, size_ + 1);
        }
        mpz_t whole;
        mpz_srcptr const view = mpz_roinit_n(whole, limbs, negative ? -(size_ + 1) : size_ + 1);
        mpfr_set_z_2exp(handle(result), view, top_ - limb_bits * size_, MPFR_RNDN);
    }

private:
    static void multiply(mp_limb_t* product, const significand& a, const significand& b) {
        if (a.limbs == b.limbs && a.size == b.size) {
            mpn_sqr(product, a.limbs, a.size);
        } else if (a.size >= b.size) {
            mpn_mul(product, a.limbs, a.size, b.limbs, b.size);
        } else {
            mpn_mul(product, b.limbs, b.size, a.limbs, a.size);
        }
    }

    // Adds or subtracts `count` limbs, the highest of them at position `end` - 1.
    void accumulate(const mp_limb_t* limbs, mp_size_t count, mp_size_t end, bool negative) {
        mp_limb_t* const low = sum_.data() + (end - count);
        mp_limb_t* const high = sum_.data() + end;
        const mp_size_t above = size_ + 1 - end;
        if (negative) {
            mpn_sub_1(high, high, above, mpn_sub_n(low, low, limbs, count));
        } else {
            mpn_add_1(high, high, above, mpn_add_n(low, low, limbs, count));
        }
    }

    mpfr_exp_t top_;
    mp_size_t size_;
    limb_buffer sum_;
    limb_buffer product_;
};

// The smallest t with every |x y| < 2^t; std::nullopt if all products are 0.
struct size_of_terms {
    std::optional<mpfr_exp_t> top;
    bool finite = true;
};

size_of_terms size_of(const mpfr* x, int x_step, const mpfr* y, int y_step, int count) {
    size_of_terms size;
    for (int i = 0; i < count; ++i) {
        mpfr_srcptr const a = handle(x[i * x_step]);
        mpfr_srcptr const b = handle(y[i * y_step]);
        if (mpfr_regular_p(a) != 0 && mpfr_regular_p(b) != 0) {
            const mpfr_exp_t exponent = mpfr_get_exp(a) + mpfr_get_exp(b);
            size.top = std::max(size.top.value_or(exponent), exponent);
        } else if (mpfr_number_p(a) == 0 || mpfr_number_p(b) == 0) {
            size.finite = false;
        }
    }
    return size;
}

mpfr sum_one_by_one(const mpfr* x, int x_step, const mpfr* y, int y_step, int count) {
    mpfr sum(0);
    for (int i = 0; i < count; ++i) {
        scalar_traits<mpfr>::add_product(sum, x[i * x_step], y[i * y_step]);
    }
    return sum;
}

}  // namespace

mpfr scalar_traits<mpfr>::sum_of_products(const mpfr* x, int x_step, const mpfr* y, int y_step, int count) {
    const size_of_terms size = count > 1 ? size_of(x, x_step, y, y_step, count) : size_of_terms();
    if (!size.top || !size.finite) {
        return sum_one_by_one(x, x_step, y, y_step, count);
    }
    mpfr result;
    const auto bits = static_cast<int>(mpfr_get_prec(handle(result))) + guard_bits +
                      static_cast<int>(std::bit_width(static_cast<unsigned>(count)));
    fixed_sum sum(*size.top, (bits - 1) / limb_bits + 1);
    for (int i = 0; i < count; ++i) {
        const mpfr& a = x[i * x_step];
        const mpfr& b = y[i * y_step];
        if (mpfr_zero_p(handle(a)) == 0 && mpfr_zero_p(handle(b)) == 0) {
            sum.add(a, b);
        }
    }
    sum.round_to(result);
    return result;
}

}  // namespace libration
