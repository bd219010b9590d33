// The generalised Domb-Sykes plot of Mercer and Roberts: a conjugate pair of nearest singularities.
//
// For c_k ~ A R^-k k^(-nu-1) cos(k phi + delta), D_k = c_{k+1} c_{k-1} - c_k^2 has no oscillation at leading order, and
//     B_k^2 = D_k/D_{k-1} = R^-2 (1 - 2 (nu + 1)/m + ...), m = n/stride [MercerRoberts1990, appendix]:
// B_k against 1/m has the intercept 1/R and the slope -(nu + 1)/R. With s_k = (c_{k+1} c_{k-2} - c_k c_{k-1})/D_{k-1},
// cos(phi) = s_k/(2 B_k) + O(1/m^2); both solve c_{j+1} = s c_j - d c_{j-1} for j = k and k - 1, without dividing by a
// single coefficient. Fails, and reports this, if B_k^2 <= 0 or D_k = 0, as for a single singularity.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/conjugate_pair.hpp"
#include "libration/convergence/extrapolation.hpp"

namespace libration::convergence {

namespace fitting {

/// B_k and s_k/(2 B_k) against n; empty, with the reason, if the last half of the coefficients does not yield any.
template <rounding_scalar T>
struct mercer_roberts_plot {
    std::vector<sequence_entry<T>> roots;
    std::vector<sequence_entry<T>> cosines;
    std::string reason;
};

template <rounding_scalar T>
mercer_roberts_plot<T> mercer_roberts_plot_of(const strided_series<T>& series) {
    using std::sqrt;
    const scaled_coefficients<T> c(series);
    const auto determinant = [&](int k) { return T(c[k + 1] * c[k - 1] - c[k] * c[k]); };
    mercer_roberts_plot<T> plot;
    plot.roots.reserve(static_cast<std::size_t>(c.last()));
    plot.cosines.reserve(static_cast<std::size_t>(c.last()));
    for (int k = c.first() + 2; k < c.last(); ++k) {
        const T now = determinant(k);
        const T before = determinant(k - 1);
        const bool vanishes = now == 0 || before == 0;
        if (vanishes || (now < 0) != (before < 0)) {
            if (2 * k > c.last()) {
                plot.reason = vanishes ? "its determinants vanish: no pair of singularities"
                                       : "B^2 is negative at n = " + std::to_string(series.power(k)) +
                                             ": no single pair of singularities";
                return plot;
            }
            plot.roots.clear();
            plot.cosines.clear();
            continue;
        }
        const T root = sqrt(now / before);
        const T sum = (c[k + 1] * c[k - 2] - c[k] * c[k - 1]) / before;
        plot.roots.push_back({series.power(k), root});
        plot.cosines.push_back({series.power(k), T(sum / (root * 2))});
    }
    return plot;
}

/// nu from k (1 - B_k R), with the uncertainty due to R.
template <rounding_scalar T>
sequence_limit<T> exponent_from_slope(const std::vector<sequence_entry<T>>& roots, const sequence_limit<T>& intercept,
                                      int stride) {
    std::vector<sequence_entry<T>> slopes;
    slopes.reserve(roots.size());
    for (const auto& b : roots) {
        slopes.push_back({b.n, T((1 - b.value / intercept.value) * b.n / stride)});
    }
    auto slope = extrapolated_limit(slopes);
    slope.value -= 1;
    slope.uncertainty += intercept.uncertainty / intercept.value * roots.back().n / stride;
    return slope;
}

}  // namespace fitting

/// By the extrapolated intercept, with four times its uncertainty: calibrated. Needs twelve coefficients. O(N log N)
/// per column of the extrapolation.
template <rounding_scalar T>
radius_estimate<T> mercer_roberts(const strided_series<T>& c) {
    constexpr int safety = 4;
    const std::string method = "mercer-roberts";
    if (c.last() + 1 < fewest_for_pairs) {
        return too_short<T>(method, fewest_for_pairs, c.last() + 1);
    }
    auto plot = fitting::mercer_roberts_plot_of(c);
    if (!plot.reason.empty()) {
        return no_estimate<T>(method, std::move(plot.reason));
    }
    const auto intercept = extrapolated_limit(plot.roots);
    const auto cosine = extrapolated_limit(plot.cosines);
    const pair_quadratic<T> pair{T(intercept.value * cosine.value * 2), T(intercept.value * intercept.value)};
    if (!(intercept.value > 0) || !pair.conjugate(c.last())) {
        return no_estimate<T>(method, "the estimated cosine " + to_decimal(cosine.value, 6) +
                                          " is that of no conjugate pair of singularities");
    }
    const auto exponent = fitting::exponent_from_slope(plot.roots, intercept, c.stride());
    radius_estimate<T> result;
    result.method = method;
    const T radius = 1 / intercept.value;
    result.radius = radius;
    result.uncertainty = (intercept.uncertainty * radius + epsilon<T>() * safety) * radius * safety;
    result.position = pair.nearest_root();
    result.count = 2;
    result.exponent = exponent.value;
    result.exponent_uncertainty = exponent.uncertainty * safety + epsilon<T>() * (safety * (c.last() + 1));
    return if_settled(in_variable(std::move(result), c.stride()));
}

}  // namespace libration::convergence
