// Series whose singularities are known, by exact recurrences, and lists that no test is made for: what the radius tests
// are tested on.
#pragma once

#include <string>
#include <vector>

#include "libration/convergence/radius_estimate.hpp"
#include "libration/convergence/strided_series.hpp"
#include "libration/number/exact.hpp"

namespace libration::tests {

using namespace series;
using namespace convergence;

/// (1 - x/x0)^nu.
template <class T>
power_series<T> binomial_series(const T& x0, const T& nu, int order) {
    auto a = power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 1; n <= order; ++n) {
        a[n] = a[n - 1] * (n - 1 - nu) / (x0 * n);
    }
    return a;
}

/// (1 - 2 cosine x + x^2)^nu: a pair on the unit circle.
template <class T>
power_series<T> gegenbauer_series(const T& cosine, const T& nu, int order) {
    auto a = power_series<T>::zero(order);
    a[0] = T(1);
    a[1] = -cosine * nu * 2;
    for (int n = 2; n <= order; ++n) {
        a[n] = (cosine * 2 * (n - 1 - nu) * a[n - 1] - (n - 2 - nu * 2) * a[n - 2]) / n;
    }
    return a;
}

/// (1 - x/x0)^nu + x^2.
template <class T>
power_series<T> power_at(const T& x0, const T& nu, int order) {
    auto a = binomial_series(x0, nu, order);
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

/// All coefficients of a list.
template <class T>
strided_series<T> every_coefficient(const power_series<T>& a) {
    return strided_series<T>(a, 0, 1);
}

/// Lists that no test is made for: zeros, one coefficient, constants, signs, sizes near the end of double, noise.
template <class T>
std::vector<power_series<T>> hostile_series() {
    std::vector<power_series<T>> all;
    for (const int order : {0, 3, 11, 12, 40, 97}) {
        auto zero = power_series<T>::zero(order);
        auto first = zero;
        first[0] = T(1);
        auto last = zero;
        last[order] = T(-3);
        auto ones = zero;
        auto alternating = zero;
        auto huge = zero;
        auto growing = zero;
        auto noise = zero;
        auto holes = zero;
        unsigned state = 12345;
        for (int n = 0; n <= order; ++n) {
            state = state * 1103515245U + 12345U;
            ones[n] = T(1);
            alternating[n] = T(n % 2 == 0 ? 1 : -1);
            huge[n] = from_exact<T>(read_exact(n % 3 == 0 ? "-1e300" : "1e300"));
            growing[n] = from_exact<T>(read_exact("1e" + std::to_string(3 * n)));
            noise[n] = T(static_cast<int>(state >> 16U) % 2001 - 1000) / 7;
            holes[n] = n % 5 == 1 ? T(0) : T(noise[n] * noise[n]);
        }
        for (auto& each : {zero, first, last, ones, alternating, huge, growing, noise, holes}) {
            all.push_back(each);
        }
    }
    return all;
}

/// Whether an answer is a finite radius > 0 with a finite uncertainty >= 0, or a reason.
template <class T>
bool well_formed(const radius_estimate<T>& e) {
    const auto finite = [](const T& x) { return T(x * 0) == 0; };
    if (!e.radius) {
        return !e.note.empty() && !e.position && !e.exponent;
    }
    return finite(*e.radius) && *e.radius > 0 && finite(e.uncertainty) && e.uncertainty >= 0 &&
           (!e.position || (finite(e.position->re) && finite(e.position->im) && e.position->im >= 0)) &&
           (!e.exponent || (finite(*e.exponent) && finite(e.exponent_uncertainty)));
}

/// Whether the true radius is within the uncertainty.
template <class T>
bool covers(const radius_estimate<T>& e, const T& truth) {
    return e.radius && *e.radius - truth <= e.uncertainty && truth - *e.radius <= e.uncertainty;
}

}  // namespace libration::tests
