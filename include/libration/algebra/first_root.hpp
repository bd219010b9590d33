// The smallest root of a real polynomial in [0, 1], from signs alone.
//
// In the Bernstein basis p(x) = sum_j b_j C(n,j) x^j (1-x)^(n-j) the number of sign changes in b_0, .., b_n equals the
// number of roots in (0, 1), counted with multiplicity, or exceeds it by an even number; bisection separates the roots
// [LaneRiesenfeld1981]. In rounding arithmetic a coefficient is accurate to n eps sum |a_i|; roots hidden by that error
// are not found.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/series/arithmetic.hpp"

namespace libration {

namespace bernstein {

/// b_j = sum_{i<=j} C(j,i)/C(n,i) a_i. O(n^2).
template <rounding_scalar T>
std::vector<T> coefficients_of(const series::power_series<T>& p) {
    const int n = p.order();
    std::vector<T> b;
    b.reserve(static_cast<std::size_t>(n) + 1);
    for (int j = 0; j <= n; ++j) {
        T sum = p[0];
        T part(1);
        for (int i = 1; i <= j; ++i) {
            part = part * (j - i + 1) / (n - i + 1);
            sum += p[i] * part;
        }
        b.push_back(std::move(sum));
    }
    return b;
}

/// Sign changes, ignoring zeros.
template <rounding_scalar T>
int sign_changes(const std::vector<T>& b) {
    int changes = 0;
    int last = 0;
    for (const T& each : b) {
        const int sign = each > 0 ? 1 : each < 0 ? -1 : 0;
        changes += sign * last < 0 ? 1 : 0;
        last = sign != 0 ? sign : last;
    }
    return changes;
}

/// The Bernstein coefficients on the two halves, by de Casteljau's algorithm. O(n^2).
template <rounding_scalar T>
std::pair<std::vector<T>, std::vector<T>> halves(std::vector<T> b) {
    std::vector<T> left;
    left.reserve(b.size());
    for (std::size_t last = b.size(); last-- > 0;) {
        left.push_back(b.front());
        for (std::size_t i = 0; i < last; ++i) {
            b[i] = (b[i] + b[i + 1]) / 2;
        }
    }
    return {std::move(left), std::move(b)};
}

/// The smallest root in [from, from + width), or the end of it if p is 0 there. Returns std::nullopt if there is none.
template <rounding_scalar T>
std::optional<T> first_root_in(const std::vector<T>& b, const T& from, const T& width) {
    if (b.front() == 0) {
        return from;
    }
    if (sign_changes(b) == 0) {
        return b.back() == 0 ? std::optional<T>(from + width) : std::nullopt;
    }
    // Roots closer together than this count as one: p touches 0 there or nearly does.
    if (width <= epsilon<T>() * 4) {
        return from;
    }
    const T half = width / 2;
    const auto [left, right] = halves(b);
    const auto first = first_root_in(left, from, half);
    return first ? first : first_root_in(right, T(from + half), half);
}

}  // namespace bernstein

/// The smallest x in [0, 1] with p(x) = 0, to 4 eps if the root is simple; std::nullopt if there is none. For a
/// polynomial that only touches 0, to rounding, a root there may or may not be found. O(n^2) per bisection, n the
/// degree.
template <rounding_scalar T>
std::optional<T> first_root(const series::power_series<T>& p) {
    return bernstein::first_root_in(bernstein::coefficients_of(p), T(0), T(1));
}

}  // namespace libration
