// The lattice of singularities as points of the complex t-plane, relative to the top.
#pragma once

#include <vector>

#include "libration/pendulum/singularities.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration::pendulum {

/// The odd multiple of `step` > 0 that is nearest to x >= 0.
template <rounding_scalar T>
T nearest_odd_multiple(const T& x, const T& step) {
    const integer below = nearest_integer(widen(T((x / step - 1) / 2)));
    return step * from_rational<T>(rational(below < 0 ? integer(1) : integer(below * 2 + 1)));
}

/// The singularity nearest to a time since the top with re, im >= 0: odd multiples of T* and of K~'.
template <rounding_scalar T>
complex_number<T> nearest_singularity(const singularity_lattice<T>& lattice, const complex_number<T>& time) {
    return {nearest_odd_multiple(time.re, lattice.effective_period), nearest_odd_multiple(time.im, lattice.height)};
}

/// The odd multiples of `step` from -reach to reach, by size.
template <rounding_scalar T>
std::vector<T> odd_multiples(const T& step, const T& reach) {
    std::vector<T> all;
    for (int n = 1; step * n <= reach; n += 2) {
        all.insert(all.begin(), -step * n);
        all.insert(all.end(), step * n);
    }
    return all;
}

/// All singularities in the rectangle |re| <= width, |im| <= height about the top: columns from left to right, each
/// from below. Not for the separatrix.
template <rounding_scalar T>
std::vector<complex_number<T>> lattice_points(const singularity_lattice<T>& lattice, const T& width, const T& height) {
    const std::vector<T> heights = odd_multiples(lattice.height, height);
    std::vector<complex_number<T>> points;
    for (const T& re : odd_multiples(lattice.effective_period, width)) {
        for (const T& im : heights) {
            points.push_back({re, im});
        }
    }
    return points;
}

}  // namespace libration::pendulum
