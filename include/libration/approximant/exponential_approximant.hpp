// The asymptotic approximant of a function that tends to a constant exponentially:
//
//     P(t) = f_inf + sum_{j=1}^{N} A_j e^(-j a t),   a > 0,
//
// for f itself (the boundary layer of Sakiadis [Barlow2017]) or for f_inf/f (SIR, S = S_inf/(1 + sum A_j e^(-j a t))
// [BarlowWeinstein2020]). The A_j are published as the solution of a Vandermonde system: P_n = f_n for n < N is sum_j
// A_j j^n = n! f_n/(-a)^n, n > 0. It loses more than one digit per term (vandermonde_condition). The same polynomial in
// z = 1 - e^(-a t) needs no system:
//
//     P = sum_{k<N} c_k z^k + (f_inf - sum_{k<N} c_k) z^N,
//
// the Taylor polynomial of f at z = 0 with one more term, which makes it exact at z = 1, t = infinity. The c_k are
// positive combinations of n! f_n/a^n: k! c_k = D (D+1) .. (D+k-1) f at t = 0, D = d/d(a t). The behaviour as N grows
// follows: if f(z) is analytic in |z| < rho, rho > 1, and at z = 1, the largest error on [0, infinity) falls like
// rho^-N; if rho < 1 it grows. rho is the least of |1 - e^(-a s)| over the singularities s of f.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "libration/algebra/vandermonde.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration {

/// The series in z = 1 - e^(-a t) of the function with the series f in t, to the same order. O(N^2), over any field; a
/// nonzero.
template <field R>
series::power_series<R> series_in_decay(const series::power_series<R>& f, const R& a) {
    std::vector<R> row;  // D^n of the newest operator's result
    R scale(1);
    for (int n = 0; n <= f.order(); ++n) {
        row.push_back(R(f[n] * scale));
        scale = R(scale * (n + 1) / a);
    }
    auto c = series::power_series<R>::zero(f.order());
    c[0] = row[0];
    for (int k = 1; k <= f.order(); ++k) {
        for (std::size_t n = 0; n + 1 < row.size(); ++n) {
            row[n] = R(R(row[n + 1] + row[n] * (k - 1)) / k);
        }
        row.pop_back();
        c[k] = row[0];
    }
    return c;
}

/// A_1 .. A_N by the published Vandermonde system, from f_0 .. f_(N-1). O(N^2), over any field. The loss of digits is
/// given by vandermonde_condition.
template <field R>
std::vector<R> exponential_sum(const series::power_series<R>& f, const R& limit, const R& a) {
    std::vector<R> nodes;
    std::vector<R> right;
    R scale(1);
    for (int n = 0; n <= f.order(); ++n) {
        nodes.push_back(R(n + 1));
        right.push_back(n == 0 ? R(f[0] - limit) : R(f[n] * scale));
        scale = R(R(scale * (n + 1)) / R(-a));
    }
    return solve_vandermonde(nodes, std::move(right));
}

/// The approximant P as a function of t >= 0, in powers of z.
template <scalar T>
class exponential_approximant {
public:
    /// f: the series at 0, of which f_0 .. f_(N-1) are matched; limit: the limit at infinity; a > 0.
    exponential_approximant(const series::power_series<T>& f, const T& limit, T a)
        : in_decay_(series_in_decay(f, a)), rate_(std::move(a)) {
        T last = limit;
        for (int k = 0; k <= f.order(); ++k) {
            last -= in_decay_[k];
        }
        in_decay_.push_back(last);
    }

    /// N.
    int order() const { return in_decay_.order(); }
    /// c_0 .. c_(N-1) and the coefficient of z^N.
    const series::power_series<T>& in_decay() const { return in_decay_; }

    /// Value and slope at t. O(N).
    series::jet<T> operator()(const T& t) const {
        using std::exp;
        const T left = exp(T(-rate_ * t));
        series::jet<T> at = evaluate(in_decay_, T(1 - left));
        at.slope *= rate_ * left;
        return at;
    }
    T value(const T& t) const { return (*this)(t).value; }

private:
    series::power_series<T> in_decay_;
    T rate_;
};

}  // namespace libration
