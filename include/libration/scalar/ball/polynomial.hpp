// Products and quotients of whole sequences of balls by FLINT [Arb]: in blocks of similar size through products of
// large integers, where one coefficient after the other would take O(N^2) products.
#pragma once

#include <mpfr.h>  // before FLINT 3, which declares conversions to mpfr only behind it

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

#include <algorithm>
#include <vector>

#include "libration/scalar/ball/value.hpp"

namespace libration {

/// c_n = sum_k a_k b_{n-k} for n below the shorter length, which is not 0. Within a block the radii are those of the
/// largest coefficients: far smaller ones beside them lose their relative precision. About the
/// cost of O(N) products for long sequences at many digits; short ones are multiplied as they are written.
inline std::vector<ball> whole_product(const std::vector<ball>& a, const std::vector<ball>& b) {
    static_assert(sizeof(ball) == sizeof(arb_struct), "FLINT walks through an array of balls");
    std::vector<ball> c(std::min(a.size(), b.size()));
    const auto count = static_cast<slong>(c.size());
    _arb_poly_mullow(c.front().handle(), a.front().handle(), count, b.front().handle(), count, count,
                     ball::working_bits());
    return c;
}

/// q with sum_k b_k q_{n-k} = a_n for n below the shorter length, which is not 0: by Newton's iteration for long
/// sequences, whose radii grow by a power of N. Contains everything where b_0 may be 0. The cost of a few products.
inline std::vector<ball> whole_quotient(const std::vector<ball>& a, const std::vector<ball>& b) {
    static_assert(sizeof(ball) == sizeof(arb_struct), "FLINT walks through an array of balls");
    std::vector<ball> q(std::min(a.size(), b.size()));
    const auto count = static_cast<slong>(q.size());
    _arb_poly_div_series(q.front().handle(), a.front().handle(), count, b.front().handle(), count, count,
                         ball::working_bits());
    return q;
}

}  // namespace libration
