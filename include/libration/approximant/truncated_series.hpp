// A partial sum of a Taylor series as a function: sigma_N(t) = sum_{n=0}^{N} A_n (t/scale)^n.
#pragma once

#include <utility>

#include "libration/series/arithmetic.hpp"

namespace libration {

/// The series is stored in the scaled variable x = t/scale, because a_n = A_n / scale^n leaves the range of double long
/// before A_n does; with a scale close to the radius of convergence, A_n stays between powers of n.
template <scalar T>
class truncated_series {
public:
    truncated_series(series::power_series<T> scaled, T scale) : scaled_(std::move(scaled)), scale_(std::move(scale)) {}

    int order() const { return scaled_.order(); }
    const series::power_series<T>& scaled() const { return scaled_; }
    const T& scale() const { return scale_; }

    /// Value and derivative with respect to t. O(N).
    series::jet<T> operator()(const T& t) const {
        series::jet<T> at = evaluate(scaled_, T(t / scale_));
        at.slope /= scale_;
        return at;
    }

    /// The value alone, computed as in operator() at half the cost.
    T value(const T& t) const { return evaluate_value(scaled_, T(t / scale_)); }

private:
    series::power_series<T> scaled_;
    T scale_;
};

}  // namespace libration
