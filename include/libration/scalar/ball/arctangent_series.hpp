// The arctangent of small balls.
//
// arctan r = r sum_{j<N} (-r^2)^j/(2j+1), alternating with decreasing terms: the remainder is below r^(2N)/(2N+1). By
// powers up to m and Horner's rule in the last of them [BrentZimmermann, 4.4.3], each to the bits that it needs.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// arctan r of a ball within (-1/2, 1/2), to this number of relative bits, or by the given number of terms, at least 1.
/// Cost: about 2 sqrt N products, N = bits/(2 log2 1/|r|).
class small_arctangent {
public:
    small_arctangent(const ball& r, slong bits, std::optional<slong> terms = {})
        : bits_(bits),
          small_(2 * std::clamp(-binary_exponent(r), long{1}, static_cast<long>(bits))),
          terms_(terms.value_or(bits / small_ + 1)) {
        while (2 * block_ * block_ < terms_) {
            block_ += 2;
        }
        set_powers(r);
        ball sum;
        for (slong first = (terms_ - 1) / block_ * block_; first >= 0; first -= block_) {
            const slong bits_here = to(first);
            arb_mul(sum.handle(), sum.handle(), power(block_), to(first + block_));
            for (slong i = first; i < std::min(first + block_, terms_);) {
                i = add_some(sum, i, first, bits_here);
            }
        }
        arb_add_error_2exp_si(sum.handle(), -small_ * terms_);
        arb_mul(value_.handle(), sum.handle(), r.handle(), bits);
    }
    const ball& value() const { return value_; }

private:
    // Bits needed in the factor of (r^2)^i.
    slong to(slong i) const { return std::max(bits_ - small_ * i, slong{32}); }
    arb_srcptr power(slong i) const { return powers_[static_cast<std::size_t>(i)].handle(); }

    // (-r^2)^i up to the length of a block.
    void set_powers(const ball& r) {
        const slong most = std::min(block_, terms_);
        powers_.reserve(static_cast<std::size_t>(block_) + 1);
        powers_.emplace_back(1);
        for (slong i = 1; i <= block_; ++i) {
            powers_.emplace_back();
            ball& next = powers_.back();
            if (i == 1) {
                arb_mul(next.handle(), r.handle(), r.handle(), to(1));
                arb_neg(next.handle(), next.handle());
            } else if (i <= most) {
                arb_mul(next.handle(), power(i / 2), power(i - i / 2), to(i));
            }
        }
    }

    // Adds terms from i on in one dot product, over the product of their denominators while that is below 2^63; returns
    // the index after the last one.
    slong add_some(ball& sum, slong i, slong first, slong bits_here) const {
        std::array<ulong, 8> weights{};
        const slong end = std::min({first + block_, terms_, i + slong{8}});
        ulong common = 1;
        slong behind = i;
        for (; behind < end && denominator(behind) < std::numeric_limits<ulong>::max() / 2 / common; ++behind) {
            common *= denominator(behind);
        }
        for (slong j = i; j < behind; ++j) {
            weights[static_cast<std::size_t>(j - i)] = common / denominator(j);
        }
        ball part;
        const slong bits_of_part = to(i);
        arb_dot_ui(part.handle(), nullptr, 0, power(i - first), 1, weights.data(), 1, behind - i, bits_of_part);
        arb_div_ui(part.handle(), part.handle(), common, bits_of_part);
        arb_add(sum.handle(), sum.handle(), part.handle(), bits_here);
        return behind;
    }
    static ulong denominator(slong j) { return 2 * static_cast<ulong>(j) + 1; }

    slong bits_;
    slong small_;  ///< r^2 < 2^-small
    slong terms_;
    slong block_ = 2;
    std::vector<ball> powers_;
    ball value_;
};

}  // namespace libration
