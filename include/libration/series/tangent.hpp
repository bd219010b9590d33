// Tangent, arctangent and hyperbolic tangent of a series, each a loop on its kernel (kernel.hpp): O(N^2). As in
// exponential.hpp, each has versions with and without the value at the centre.
#pragma once

#include "libration/series/exponential.hpp"

namespace libration::series {

/// tan f with t_0 given.
template <field R>
power_series<R> tangent(const power_series<R>& f, const R& value) {
    const auto slope = slope_of(f);
    auto q = power_series<R>::zero(f.order());
    auto t = q;
    t[0] = value;
    for (int n = 0; n <= f.order(); ++n) {
        tangent_kernel(slope.data(), q.data(), t.data(), n);
    }
    return t;
}

/// tan f, cos f_0 nonzero.
template <field R>
power_series<R> tangent(const power_series<R>& f) {
    using std::tan;
    return tangent(f, R(tan(f[0])));
}

/// tanh f with h_0 given.
template <field R>
power_series<R> hyperbolic_tangent(const power_series<R>& f, const R& value) {
    const auto slope = slope_of(f);
    auto q = power_series<R>::zero(f.order());
    auto h = q;
    h[0] = value;
    for (int n = 0; n <= f.order(); ++n) {
        hyperbolic_tangent_kernel(slope.data(), q.data(), h.data(), n);
    }
    return h;
}

/// tanh f.
template <field R>
power_series<R> hyperbolic_tangent(const power_series<R>& f) {
    using std::tanh;
    return hyperbolic_tangent(f, R(tanh(f[0])));
}

/// atan f with a_0 given, 1 + f_0^2 nonzero.
template <field R>
power_series<R> arctangent(const power_series<R>& f, const R& value) {
    const auto slope = slope_of(f);
    auto q = power_series<R>::zero(f.order());
    auto slope_a = q;
    auto a = q;
    a[0] = value;
    for (int n = 0; n <= f.order(); ++n) {
        arctangent_kernel(f.data(), slope.data(), q.data(), slope_a.data(), a.data(), n);
    }
    return a;
}

/// atan f; for complex numbers f_0 not i or -i, by the principal value.
template <field R>
power_series<R> arctangent(const power_series<R>& f) {
    using std::atan;
    return arctangent(f, R(atan(f[0])));
}

}  // namespace libration::series
