// Series whose singularities are known, by exact recurrences: what the radius tests are tested on.
#pragma once

#include "libration/series/power_series.hpp"

namespace libration::tests {

/// (1 - x/x0)^nu + x^2: a_n = a_{n-1} (n - 1 - nu)/(n x0).
template <class T>
power_series<T> power_at(const T& x0, const T& nu, int order) {
    auto a = power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 1; n <= order; ++n) {
        a[n] = a[n - 1] * (n - 1 - nu) / (x0 * n);
    }
    a[2] += 1;
    return a;
}

/// sum_i r_i/(1 - x/x_i) with x_i = 5/4 (r = 1), -2 (r = 3), 3 (r = -1).
template <class T>
power_series<T> three_poles(int order) {
    auto a = power_series<T>::zero(order);
    T near(1);
    T left(3);
    T far(-1);
    for (int n = 0; n <= order; ++n) {
        a[n] = near + left + far;
        near *= T(4) / 5;
        left /= -2;
        far /= 3;
    }
    return a;
}

/// -log(1 - 2 c x/R + x^2/R^2) = sum 2 cos(n phi)/(n R^n) x^n, c = cos phi = 3/5, R = 5/4: logarithms at 3/4 +- i.
template <class T>
power_series<T> logarithms_of_a_pair(int order) {
    auto a = power_series<T>::zero(order);
    T cosine(1);
    T next = T(3) / 5;
    T power(1);
    for (int n = 1; n <= order; ++n) {
        power *= T(4) / 5;
        a[n] = next * power * 2 / n;
        const T after = next * 6 / 5 - cosine;
        cosine = next;
        next = after;
    }
    return a;
}

/// x^first h(x^stride) for a series h.
template <class T>
power_series<T> spread(const power_series<T>& h, int first, int stride) {
    auto a = power_series<T>::zero(first + stride * h.order());
    for (int k = 0; k <= h.order(); ++k) {
        a[first + stride * k] = h[k];
    }
    return a;
}

}  // namespace libration::tests
