// Products of polynomials with integer coefficients by FLINT, avoiding the operands for which FLINT's are wrong.
//
// Up to FLINT 3.6.0, _fmpz_vec_set_fft determines the sign of a coefficient of a product from the top two limbs of its
// value v modulo 2^N + 1, N a multiple of 64: negative if v >= 2^N or if the limb of 2^(N-64) is above 2^63. A
// coefficient c < 0 is v = 2^N + 1 - |c| there, so that it is taken for a positive one if |c| > 2^(N-1) - 2^(N-64)
// (FLINT pull request 2790; Arb's products and quotients of polynomials are affected). near_transform_bound() excludes
// this before the product:
//
// Theorem. Let all |a_k| < 2^s, |b_k| < 2^t, let L be the smaller number of terms, l = ceil(log2 L), and let
// _fmpz_poly_mullow_SS multiply them. If all coefficients are >= 0, or if s + t + l + 1 is not a multiple of 64, then
// all coefficients are correct.
// Proof. A coefficient c is a sum of at most L products, |c| < L 2^(s+t) <= 2^(s+t+l). FLINT takes N >= s + t + l + e,
// a multiple of 64, where e = 1 if some a_k or b_k is negative and e = 0 otherwise (mul_SS.c, mullow_SS.c, and
// mulmid_SS.c of FLINT 3.6 with the same sizes; further roundings of N only enlarge it). If e = 0, then 0 <= c < 2^N is
// v itself and is copied. If e = 1 and s + t + l + 1 is not a multiple of 64, then N >= s + t + l + 2 and |c| <
// 2^(N-2): for c >= 0 the limb of 2^(N-64) is below 2^62 and v < 2^N; for c = -1, v = 2^N; for c < -1, v > 2^N -
// 2^(N-2), whose limb of 2^(N-64) is at least 3 2^62 > 2^63. Both signs are recognized. []
//
// The other algorithms of _fmpz_poly_mullow have no such bound: the classical one, Karatsuba's, and Kronecker
// substitution, which reads the coefficients from a product of two integers in fields of s + t + 1 + floor(log2 L) + e
// bits, |c| < 2^(s+t+l) (mullow_KS.c, bit_unpack.c).
#pragma once

#include <mpfr.h>  // before FLINT 3, which declares conversions to mpfr only if this is included first

#include <flint/fmpz.h>

#include <cstddef>
#include <vector>

namespace libration {

/// An array of FLINT integers, initially 0.
class integer_vector {
public:
    explicit integer_vector(std::size_t size) : values_(size, 0) {}
    integer_vector(integer_vector&&) = default;
    integer_vector(const integer_vector&) = delete;
    integer_vector& operator=(const integer_vector&) = delete;
    integer_vector& operator=(integer_vector&&) = delete;
    ~integer_vector() {
        for (fmpz& each : values_) {
            fmpz_clear(&each);
        }
    }
    std::size_t size() const { return values_.size(); }
    fmpz* data() { return values_.data(); }
    const fmpz* data() const { return values_.data(); }
    fmpz& operator[](std::size_t i) { return values_[i]; }
    const fmpz& operator[](std::size_t i) const { return values_[i]; }

private:
    std::vector<fmpz> values_;
};

/// Sets c_n = sum_k a_k b_{n-k} for 0 <= n < count: a has a_terms, b has b_terms coefficients, c has space for count,
/// all these numbers are at least 1, and c overlaps neither a nor b. a and b may be the same array, also with different
/// numbers of terms.
using integer_product = void (*)(fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms, slong count);

/// Whether the theorem above does not exclude a wrong coefficient of _fmpz_poly_mullow_SS: a negative coefficient
/// occurs in a or b, and s + t + ceil(log2(the smaller number of terms)) + 1 is a multiple of 64, s and t the bits of
/// the largest |a_k| and |b_k|. True for one in 64 pairs of random operands.
bool near_transform_bound(const fmpz* a, slong a_terms, const fmpz* b, slong b_terms);

/// The product by a FLINT function, which is given the longer operand first and no more coefficients than exist. In a
/// product_check_scope it is checked, and product_mismatch is thrown if it is wrong.
void checked_product(integer_product by, fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms,
                     slong count);

/// checked_product() by _fmpz_poly_mullow, or by _fmpz_poly_mullow_KS if near_transform_bound() holds for the
/// coefficients below count.
void guarded_product(fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms, slong count);

}  // namespace libration
