// Resummations with m derivatives of theta at the bottom: the paper's has m = 2, the two-point expansion m = N + 1.
//
// Rates. The approximant is the Hermite interpolation of theta at x = 0 (N + 1 conditions) and x = 1 (m conditions), so
// its error is, with the singularities at z = +-1 +- i K~'/T*, ..., and integrals along cuts outwards,
//     x^(N+1) (x-1)^m sum_z (1/2 pi i) int theta(z)/(z^(N+1) (z-1)^m (z-x)) dz,   |z| >= R/T*, |z-1| >= K~'/T*.
// For a fixed m it decreases like rho^N, rho = T*/R: the rate of the series exactly, with a gain N^-m and a constant
// (T*/K~')^m. For m = N + 1 it is (T*^2/(4 K~' R))^N, the degree being 2 N + 1: smaller than rho^(2N) where K~'/T* >
// 1/sqrt 15, than the uniform resummation's at the same number of coefficients, (9 + (K~'/T*)^2)^-N, where K~'/T* >
// 1.55 (E < 0.234 or E > 17.1), and above 1, so that the expansion diverges, where K~'/T* < 0.243, that is |2 - E| <
// 7.74e-5.
//
// Bound, a generalisation of theorem A2 [bounds.hpp] with the same proof: with u = x the error for the monomial
// u^(N+1+j) is u^(N+1) (u^j - sum_{l<m} C(j,l) (u-1)^l), the bracket being (1-u)^m times a derivative of order m of v^j
// over m! at some v in [u, 1], so at most (1-u)^m C(j,m); and sum_j C(j,m) rho^j = rho^m/(1-rho)^(m+1). Therefore, for
// N + 1 + m >= 4,
//     ||theta - theta_N,m|| <= (8 M/(N+1+m)) rho^(N+1+m)/(1-rho)^(m+1) max_u u^(N+1) (1-u)^m,
// and the maximum is (N+1)^(N+1) m^m/(N+1+m)^(N+1+m), with 0^0 = 1.
#pragma once

#include <string>
#include <vector>

#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// theta^(j)(T*) T*^j/j!, j = 0 .. m-1, from the series about the bottom, where theta is odd up to its constant. They
/// grow like (T*/K~')^j. O(m^2). Throws error for a negative m.
template <scalar T>
std::vector<T> arc_endpoint(const fundamental_arc<T>& arc, int conditions) {
    if (conditions < 0) {
        throw error(error_kind::argument, "number of conditions", std::to_string(conditions),
                    "at the bottom is not one that there is");
    }
    if (conditions == 0) {
        return {};
    }
    const pendulum_state<T> bottom{arc.bottom().value, arc.bottom().slope, T(0), T(1)};
    return taylor_coefficients(taylor_start<T>{bottom, arc.level().pair, series::parity::odd}, conditions - 1,
                               arc.effective_period())
        .coefficients();
}

/// theta as a function of x from the series to the power N and m derivatives at the bottom, of degree N + m.
template <scalar T>
endpoint_approximant<T> endpoint_from_top(const fundamental_arc<T>& arc, int order, int conditions) {
    return {arc_series(arc, order), arc_endpoint(arc, conditions)};
}

/// The two-point expansion, m = N + 1.
template <scalar T>
endpoint_approximant<T> two_point_from_top(const fundamental_arc<T>& arc, int order) {
    return endpoint_from_top(arc, order, order + 1);
}

/// T*^2/(4 K~' R), the factor of the error of the two-point expansion per N, at both ends; above 1 it diverges.
template <scalar T>
T two_point_rate(const top_bounds<T>& b) {
    using std::sqrt;
    const T height = sqrt((b.radius - b.effective_period) * (b.radius + b.effective_period));
    return b.effective_period * b.rho / (height * 4);
}

/// The bound above of the norm of theta - theta_N,m on [0, T*]. Throws error when N + 1 + m < 4 or m < 0.
template <scalar T>
T endpoint_norm(const top_bounds<T>& b, int order, int conditions) {
    using std::pow;
    const int n = order + 1;
    const int m = conditions;
    const T gap = 1 - b.rho;
    // (n/(n+m))^n (m/(n+m))^m
    const T largest = pow(T(T(n) / (n + m)), n) * (m == 0 ? T(1) : T(pow(T(T(m) / (n + m)), m)));
    return b.coefficient(n + m) * pow(b.rho, n + m) / pow(gap, m + 1) * largest;
}

}  // namespace libration::pendulum
