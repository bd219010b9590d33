// The asymptotic approximant of a function that tends to a polynomial, a line or a constant, faster than its form can
// express:
//
//     f(t) = far(t) + c (1 + sum_{n=1}^{N} A_n t^n)^p,   c = f(0) - far(0),
//
// for p = -1 and far(t) = t + B the approximant of the boundary layers of Blasius [Barlow2017] and of Falkner and Skan
// [Belden2020]; for p = -q/N that of a function decaying like t^-q. The A_n are the Taylor coefficients of h = ((f -
// far)/c)^(1/p), so that no system is solved. For p = -1 the behaviour as N grows follows from that. Let r be the
// radius of convergence of h. For t < r, the approximants converge; for t > r with |A_n t^n| -> infinity, they tend to
// far(t). If f approaches far(t) as t grows, the largest error on [0, infinity) therefore does not vanish but tends to
// |f(r) - far(r)|.
#pragma once

#include <utility>
#include <vector>

#include "libration/scalar/error.hpp"
#include "libration/series/arithmetic.hpp"
#include "libration/series/kernel.hpp"

namespace libration {

/// h^r for the series h with h_0 = 1 by Miller's recurrence, series::power_kernel [Henrici]. O(N^2), over any field.
template <field R>
series::power_series<R> power_of_one_plus(const series::power_series<R>& h, const R& r) {
    auto slope = series::power_series<R>::zero(h.order() + 1);
    auto slope_of_result = slope;
    auto result = series::power_series<R>::zero(h.order());
    result[0] = R(1);
    for (int n = 0; n <= h.order(); ++n) {
        series::slope_kernel(h.data(), slope.data(), n);
        series::power_kernel(h.data(), slope.data(), r, slope_of_result.data(), result.data(), n);
    }
    return result;
}

/// f - far, a polynomial in t. Throws error if it is 0 at 0.
template <field R>
series::power_series<R> distance_from_far(series::power_series<R> f, const series::power_series<R>& far) {
    for (int n = 0; n <= f.order() && n <= far.order(); ++n) {
        f[n] = R(f[n] - far[n]);
    }
    if (f[0] == R(0)) {
        throw error(error_kind::argument, "asymptotic behaviour", "", "has the same value at 0 as the function");
    }
    return f;
}

/// 1 + sum A_n t^n: the power `reciprocal`, 1/p, of (f - far)/c, to the order of f. O(N^2).
template <field R>
series::power_series<R> bracket_of_power(const series::power_series<R>& f, const series::power_series<R>& far,
                                         const R& reciprocal) {
    series::power_series<R> h = distance_from_far(f, far);
    const R c = h[0];
    for (int n = 0; n <= h.order(); ++n) {
        h[n] = R(h[n] / c);
    }
    return power_of_one_plus(h, reciprocal);
}

/// The approximant as a function of t >= 0.
template <scalar T>
class power_approximant {
public:
    /// f: the series at 0 to order N, f(0) != far(0); far: a polynomial; p nonzero.
    power_approximant(const series::power_series<T>& f, series::power_series<T> far, T p)
        : bracket_(bracket_of_power(f, far, T(1 / p))),
          far_(std::move(far)),
          power_(std::move(p)),
          c_(f[0] - far_[0]) {}

    int order() const { return bracket_.order(); }
    /// 1, A_1, .., A_N.
    const series::power_series<T>& bracket() const { return bracket_; }

    /// Value and slope at t. O(N). For non-integer p the bracket has to be positive; otherwise the value is NaN.
    series::jet<T> operator()(const T& t) const {
        using std::exp;
        using std::log;
        const series::jet<T> far = evaluate(far_, t);
        const series::jet<T> bracket = evaluate(bracket_, t);
        const T power = power_ == -1 ? T(c_ / bracket.value) : T(c_ * exp(T(power_ * log(bracket.value))));
        return {far.value + power, far.slope + power * power_ * bracket.slope / bracket.value};
    }
    T value(const T& t) const { return (*this)(t).value; }

private:
    series::power_series<T> bracket_;
    series::power_series<T> far_;
    T power_;
    T c_;
};

}  // namespace libration
