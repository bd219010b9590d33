// A point rotated towards the axis by Gaussian primes [Johansson2022].
//
// For integers e_j and the primes p_j of ball_arctangent_table.hpp, with alpha_j = arg p_j and x != 0,
//     x' + i y' = (x + i y) prod conj(p_j)^e_j,   p for conj(p)^-1,
//     arctan(y/x) = sum e_j alpha_j + arctan(y'/x')   mod pi,                                                 (1)
// since a real factor, such as a norm, does not change the angle mod pi; (1+i)^4 = -4 is real too, so the product takes
// e_0 mod 4. The e_j are multiples of relations, subtracted from an arctangent in double one after the other. Nothing
// has to be proved about them: (1) holds for all, they only make y'/x' small.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include "libration/scalar/ball/arctangent_table.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// A point x + i y rotated towards the axis by products of Gaussian primes, and the angle of that rotation, at this
/// number of bits.
class turned_point {
public:
    turned_point(ball y, ball x, slong bits) : y_(std::move(y)), x_(std::move(x)), bits_(bits) {}

    /// By the nearest multiple of each relation in turn, with the sizes of the relations in units of 2^-scale. Cost:
    /// four products by an integer of about 200 bits with the coarse relations, 700 with the fine ones.
    template <std::size_t N>
    void turn(const std::array<angle_relation, N>& relations, int scale) {
        std::int64_t left = angle(scale);
        exponents e{};
        for (const angle_relation& relation : relations) {
            const std::int64_t half = relation.size / 2;
            const std::int64_t times = (left + (left < 0 ? -half : half)) / relation.size;
            left -= times * relation.size;
            for (std::size_t j = 0; j < gaussian_count; ++j) {
                e[j] += times * relation.v[j];
            }
        }
        multiply(e);
        std::transform(e.begin(), e.end(), taken_.begin(), taken_.begin(), std::plus<>());
    }

    /// tan of the remaining angle.
    ball tangent(slong bits) const {
        ball result;
        arb_div(result.handle(), y_.handle(), x_.handle(), bits);
        return result;
    }

    /// sum e_j alpha_j. FLINT stores 2 alpha_j for its cosine, up to 4608 bits in a table, beyond that per thread.
    ball taken() const {
        _arb_atan_gauss_p_ensure_cached(bits_);
        constexpr auto count = static_cast<slong>(gaussian_count);
        ball sum;
        arb_dot_si(sum.handle(), nullptr, 0, _arb_atan_gauss_p_cache_vec(), 1, taken_.data(), 1, count, bits_);
        return ldexp(sum, -1);
    }

    /// Whether the angles stored by FLINT are those of the table, compared on the first 64 bits: a later release might
    /// store others.
    static bool angles_are_known() {
        static_assert(ARB_ATAN_GAUSS_PRIME_CACHE_NUM >= gaussian_count);
        _arb_atan_gauss_p_ensure_cached(slong{64});
        ball angle;
        for (std::size_t j = 0; j < gaussian_count; ++j) {
            const ball slope = ball(gaussian_primes[j][1]) / ball(gaussian_primes[j][0]);
            arb_atan(angle.handle(), slope.handle(), slong{64});
            if (arb_overlaps(ldexp(angle, 1).handle(), _arb_atan_gauss_p_cache_vec() + j) == 0) {
                return false;
            }
        }
        return true;
    }

private:
    using exponents = std::array<slong, gaussian_count>;

    // The approximate angle of the current point, in units 2^-scale; 0 if that is too large for the relations.
    std::int64_t angle(int scale) const {
        const double ratio = arf_get_d(arb_midref(tangent(slong{64}).handle()), ARF_RND_NEAR);
        const double units = std::ldexp(std::atan(ratio), scale);
        return std::fabs(units) < std::ldexp(1, 62) ? static_cast<std::int64_t>(units) : 0;
    }

    // By prod conj(p_j)^e_j. Partial products are flushed when a part reaches 2^57: one more prime keeps it below 2^61.
    void multiply(const exponents& e) {
        ball re(1);
        ball im(0);
        std::int64_t a = 1;
        std::int64_t b = 0;
        for (std::size_t j = 0; j < gaussian_count; ++j) {
            const std::int64_t p = gaussian_primes[j][0];
            const std::int64_t q = e[j] > 0 ? -gaussian_primes[j][1] : gaussian_primes[j][1];
            for (std::int64_t n = j == 0 ? std::abs(e[j]) % 4 : std::abs(e[j]); n > 0; --n) {
                const std::int64_t next = a * p - b * q;
                b = a * q + b * p;
                a = next;
                if (std::max(std::abs(a), std::abs(b)) >> 57U != 0) {
                    multiply(re, im, ball(std::exchange(a, 1)), ball(std::exchange(b, 0)), ARF_PREC_EXACT);
                }
            }
        }
        multiply(re, im, ball(a), ball(b), ARF_PREC_EXACT);
        multiply(x_, y_, re, im, bits_);
    }
    // re + i im times a + i b.
    static void multiply(ball& re, ball& im, const ball& a, const ball& b, slong bits) {
        ball next;
        arb_mul(next.handle(), re.handle(), b.handle(), bits);
        arb_addmul(next.handle(), im.handle(), a.handle(), bits);
        arb_mul(re.handle(), re.handle(), a.handle(), bits);
        arb_submul(re.handle(), im.handle(), b.handle(), bits);
        im = std::move(next);
    }

    ball y_;
    ball x_;
    slong bits_;
    exponents taken_{};
};

}  // namespace libration
