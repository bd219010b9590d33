// The asymptotic approximant of a function that ends at a branch point on the circle of convergence:
//
//     f(t) = (1 - (t/T)^k)^p sum_{n=0}^{N} A_n t^n,
//
// k = 2 for an even f, as the collapse of an empty bubble, p = 2/5 [Harkin2021]. The A_n are the Taylor coefficients of
// g = f (1 - (t/T)^k)^-p. Where f ~ (T - t)^p (g_0 + g_1 (T - t)^q + ..) with a non-integer q, those of f fall like
// n^-(1+p) T^-n and the A_n like n^-(1+q) T^-n: the largest error on [0, T] is of order N^-p for the series and
// N^-(p+q) for the approximant.
#pragma once

#include <utility>

#include "libration/scalar/error.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration {

/// f (1 - (t/T)^k)^-p as a series, to the order of f. O(N^2/k), over any field. Throws error if k < 1.
template <field R>
series::power_series<R> without_branch_point(const series::power_series<R>& f, const R& end, const R& p, int k) {
    if (k < 1) {
        throw error(error_kind::argument, "symmetry", std::to_string(k), "of a branch point is less than 1");
    }
    auto factor = series::power_series<R>::zero(f.order());
    factor[0] = R(1);
    R of_end(1);
    for (int i = 0; i < k; ++i) {
        of_end = R(of_end * end);
    }
    for (int j = 1; j * k <= f.order(); ++j) {
        factor[j * k] = R(R(factor[(j - 1) * k] * R(p + R(j - 1))) / R(of_end * j));
    }
    return f * factor;
}

/// The approximant as a function of 0 <= t <= T.
template <scalar T>
class branch_approximant {
public:
    branch_approximant(const series::power_series<T>& f, T end, T p, int k)
        : inner_(without_branch_point(f, end, p, k)), end_(std::move(end)), power_(std::move(p)), symmetry_(k) {}

    int order() const { return inner_.order(); }
    /// A_0 .. A_N.
    const series::power_series<T>& inner() const { return inner_; }

    /// At t; 0 at T. O(N).
    T value(const T& t) const {
        using std::exp;
        using std::log;
        T part(1);
        for (int i = 0; i < symmetry_; ++i) {
            part *= t / end_;
        }
        return part == 1 ? T(0) : T(exp(T(power_ * log(T(1 - part)))) * evaluate_value(inner_, t));
    }

private:
    series::power_series<T> inner_;
    T end_;
    T power_;
    int symmetry_;
};

}  // namespace libration
