// The radius of convergence of a series with logarithmic nearest singularities, from a few of its coefficients.
#pragma once

#include <string>

#include "libration/scalar/error.hpp"
#include "libration/series/power_series.hpp"

namespace libration::convergence {

/// Throws error for indices outside the series.
template <scalar T>
void require_terms(const series::power_series<T>& a, int first, int last) {
    if (first < 1 || last > a.order()) {
        throw error(error_kind::argument, "coefficients", std::to_string(first) + " to " + std::to_string(last),
                    "are not in a series of order " + std::to_string(a.order()));
    }
}

/// R if a conjugate pair R e^{+-i phi} is nearest: u_m = n a_n, n = first + m stride, is then a multiple of R^-n sin(n
/// phi + const) and satisfies u_{m+2} = p u_{m+1} - q u_m with q = R^(-2 stride), so
///     q = (u_2^2 - u_1 u_3)/(u_1^2 - u_0 u_2).
/// The stride is 2 for series in even or odd powers, whose singularities come in opposite pairs. Further singularities
/// at distance R2 contribute a relative error (R/R2)^n.
/// Heuristic: it relies on four coefficients only. Throws error for missing coefficients.
template <scalar T>
T pole_pair_radius(const series::power_series<T>& a, int first, int stride) {
    using std::exp;
    using std::log;
    require_terms(a, first, first + 3 * stride);
    const auto u = [&](int m) { return T(a[first + m * stride] * (first + m * stride)); };
    const T q = (u(2) * u(2) - u(1) * u(3)) / (u(1) * u(1) - u(0) * u(2));
    return exp(-log(q) / (2 * stride));
}

/// R if a single singularity is nearest (in the variable x^stride): |u_0/u_1|^(1/stride), the ratio test with n a_n.
template <scalar T>
T single_pole_radius(const series::power_series<T>& a, int first, int stride) {
    using std::abs;
    using std::exp;
    using std::log;
    require_terms(a, first, first + stride);
    return exp(log(abs(a[first] * first / (a[first + stride] * (first + stride)))) / stride);
}

}  // namespace libration::convergence
