// A pair of conjugate singularities in w = x^stride as the quadratic 1 - s w + d w^2, whose coefficients the pair tests
// determine.
#pragma once

#include <algorithm>
#include <vector>

#include "libration/convergence/strided_series.hpp"

namespace libration::convergence {

/// 1 - s w + d w^2, s = 2 cos(phi)/R, d = 1/R^2 for the roots R e^(+-i phi).
template <rounding_scalar T>
struct pair_quadratic {
    T s;
    T d;

    /// The root of smallest modulus, with im >= 0. d is nonzero.
    complex_number<T> nearest_root() const {
        using std::sqrt;
        const T square = s * s - d * 4;
        if (square < 0) {
            return {T(s / (d * 2)), T(sqrt(-square) / abs_of(T(d * 2)))};
        }
        // The larger of s +- sqrt does not suffer from cancellation.
        const T larger = s < 0 ? T(s - sqrt(square)) : T(s + sqrt(square));
        return {T(2 / larger), T(0)};
    }
    /// Whether the roots are conjugate, with an angle that advances by at least half a circle within k powers of w: a
    /// pair at a smaller angle looks like a single singularity.
    bool conjugate(int k) const {
        const T angle_from_axis = d * 4 - s * s;
        return angle_from_axis * k * k > d * 36;
    }

private:
    static T abs_of(const T& x) {
        using std::abs;
        return abs(x);
    }
};

/// The coefficients of the last three quarters, and six before them, divided by the largest: products of them stay in
/// range.
template <rounding_scalar T>
class scaled_coefficients {
public:
    explicit scaled_coefficients(const strided_series<T>& c) : first_(std::max(0, c.last() / 4 - 6)) {
        using std::abs;
        T largest(0);
        for (int k = first_; k <= c.last(); ++k) {
            largest = abs(c[k]) > largest ? T(abs(c[k])) : largest;
        }
        values_.reserve(static_cast<std::size_t>(c.last() - first_) + 1);
        for (int k = first_; k <= c.last(); ++k) {
            values_.push_back(largest == 0 ? T(0) : T(c[k] / largest));
        }
    }
    int first() const { return first_; }
    int last() const { return first_ + static_cast<int>(values_.size()) - 1; }
    const T& operator[](int k) const { return values_[static_cast<std::size_t>(k - first_)]; }

private:
    int first_;
    std::vector<T> values_;
};

/// Number of coefficients that the pair tests require.
inline constexpr int fewest_for_pairs = 12;

}  // namespace libration::convergence
