// Sums of products over arrays, the single loop used by every convolution, by the best method of each type.
#pragma once

#include "libration/scalar/scalar.hpp"

namespace libration {

/// sum += a * b, with one rounding if the arithmetic has a fused operation.
template <ring R>
void add_product(R& sum, const R& a, const R& b) {
    if constexpr (requires { scalar_traits<R>::add_product(sum, a, b); }) {
        scalar_traits<R>::add_product(sum, a, b);
    } else {
        sum += a * b;
    }
}

/// sum = sum x + next, with the usual two roundings, in place if the arithmetic supports it: one step of Horner's rule.
template <ring R>
void horner_step(R& sum, const R& x, const R& next) {
    if constexpr (requires { scalar_traits<R>::horner_step(sum, x, next); }) {
        scalar_traits<R>::horner_step(sum, x, next);
    } else {
        sum = sum * x + next;
    }
}

/// sum_i x[i x_step] y[i y_step], i < count; on balls with one rounding at the end, in double over neighbours by
/// sum_in_lanes (long double and quad have no vectors). 0 for a count of 0, where arrays may be null. O(count).
template <ring R>
R inner_product(const R* x, int x_step, const R* y, int y_step, int count) {
    if constexpr (requires { scalar_traits<R>::sum_of_products(x, x_step, y, y_step, count); }) {
        return count == 0 ? R(0) : scalar_traits<R>::sum_of_products(x, x_step, y, y_step, count);
    } else {
        R sum(0);
        for (int i = 0; i < count; ++i) {
            add_product(sum, x[i * x_step], y[i * y_step]);
        }
        return sum;
    }
}

}  // namespace libration
