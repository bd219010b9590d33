// Whether the coefficients of a series fall or grow like powers R^-n at all. Those of an entire function fall faster,
// like n^(-n/rho) for the order rho [Boas1954, 2.2.2]; those of a divergent series grow faster, like n!.
//
// log |c_k| is fitted by alpha + beta k + gamma k log k on the last three quarters: gamma -> 0 for 0 < R < infinity,
// where the factor k^(-nu-1) of a singularity leaves gamma = O(1/K); -stride/rho for an entire function, and positive
// if the radius is 0. Coefficients of a complex pair come close to 0 repeatedly, so the fit is repeated without the
// points that lie below the first fit.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "libration/algebra/linear_system.hpp"
#include "libration/convergence/strided_series.hpp"

namespace libration::convergence {

enum class growth { unknown, geometric, entire, divergent };

/// How the coefficients grow, and gamma.
template <rounding_scalar T>
struct coefficient_growth {
    growth kind = growth::unknown;  ///< unknown with fewer than eight nonzero coefficients
    T gamma = T(0);
};

namespace fitting {

/// A point (k, log |c_k|).
template <rounding_scalar T>
struct size_point {
    T k;
    T log_size;
};

/// alpha, beta, gamma by least squares; std::nullopt if the equations are singular.
template <rounding_scalar T>
std::optional<std::vector<T>> fit_sizes(const std::vector<size_point<T>>& points, const T& last) {
    using std::log;
    constexpr std::size_t unknowns = 3;
    std::vector<std::vector<T>> normal(unknowns, std::vector<T>(unknowns, T(0)));
    std::vector<T> right(unknowns, T(0));
    for (const auto& p : points) {
        const T x = p.k / last;
        const std::array<T, unknowns> basis{T(1), x, T(x * log(x))};
        for (std::size_t i = 0; i < unknowns; ++i) {
            for (std::size_t j = 0; j < unknowns; ++j) {
                normal[i][j] += basis[i] * basis[j];
            }
            right[i] += basis[i] * p.log_size;
        }
    }
    return solve_linear(std::move(normal), std::move(right), T(epsilon<T>() * 64));
}

}  // namespace fitting

/// The growth of the coefficients. gamma is significant below -1/8 - 12/K, since k^(-nu-1) leaves about 1.6 (nu + 1)/K
/// and few coefficients of a pair scatter; and above 1/4 + 16/K, since small coefficients dominated later by a nearer
/// singularity are more common than divergent series. O(K).
template <rounding_scalar T>
coefficient_growth<T> growth_of(const strided_series<T>& c) {
    using std::abs;
    using std::log;
    constexpr std::size_t fewest = 8;
    std::vector<fitting::size_point<T>> points;
    const T last(c.last());
    for (int k = c.last() / 4 + 1; k <= c.last(); ++k) {
        if (c[k] != 0) {
            points.push_back({T(k), T(log(abs(c[k])))});
        }
    }
    if (points.size() < fewest) {
        return {};
    }
    const auto all = fitting::fit_sizes(points, last);
    if (!all) {
        return {};
    }
    const std::vector<T>& first_fit = *all;
    std::vector<fitting::size_point<T>> upper;
    for (const auto& p : points) {
        const T x = p.k / last;
        if (p.log_size >= first_fit[0] + first_fit[1] * x + first_fit[2] * x * log(x)) {
            upper.push_back(p);
        }
    }
    // beta x + gamma' x log x with x = k/K: gamma = gamma'/K.
    const auto fit = fitting::fit_sizes(upper.size() < fewest / 2 ? points : upper, last);
    if (!fit) {
        return {};
    }
    const T gamma = (*fit)[2] / last;
    const T falling = -T(1) / 8 - T(12) / last;
    const T growing = T(1) / 4 + T(16) / last;
    const growth kind = gamma < falling ? growth::entire : gamma > growing ? growth::divergent : growth::geometric;
    return {kind, gamma};
}

}  // namespace libration::convergence
