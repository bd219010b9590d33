// The ratio test: |a_{n-1}/a_n| -> R for a single nearest singularity.
//
// For (1 - w/w0)^nu, c_{k-1}/c_k = w0 (1 + (nu + 1)/k + ...): the error falls like 1/N. Fails, and reports this, if
// more than one singularity is nearest: the ratios do not converge, or divide by 0.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/settling.hpp"
#include "libration/convergence/strided_series.hpp"

namespace libration::convergence {

namespace fitting {

/// Number of coefficients that ratio tests require.
inline constexpr int fewest_for_ratios = 8;

/// The last quarter of c_{k-1}/c_k, the very last one at the end; or the reason, if one of them does not exist.
template <rounding_scalar T>
std::pair<std::vector<T>, std::string> last_ratios(const strided_series<T>& c) {
    std::pair<std::vector<T>, std::string> found;
    const int window = settling_window(c.last());
    found.first.reserve(static_cast<std::size_t>(window));
    for (int k = c.last() - window + 1; k <= c.last(); ++k) {
        if (c[k] == 0 || c[k - 1] == 0) {
            const int zero = c[k] == 0 ? k : k - 1;
            found.second = "divides by 0: the coefficient " + std::to_string(c.power(zero)) + " is 0";
            return found;
        }
        found.first.push_back(T(c[k - 1] / c[k]));
    }
    return found;
}

/// The reason why the ratios do not indicate a single singularity; empty if they may.
template <rounding_scalar T>
std::string reason_against_ratios(const strided_series<T>& c) {
    const auto [ratios, reason] = last_ratios(c);
    if (!reason.empty()) {
        return reason;
    }
    const auto end = settled_range(ratios);
    if (end.scatters()) {
        return "the ratios scatter between " + end.range() + ": more than one singularity is nearest";
    }
    return "";
}

template <rounding_scalar T>
radius_estimate<T> estimate_by_ratios(const std::string& method, const strided_series<T>& c) {
    using std::abs;
    constexpr int safety = 4;
    if (c.last() + 1 < fewest_for_ratios) {
        return too_short<T>(method, fewest_for_ratios, c.last() + 1);
    }
    const std::string reason = reason_against_ratios(c);
    if (!reason.empty()) {
        return no_estimate<T>(method, reason);
    }
    const auto end = settled_range(last_ratios(c).first);
    radius_estimate<T> result;
    result.method = method;
    result.radius = T(abs(end.value));
    result.uncertainty = end.uncertainty() + *result.radius * epsilon<T>() * safety;
    result.position = complex_number<T>{end.value, T(0)};
    result.count = 1;
    return if_settled(in_variable(std::move(result), c.stride()));
}

}  // namespace fitting

/// The textbook test on all coefficients: R = |a_{N-1}/a_N|, not applied if symmetry makes coefficients 0. The
/// uncertainty is four times the movement over the last quarter. Needs eight coefficients. O(N).
template <rounding_scalar T>
radius_estimate<T> ratio_test(const strided_series<T>& c) {
    return fitting::estimate_by_ratios("ratio", c);
}

/// The same in w = x^stride on the coefficients that remain after symmetry: |a_{n-stride}/a_n|^(1/stride).
template <rounding_scalar T>
radius_estimate<T> ratio_test_in_power(const strided_series<T>& c) {
    return fitting::estimate_by_ratios("ratio-in-power", c);
}

}  // namespace libration::convergence
