// The asymptotic approximant of a function that tends to a constant exponentially, by a rational function:
//
//     f(t) = f_inf + e^(-a t) (1 + t)^-s P(t)/Q(t),   deg P = deg Q = M,
//
// the modified symmetric Pade approximant, published with s = 0 for ln S of SEIR [Weinstein2020]. s = 1/2 gives the
// asymptotic behaviour of the modified Bessel function K_0, which is that of a decaying solution of the
// Flierl-Petviashvili equation; the form published for it is different [Barlow2017] and also predicts f(0). P/Q tends
// to a constant, which is free.
#pragma once

#include <optional>
#include <utility>

#include "libration/approximant/pade.hpp"
#include "libration/approximant/power_approximant.hpp"

namespace libration {

/// How f approaches its limit: e^(-rate t) (1 + t)^-power.
template <class T>
struct damping {
    T limit;
    T rate;
    T power;
};

/// (f - f_inf) e^(a t) (1 + t)^s as a series. O(N^2), over any field.
template <field R>
series::power_series<R> undamped(series::power_series<R> f, const damping<R>& of) {
    f[0] = R(f[0] - of.limit);
    auto growth = series::power_series<R>::zero(f.order());
    auto binomial = growth;
    growth[0] = R(1);
    binomial[0] = R(1);
    for (int n = 1; n <= f.order(); ++n) {
        growth[n] = R(R(growth[n - 1] * of.rate) / n);
        binomial[n] = R(R(binomial[n - 1] * R(of.power - R(n - 1))) / n);
    }
    return f * growth * binomial;
}

/// The approximant as a function of t >= 0.
template <scalar T>
class damped_pade {
public:
    /// From the series to order 2 M at least. Returns std::nullopt if the approximant does not exist. O(M^3); the
    /// system loses digits as in pade().
    static std::optional<damped_pade> of(const series::power_series<T>& f, int m, damping<T> far) {
        auto inner = pade(undamped(f.truncated(2 * m), far), m, m, T(0));
        return inner ? std::optional(damped_pade(*std::move(inner), std::move(far))) : std::nullopt;
    }

    const pade_approximant<T>& inner() const { return inner_; }

    /// Value and slope at t. O(M).
    series::jet<T> operator()(const T& t) const {
        using std::exp;
        using std::log;
        const T weight = exp(T(-far_.rate * t - far_.power * log(T(1 + t))));
        const series::jet<T> at = inner_(t);
        return {far_.limit + weight * at.value, weight * (at.slope - at.value * (far_.rate + far_.power / (1 + t)))};
    }
    T value(const T& t) const { return (*this)(t).value; }

private:
    damped_pade(pade_approximant<T> inner, damping<T> far) : inner_(std::move(inner)), far_(std::move(far)) {}

    pade_approximant<T> inner_;
    damping<T> far_;
};

}  // namespace libration
