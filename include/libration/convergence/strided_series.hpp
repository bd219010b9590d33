// The part of a power series that remains after symmetry: f(x) = x^first h(x^stride), as coefficients of h.
//
// Ratios of successive coefficients need a series without gaps. In w = x^stride one singularity w0 represents `stride`
// singularities of f on a circle, the roots of x^stride = w0.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/radius_estimate.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/power_series.hpp"

namespace libration::convergence {

/// c_k = a_n with n = first + stride k, k = 0 .. last. 0 <= first, stride >= 1.
template <rounding_scalar T>
class strided_series {
public:
    /// The coefficients in that residue class of indices. Throws error if there are none.
    strided_series(const series::power_series<T>& a, int first, int stride) : first_(first), stride_(stride) {
        if (first < 0 || stride < 1 || first > a.order()) {
            throw error(error_kind::argument, "stride", std::to_string(stride),
                        "from " + std::to_string(first) + " has no coefficients in a series of order " +
                            std::to_string(a.order()));
        }
        for (int n = first; n <= a.order(); n += stride) {
            coefficients_.push_back(a[n]);
        }
    }

    int first() const { return first_; }
    int stride() const { return stride_; }
    int last() const { return static_cast<int>(coefficients_.size()) - 1; }
    /// c_k.
    const T& operator[](int k) const { return coefficients_[static_cast<std::size_t>(k)]; }
    /// The power n of x that c_k belongs to.
    int power(int k) const { return first_ + stride_ * k; }

private:
    int first_;
    int stride_;
    std::vector<T> coefficients_;
};

/// w^(1/stride) for w > 0, to a rounding.
template <rounding_scalar T>
T stride_root(const T& w, int stride) {
    using std::exp;
    using std::log;
    using std::sqrt;
    return stride == 1 ? w : stride == 2 ? T(sqrt(w)) : T(exp(log(w) / stride));
}

/// The root of x^stride = w of smallest argument >= 0; w has im >= 0.
template <rounding_scalar T>
complex_number<T> stride_root(const complex_number<T>& w, int stride) {
    using std::atan2;
    using std::cos;
    using std::sin;
    if (stride == 1 || (w.im == 0 && w.re > 0)) {
        return {stride_root(w.re, stride), w.im};
    }
    if (stride == 2) {
        return square_root(w);
    }
    const T size = stride_root(modulus_of(w), stride);
    const T angle = atan2(w.im, w.re) / stride;
    return {size * cos(angle), size * sin(angle)};
}

/// A radius in w as one in x: R^(1/stride), its relative uncertainty divided by the stride, and `stride` times as many
/// singularities.
template <rounding_scalar T>
radius_estimate<T> in_variable(radius_estimate<T> in_power, int stride) {
    if (in_power.radius && stride > 1) {
        const T radius = stride_root(*in_power.radius, stride);
        in_power.uncertainty *= radius / (*in_power.radius * stride);
        in_power.nearer *= radius / (*in_power.radius * stride);
        in_power.radius = radius;
    }
    if (in_power.position) {
        in_power.position = stride_root(*in_power.position, stride);
    }
    in_power.count *= stride;
    return in_power;
}

}  // namespace libration::convergence
