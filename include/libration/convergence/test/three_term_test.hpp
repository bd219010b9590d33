// The three-term test of Chang and Corliss: a single nearest singularity from three successive coefficients.
//
// f = (1 - w/w0)^nu, w = x^stride, satisfies (1 - w/w0) x f' = -stride nu (w/w0) f, so that with n = first + stride k
//     n c_k/c_{k-1} = (n - stride - stride nu)/w0,
// and the difference of two such equations has nu eliminated [ChangCorliss1980]:
//     1/w0 = (n c_k/c_{k-1} - (n - stride) c_{k-1}/c_{k-2})/stride,   nu + 1 = (n/stride) (1 - w0 c_k/c_{k-1}).
// Exact for this f; with other factors the error falls like 1/n^2, that of nu like 1/n. Fails, and reports this, if
// more than one singularity is nearest: successive results differ.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/test/ratio_test.hpp"

namespace libration::convergence {

namespace fitting {

/// 1/w0 and nu + 1 from the three coefficients that end at c_k. c_{k-1} and c_{k-2} are nonzero.
template <rounding_scalar T>
struct three_term_solution {
    T inverse;
    T exponent_and_1;
};

template <rounding_scalar T>
three_term_solution<T> solve_three_terms(const strided_series<T>& c, int k) {
    const int n = c.power(k);
    const T ratio = c[k] / c[k - 1];
    const T inverse = (ratio * n - c[k - 1] / c[k - 2] * (n - c.stride())) / c.stride();
    return {inverse, T((1 - ratio / inverse) * n / c.stride())};
}

}  // namespace fitting

/// From the last three coefficients. The uncertainty is that of the settling over the last quarter, plus the effect of
/// rounding the coefficients on 1/w0, n times as much. Needs eight coefficients. O(N).
template <rounding_scalar T>
radius_estimate<T> three_term_test(const strided_series<T>& c) {
    using std::abs;
    constexpr int safety = 4;
    const std::string method = "three-term";
    if (c.last() + 1 < fitting::fewest_for_ratios) {
        return too_short<T>(method, fitting::fewest_for_ratios, c.last() + 1);
    }
    if (std::string reason = fitting::reason_against_ratios(c); !reason.empty()) {
        return no_estimate<T>(method, std::move(reason));
    }
    std::vector<T> positions;
    std::vector<T> exponents;
    const int window = settling_window(c.last() - 1);
    positions.reserve(static_cast<std::size_t>(window));
    exponents.reserve(static_cast<std::size_t>(window));
    for (int k = c.last() - window + 1; k <= c.last(); ++k) {
        const auto solution = fitting::solve_three_terms(c, k);
        positions.push_back(T(1 / solution.inverse));
        exponents.push_back(T(solution.exponent_and_1 - 1));
    }
    const auto at = settled_range(positions);
    const auto exponent = settled_range(exponents);
    if (at.scatters()) {
        return no_estimate<T>(method, "successive results differ between " + at.range() + ": no single singularity");
    }
    radius_estimate<T> result;
    result.method = method;
    result.radius = T(abs(at.value));
    result.uncertainty = at.uncertainty() + *result.radius * epsilon<T>() * (safety * (c.last() + 1));
    result.position = complex_number<T>{at.value, T(0)};
    result.count = 1;
    result.exponent = exponent.value;
    result.exponent_uncertainty = exponent.uncertainty() + epsilon<T>() * safety * (c.last() + 1) * (c.last() + 1);
    return if_settled(in_variable(std::move(result), c.stride()));
}

}  // namespace libration::convergence
