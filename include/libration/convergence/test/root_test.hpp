// The root test: a radius of convergence from the size of coefficients only.
//
// |a_n|^(-1/n) -> R along the largest coefficients, whatever the singularities are (Cauchy and Hadamard). For a_n ~ A
// n^(-nu-1) R^-n the error of the logarithm is ((nu + 1) log n - log A)/n; that of |n a_n|^(-1/n) is (nu log n - log
// A)/n, only O(1/n) for a logarithm, nu = 0. Also works for lacunary series; its only weakness is slow convergence.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/settling.hpp"
#include "libration/convergence/strided_series.hpp"
#include "libration/scalar/error.hpp"

namespace libration::convergence {

/// The smallest |a_n|^(-1/n) of the last four n, in units of the variable; four, because symmetries leave only every
/// second or fourth coefficient. Its error falls like log(n)/n, the coefficients being R^-n times a power of n. O(1).
/// Throws error below order 4, or if all four are 0.
template <rounding_scalar T>
T radius_by_root_test(const series::power_series<T>& a) {
    using std::abs;
    using std::pow;
    if (a.order() < 4) {
        throw error(error_kind::argument, "order", std::to_string(a.order()), "is below 4, which the root test needs");
    }
    T largest(0);
    for (int n = a.order() - 3; n <= a.order(); ++n) {
        const T root = a[n] == 0 ? T(0) : T(pow(T(abs(a[n])), T(1) / n));
        largest = root > largest ? root : largest;
    }
    if (largest == 0) {
        throw error(error_kind::argument, "coefficients", "",
                    "are 0: the root test needs one of the last four to be nonzero");
    }
    return 1 / largest;
}

/// The size of a nonzero coefficient.
template <rounding_scalar T>
struct coefficient_size {
    int n;
    T log_size;  ///< log |a_n|
};

/// The sizes of the nonzero coefficients from n = 1 on. O(N).
template <rounding_scalar T>
std::vector<coefficient_size<T>> sizes_of(const strided_series<T>& c) {
    using std::abs;
    using std::log;
    std::vector<coefficient_size<T>> sizes;
    sizes.reserve(static_cast<std::size_t>(c.last()) + 1);
    for (int k = 0; k <= c.last(); ++k) {
        if (c.power(k) > 0 && c[k] != 0) {
            sizes.push_back({c.power(k), T(log(abs(c[k])))});
        }
    }
    return sizes;
}

namespace fitting {

/// Number of nonzero coefficients that tests of their size require.
inline constexpr int fewest_sizes = 6;

/// The largest log|n^p a_n|/n of those with n_end - width < n <= n_end, or of the last one before.
template <rounding_scalar T>
T largest_root(const std::vector<coefficient_size<T>>& sizes, int end, int width, int p) {
    using std::log;
    std::optional<T> largest;
    for (std::size_t i = sizes.size(); i-- > 0 && !(largest && sizes[i].n <= end - width);) {
        if (sizes[i].n <= end || i == 0) {
            const T root = (sizes[i].log_size + log(T(sizes[i].n)) * p) / sizes[i].n;
            largest = largest && *largest > root ? *largest : root;
        }
    }
    return *largest;
}

/// The root of the largest of the last eight, compared with the results from the first three quarters, the first half
/// and the first quarter of the list.
template <rounding_scalar T>
radius_estimate<T> estimate_by_roots(const std::string& method, const strided_series<T>& c, int p) {
    using std::abs;
    using std::exp;
    constexpr int safety = 2;
    constexpr int coefficients = 8;
    const auto sizes = sizes_of(c);
    if (static_cast<int>(sizes.size()) < fewest_sizes) {
        return too_short<T>(method, fewest_sizes, static_cast<int>(sizes.size()));
    }
    const int end = sizes.back().n;
    const int width = std::min(coefficients * c.stride(), end / 4);
    radius_estimate<T> result;
    result.method = method;
    const T radius = exp(-largest_root(sizes, end, width, p));
    T moved(0);
    for (const int fewer : {end / 4 * 3, end / 2, end / 4}) {
        const T other = exp(-largest_root(sizes, fewer, width, p));
        moved = abs(other - radius) > moved ? T(abs(other - radius)) : moved;
    }
    result.radius = radius;
    result.uncertainty = moved * safety + radius * epsilon<T>() * (safety * safety);
    return if_settled(std::move(result));
}

}  // namespace fitting

/// |a_n|^(-1/n). The uncertainty is twice the largest difference from the results of three quarters, a half and a
/// quarter of the list. Needs six nonzero coefficients. O(N).
template <rounding_scalar T>
radius_estimate<T> root_test(const strided_series<T>& c) {
    return fitting::estimate_by_roots("root", c, 0);
}

/// |n a_n|^(-1/n), otherwise as the root test.
template <rounding_scalar T>
radius_estimate<T> corrected_root_test(const strided_series<T>& c) {
    return fitting::estimate_by_roots("root-corrected", c, 1);
}

}  // namespace libration::convergence
