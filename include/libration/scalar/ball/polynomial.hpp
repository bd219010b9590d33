// Products and quotients of whole sequences of balls: in blocks of similar size through products of integer polynomials
// (integer_product.hpp), where computing the coefficients one by one would take O(N^2) products.
// The numbers of (x +- r)(y +- s) are within |x| s + r (|y| + s) of x y: so midpoints are multiplied exactly, and the
// radii are sums of these bounds.
#pragma once

#include <vector>

#include "libration/scalar/ball/value.hpp"

namespace libration {

/// c_n = sum_k a_k b_{n-k} for n < count, where a has a_terms and b has b_terms coefficients, at least one each;
/// rounded to this number of bits. Every ball contains the exact sums. For up to 4096 coefficients the radii exceed
/// those of the explicit sums by a factor of at most 1 + 2^-19, and by one rounding per pair of blocks. For longer
/// sequences w = ceil(count / 4096) neighbours at a time share the largest of their radii, relative to one geometric
/// sequence.
///
/// Short sequences (of less than 20 to 96 coefficients, depending on the bits), those with non-finite numbers, and
/// those with exponents beyond 2^28 are summed directly, with one rounding. Otherwise the coefficients, divided by a
/// geometric sequence 2^(scale n), are cut into blocks in which all midpoints are integers below 2^(3 bits + 512) times
/// one power of 2, as in Arb's _arb_poly_mullow_block [Arb]; each pair of blocks costs one product of integer
/// polynomials. Throws product_mismatch if the self-test of these failed (product_self_test.hpp).
std::vector<ball> leading_product(const ball* a, int a_terms, const ball* b, int b_terms, int count, slong bits);

/// leading_product() for n below the shorter length, which is nonzero, in the working precision.
std::vector<ball> whole_product(const std::vector<ball>& a, const std::vector<ball>& b);

/// q with sum_k b_k q_{n-k} = a_n for n below the shorter length N, which is nonzero. Unbounded if b_0 may be 0. Up to
/// 16 coefficients by the recurrence; for longer ones by Newton's iteration [BrentZimmermann, 3.4 and 4.2]. With v of m
/// terms and b v = 1 + x^m w, the next terms of 1/b are those of -v w modulo x^m; with q of m >= N/2 terms and a - b q
/// = x^m d, the next terms of a/b are those of v d. Both are identities of formal power series, which hold for each
/// choice of numbers in the balls a_k and b_k with the corresponding v, w, q and d; their balls are computed from balls
/// that contain v, w, q and d, so they contain the next terms, without truncation error. The radii grow by a power of
/// N. Cost: a few products.
std::vector<ball> whole_quotient(const std::vector<ball>& a, const std::vector<ball>& b);

}  // namespace libration
