// The method of Hunter and Guerrieri: a conjugate pair from three-term recurrences with the exponent eliminated.
//
// Coefficients of (1 - s w + d w^2)^nu, w = x^stride, s = 2 cos(phi)/R, d = 1/R^2, satisfy with m = n/stride
//     m c_k - s (m - 1 - nu) c_{k-1} + d (m - 2 - 2 nu) c_{k-2} = 0 [HunterGuerrieri1980].
// Three successive ones have a solution (1, s, d) only if their determinant is 0: a quadratic equation for nu. Two of
// the recurrences then give s and d; a fourth selects the root. Exact for this function and for a pair of logarithms;
// with other factors the error falls like 1/n^2, and the sequences of s, d and nu are extrapolated in 1/n. Fails if the
// nearest singularities are not a single pair: d <= 0, or the sequences do not settle.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/conjugate_pair.hpp"
#include "libration/convergence/extrapolation.hpp"

namespace libration::convergence {

namespace fitting {

template <rounding_scalar T>
using triple = std::array<T, 3>;

/// A 3 x 3 determinant by its columns.
template <rounding_scalar T>
T determinant(const triple<T>& a, const triple<T>& b, const triple<T>& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The real parts of the roots of p0 + p1 x + p2 x^2; of the single root if p2 = 0, empty if p1 = 0 too.
template <rounding_scalar T>
std::vector<T> real_parts_of_roots(const T& p0, const T& p1, const T& p2) {
    using std::sqrt;
    if (p2 == 0) {
        return p1 == 0 ? std::vector<T>{} : std::vector<T>{T(-p0 / p1)};
    }
    const T square = p1 * p1 - p0 * p2 * 4;
    if (square <= 0) {
        return {T(-p1 / (p2 * 2))};
    }
    const T larger = p1 < 0 ? T(sqrt(square) - p1) : T(-sqrt(square) - p1);
    return {T(larger / (p2 * 2)), T(p0 * 2 / larger)};
}

/// s, d and nu, and the residual of the next recurrence.
template <rounding_scalar T>
struct pair_with_exponent {
    pair_quadratic<T> pair;
    T exponent;
    T residual;
};

/// s and d from the recurrences at k and k - 1 for a given nu; the residual from that at k + 1.
template <rounding_scalar T>
std::optional<pair_with_exponent<T>> pair_for_exponent(const strided_series<T>& series, const scaled_coefficients<T>& c,
                                                       int k, const T& nu) {
    using std::abs;
    const auto term = [&](int at, int back) {
        const T m = T(series.power(at)) / series.stride();
        return T((m - back - nu * back) * c[at - back]);
    };
    const T divisor = term(k, 1) * term(k - 1, 2) - term(k - 1, 1) * term(k, 2);
    if (divisor == 0) {
        return std::nullopt;
    }
    const T s = (term(k, 0) * term(k - 1, 2) - term(k - 1, 0) * term(k, 2)) / divisor;
    const T d = (term(k, 0) * term(k - 1, 1) - term(k - 1, 0) * term(k, 1)) / divisor;
    return pair_with_exponent<T>{{s, d}, nu, T(abs(term(k + 1, 0) - s * term(k + 1, 1) + d * term(k + 1, 2)))};
}

/// From the six coefficients c_{k-4} .. c_{k+1}.
template <rounding_scalar T>
std::optional<pair_with_exponent<T>> solve_with_exponent(const strided_series<T>& series,
                                                         const scaled_coefficients<T>& c, int k) {
    // The columns m c_k, (m - 1 - nu) c_{k-1}, (m - 2 - 2 nu) c_{k-2} as u, v - nu v0 and w - 2 nu w0.
    triple<T> u;
    triple<T> v;
    triple<T> v0;
    triple<T> w;
    triple<T> w0;
    for (int row = 0; row < 3; ++row) {
        const auto i = static_cast<std::size_t>(row);
        const T m = T(series.power(k - row)) / series.stride();
        u[i] = c[k - row] * m;
        v0[i] = c[k - row - 1];
        v[i] = v0[i] * (m - 1);
        w0[i] = c[k - row - 2];
        w[i] = w0[i] * (m - 2);
    }
    const T p0 = determinant(u, v, w);
    const T p1 = -determinant(u, v0, w) - determinant(u, v, w0) * 2;
    const T p2 = determinant(u, v0, w0) * 2;
    std::optional<pair_with_exponent<T>> best;
    for (const T& nu : real_parts_of_roots(p0, p1, p2)) {
        auto candidate = pair_for_exponent(series, c, k, nu);
        if (candidate && is_a_number(candidate->residual) && (!best || candidate->residual < best->residual)) {
            best = std::move(candidate);
        }
    }
    return best;
}

/// s, d and nu against n.
template <rounding_scalar T>
struct hunter_guerrieri_sequences {
    std::vector<sequence_entry<T>> s;
    std::vector<sequence_entry<T>> d;
    std::vector<sequence_entry<T>> exponent;
};

/// Those from the last k down to the first at which the recurrences yield no pair.
template <rounding_scalar T>
hunter_guerrieri_sequences<T> hunter_guerrieri_sequences_of(const strided_series<T>& series) {
    const scaled_coefficients<T> c(series);
    hunter_guerrieri_sequences<T> all;
    const auto count = static_cast<std::size_t>(c.last());
    all.s.reserve(count);
    all.d.reserve(count);
    all.exponent.reserve(count);
    for (int k = c.last() - 1; k >= c.first() + 4; --k) {
        const auto solution = solve_with_exponent(series, c, k);
        if (!solution || !(solution->pair.d > 0)) {
            break;
        }
        all.s.push_back({series.power(k), solution->pair.s});
        all.d.push_back({series.power(k), solution->pair.d});
        all.exponent.push_back({series.power(k), solution->exponent});
    }
    std::ranges::reverse(all.s);
    std::ranges::reverse(all.d);
    std::ranges::reverse(all.exponent);
    return all;
}

}  // namespace fitting

/// By the extrapolated sequences, with four times their uncertainty: calibrated. Needs twelve coefficients. O(N log N)
/// per column of the extrapolation.
template <rounding_scalar T>
radius_estimate<T> hunter_guerrieri(const strided_series<T>& c) {
    using std::sqrt;
    constexpr int safety = 4;
    const std::string method = "hunter-guerrieri";
    if (c.last() + 1 < fewest_for_pairs) {
        return too_short<T>(method, fewest_for_pairs, c.last() + 1);
    }
    const auto sequences = fitting::hunter_guerrieri_sequences_of(c);
    const auto count = static_cast<int>(sequences.d.size());
    if (count < 4 || count < c.last() / 4) {
        return no_estimate<T>(method, "its recurrences have no solution with R^2 > 0: no single pair of singularities");
    }
    const auto d = extrapolated_limit(sequences.d);
    const auto s = extrapolated_limit(sequences.s);
    const auto exponent = extrapolated_limit(sequences.exponent);
    const pair_quadratic<T> pair{s.value, d.value};
    if (!(d.value > 0) || !pair.conjugate(c.last())) {
        return no_estimate<T>(
            method,
            "the roots of its quadratic are not distinguished from real ones: no conjugate pair of singularities");
    }
    radius_estimate<T> result;
    result.method = method;
    const T radius = 1 / sqrt(d.value);
    result.radius = radius;
    result.uncertainty = (d.uncertainty / (d.value * 2) + epsilon<T>() * safety) * radius * safety;
    result.position = pair.nearest_root();
    result.count = 2;
    result.exponent = exponent.value;
    result.exponent_uncertainty = exponent.uncertainty * safety;
    return if_settled(in_variable(std::move(result), c.stride()));
}

}  // namespace libration::convergence
