// The root test: a radius of convergence from the size of coefficients alone.
#pragma once

#include <stdexcept>
#include <string>

#include "libration/series/power_series.hpp"

namespace libration {

/// The least |a_n|^(-1/n) of the last four n, in the unit of the variable; four, because symmetries leave only every
/// second or fourth coefficient. Its error falls like log(n)/n, the coefficients being R^-n times a power of n. O(1).
/// Throws std::domain_error below order 4, or where all four are 0.
template <rounding_scalar T>
T radius_by_root_test(const power_series<T>& a) {
    using std::abs;
    using std::pow;
    if (a.order() < 4) {
        throw std::domain_error("the root test of a series of order " + std::to_string(a.order()));
    }
    T largest(0);
    for (int n = a.order() - 3; n <= a.order(); ++n) {
        const T root = a[n] == 0 ? T(0) : T(pow(T(abs(a[n])), T(1) / n));
        largest = root > largest ? root : largest;
    }
    if (largest == 0) {
        throw std::domain_error("the root test of four coefficients 0");
    }
    return 1 / largest;
}

}  // namespace libration
