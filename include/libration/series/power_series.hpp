// Truncated power series: index = degree, a series of order N has the coefficients of degrees 0 .. N.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::series {

/// sum_{n=0}^{N} a_n x^n, with all terms beyond x^N dropped. N >= 0. Over any ring, including fractions and complex
/// numbers.
template <ring T>
class power_series {
public:
    power_series() : coefficients_{T(0)} {}
    explicit power_series(std::vector<T> coefficients) : coefficients_(std::move(coefficients)) {
        if (coefficients_.empty()) {
            throw error(error_kind::argument, "list of coefficients", "",
                        "is empty: a power series has at least the coefficient of degree 0");
        }
    }

    /// The zero series of order N. Throws error if N < 0.
    static power_series zero(int order) {
        if (order < 0) {
            throw error(error_kind::argument, "order", std::to_string(order), "of a power series is negative");
        }
        return power_series(std::vector<T>(static_cast<std::size_t>(order) + 1, T(0)));
    }

    int order() const { return static_cast<int>(coefficients_.size()) - 1; }
    const T& operator[](int n) const { return coefficients_[static_cast<std::size_t>(n)]; }
    T& operator[](int n) { return coefficients_[static_cast<std::size_t>(n)]; }
    /// Appends the coefficient of the next degree.
    void push_back(T next) { coefficients_.push_back(std::move(next)); }
    const std::vector<T>& coefficients() const { return coefficients_; }
    /// The same as an array, for the kernels.
    const T* data() const { return coefficients_.data(); }
    T* data() { return coefficients_.data(); }

    /// The first degrees 0 .. N of this series. Throws error if it has fewer.
    power_series truncated(int order) const {
        if (order < 0 || order > this->order()) {
            throw error(error_kind::argument, "order", std::to_string(order),
                        "is not between 0 and the order of the series, " + std::to_string(this->order()));
        }
        return power_series(std::vector<T>(coefficients_.begin(), coefficients_.begin() + order + 1));
    }

private:
    std::vector<T> coefficients_;
};

/// The series in y = x / factor: a_n factor^n. One rounding per power, O(N).
template <ring T>
power_series<T> rescale(power_series<T> series, const T& factor) {
    T power(1);
    for (int n = 1; n <= series.order(); ++n) {
        power *= factor;
        series[n] *= power;
    }
    return series;
}

}  // namespace libration::series
