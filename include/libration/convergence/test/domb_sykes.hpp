// The Domb-Sykes plot: ratios of coefficients against 1/n, a straight line for a single nearest singularity.
//
// With n = first + stride k, c_k/c_{k-1} = x0^-stride (1 - stride (nu + 1)/n + O(1/n^2)) [DombSykes]: the intercept
// gives the position including its sign, the slope the exponent. The intercept is extrapolated by Neville's table; the
// exponent from the slopes between neighbours, as in the three-term test, and then in the same way. Fails, and reports
// this, if more than one singularity is nearest: the ratios scatter.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/coefficient_ratios.hpp"
#include "libration/convergence/extrapolation.hpp"
#include "libration/convergence/test/three_term_test.hpp"

namespace libration::convergence {

/// By the plot's extrapolated intercept. Needs eight coefficients. O(N log N) per column of the table.
template <rounding_scalar T>
radius_estimate<T> domb_sykes(const strided_series<T>& c) {
    using std::abs;
    constexpr int safety = 2;
    const std::string method = "domb-sykes";
    if (c.last() + 1 < fitting::fewest_for_ratios) {
        return too_short<T>(method, fitting::fewest_for_ratios, c.last() + 1);
    }
    if (std::string reason = fitting::reason_against_ratios(c); !reason.empty()) {
        return no_estimate<T>(method, std::move(reason));
    }
    int first = c.last();
    while (first > 2 && c[first - 3] != 0) {
        --first;
    }
    std::vector<sequence_entry<T>> ratios;
    std::vector<sequence_entry<T>> slopes;
    ratios.reserve(static_cast<std::size_t>(c.last()));
    slopes.reserve(static_cast<std::size_t>(c.last()));
    for (int k = first; k <= c.last(); ++k) {
        ratios.push_back({c.power(k), T(c[k] / c[k - 1])});
        slopes.push_back({c.power(k), T(fitting::solve_three_terms(c, k).exponent_and_1 - 1)});
    }
    const auto inverse = neville_limit(ratios);
    const auto exponent = neville_limit(slopes);
    radius_estimate<T> result;
    result.method = method;
    const T position = 1 / inverse.value;
    result.radius = T(abs(position));
    result.uncertainty = (inverse.uncertainty * abs(position) + epsilon<T>() * safety) * abs(position) * safety;
    result.position = complex_number<T>{position, T(0)};
    result.count = 1;
    result.exponent = exponent.value;
    result.exponent_uncertainty = exponent.uncertainty * safety + epsilon<T>() * (c.last() + 1) * (c.last() + 1);
    result.note = "intercept after removing 1/n to the power " + std::to_string(inverse.removed);
    return if_settled(in_variable(std::move(result), c.stride()));
}

}  // namespace libration::convergence
