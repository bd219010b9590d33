// Exponential, logarithm, real power and sine-cosine of a series, each a loop on its kernel (kernel.hpp): O(N^2).
//
// Each has two versions: with the value at the centre from the function of that name, and with that value given, over
// any field: log f of fractions with f_0 = 1 and l_0 = 0, the sine of an angle that is known less accurately than its
// sine.
#pragma once

#include <utility>

#include "libration/series/arithmetic.hpp"
#include "libration/series/kernel.hpp"

namespace libration::series {

/// The slope f' with as many coefficients as f has, the last of them 0: the input of the kernels of whole series.
template <ring R>
power_series<R> slope_of(const power_series<R>& f) {
    auto slope = power_series<R>::zero(f.order());
    for (int n = 1; n <= f.order(); ++n) {
        slope_kernel(f.data(), slope.data(), n);
    }
    return slope;
}

/// exp f with e_0 given.
template <field R>
power_series<R> exponential(const power_series<R>& f, const R& value) {
    const auto slope = slope_of(f);
    auto e = power_series<R>::zero(f.order());
    e[0] = value;
    for (int n = 1; n <= f.order(); ++n) {
        exponential_kernel(slope.data(), e.data(), n);
    }
    return e;
}

/// exp f.
template <field R>
power_series<R> exponential(const power_series<R>& f) {
    using std::exp;
    return exponential(f, R(exp(f[0])));
}

/// log f with l_0 given, f_0 nonzero.
template <field R>
power_series<R> logarithm(const power_series<R>& f, const R& value) {
    auto slope = power_series<R>::zero(f.order());
    auto l = slope;
    l[0] = value;
    for (int n = 1; n <= f.order(); ++n) {
        logarithm_kernel(f.data(), slope.data(), l.data(), n);
    }
    return l;
}

/// log f, f_0 > 0; for complex numbers f_0 nonzero, by the principal value of log f_0.
template <field R>
power_series<R> logarithm(const power_series<R>& f) {
    using std::log;
    return logarithm(f, R(log(f[0])));
}

/// f^r with p_0 given, f_0 nonzero.
template <field R>
power_series<R> power(const power_series<R>& f, const R& r, const R& value) {
    const auto slope = slope_of(f);
    auto slope_p = power_series<R>::zero(f.order());
    auto p = slope_p;
    p[0] = value;
    for (int n = 1; n <= f.order(); ++n) {
        power_kernel(f.data(), slope.data(), r, slope_p.data(), p.data(), n);
    }
    return p;
}

/// f^r, f_0 > 0; for complex numbers f_0 nonzero, by the principal value of f_0^r.
template <field R>
power_series<R> power(const power_series<R>& f, const R& r) {
    using std::pow;
    return power(f, r, R(pow(f[0], r)));
}

/// (sin f, cos f) with s_0 and c_0 given, for an initial value whose sine or cosine is known more accurately than its
/// angle; the parity of f is that of f - f_0 and saves half of the products.
template <field R>
std::pair<power_series<R>, power_series<R>> sine_cosine(const power_series<R>& f, const R& sine, const R& cosine,
                                                        parity of_f = parity::any) {
    const auto slope = slope_of(f);
    auto s = power_series<R>::zero(f.order());
    auto c = s;
    s[0] = sine;
    c[0] = cosine;
    for (int n = 1; n <= f.order(); ++n) {
        sine_cosine_kernel(slope.data(), s.data(), c.data(), n, opposite(of_f));
    }
    return {std::move(s), std::move(c)};
}

/// (sin f, cos f).
template <field R>
std::pair<power_series<R>, power_series<R>> sine_cosine(const power_series<R>& f) {
    using std::cos;
    using std::sin;
    return sine_cosine(f, R(sin(f[0])), R(cos(f[0])));
}

}  // namespace libration::series
