// Values of long polynomials by inner products, for arithmetic in which those are cheaper than the steps of Horner's
// rule.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

#include "libration/series/convolution.hpp"
#include "libration/series/jet.hpp"

namespace libration::series {

/// A polynomial cut into blocks of M successive powers, sum_j x^(j M) sum_{i<M} a_{jM+i} x^i: the inner sums are inner
/// products with the powers of x below M, the outer one Horner's rule in x^M [PatersonStockmeyer]. O(N) terms of inner
/// products and O(M + N/M) products.
template <ring T>
class polynomial_blocks {
public:
    /// Whether this is the method for evaluating this polynomial at x: in mpfr from order 8 on, provided everything is
    /// in the working precision, which is that of inner products.
    static bool serve(const power_series<T>& a, const T& x) {
        if constexpr (std::same_as<T, mpfr>) {
            const auto fits = [](const mpfr& y) {
                return mpfr_get_prec(handle(y)) <= static_cast<mpfr_prec_t>(scalar_traits<mpfr>::digits());
            };
            return a.order() >= 8 && fits(x) && fits(a[0]) && fits(a[a.order()]);
        } else {
            return false;
        }
    }

    polynomial_blocks(const power_series<T>& a, const T& x) : a_(a) {
        while (2 * length_ * length_ < 3 * (a.order() + 1)) {
            ++length_;
        }
        powers_.reserve(static_cast<std::size_t>(length_) + 1);
        powers_.push_back(T(1));
        for (int i = 1; i <= length_; ++i) {
            powers_.push_back(powers_.back() * x);
        }
    }

    T value() const {
        int begin = last_block();
        T sum = value_of_block(begin);
        while (begin > 0) {
            begin -= length_;
            T next = value_of_block(begin);
            add_product(next, sum, powers_.back());
            sum = std::move(next);
        }
        return sum;
    }

    jet<T> value_and_slope() const {
        std::vector<T> slopes;
        slopes.reserve(powers_.size());
        for (int i = 1; i <= length_; ++i) {
            slopes.push_back(powers_[static_cast<std::size_t>(i) - 1] * i);
        }
        int begin = last_block();
        jet<T> sum{value_of_block(begin), slope_of_block(begin, slopes)};
        while (begin > 0) {
            begin -= length_;
            T slope = slope_of_block(begin, slopes);
            add_product(slope, sum.slope, powers_.back());
            add_product(slope, sum.value, slopes.back());
            T value = value_of_block(begin);
            add_product(value, sum.value, powers_.back());
            sum = {std::move(value), std::move(slope)};
        }
        return sum;
    }

private:
    int last_block() const { return a_.order() / length_ * length_; }
    int terms_from(int begin) const { return std::min(length_, a_.order() + 1 - begin); }

    T value_of_block(int begin) const {
        return inner_product(a_.data() + begin, 1, powers_.data(), 1, terms_from(begin));
    }
    T slope_of_block(int begin, const std::vector<T>& slopes) const {
        return inner_product(a_.data() + begin + 1, 1, slopes.data(), 1, terms_from(begin) - 1);
    }

    const power_series<T>& a_;
    int length_ = 1;         ///< M, about (3/2 N)^(1/2): blocks are more expensive than powers
    std::vector<T> powers_;  ///< x^i, i <= M
};

}  // namespace libration::series
