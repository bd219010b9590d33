// Coefficients of some special functions: Lambert's W, K(m), Airy's Ai, Bessel's J0, digamma, the inverse Langevin
// function and Blasius' boundary layer.
//
// All return a_0 .. a_N with an error that grows like n eps, or like n^2 eps if a power is involved: known_series.hpp
// computes them in more digits and rounds once.
#pragma once

#include <string>
#include <utility>

#include "libration/convergence/elementary_series.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration::convergence {

/// A value that MPFR computes, `compute(handle)`, rounded to T.
template <rounding_scalar T, class Compute>
T computed_by_mpfr(Compute compute) {
    constexpr long guard_bits = 64;
    const mpfr value = [&] {
        const precision_scope scope(decimal_digits(digits<T>() + guard_bits));
        mpfr result;
        compute(handle(result));
        return result;
    }();
    return narrow<T>(value);
}

/// Lambert's W, W e^W = t: a_n = (-n)^(n-1)/n! [DLMF 4.13.5], a_n/a_{n-1} = -(n/(n-1))^(n-2). O(N) powers.
template <rounding_scalar T>
series::power_series<T> lambert_series(int order) {
    using std::pow;
    return series_by_steps(
        order, T(0), [](const T& before, int n) { return n == 1 ? T(1) : T(-before * pow(T(T(n) / (n - 1)), n - 2)); });
}

/// (1 - sqrt(1 - 4t))/(2t), the Catalan numbers: a_n = 2 (2n - 1)/(n + 1) a_{n-1} [DLMF 26.5.1]. O(N).
template <rounding_scalar T>
series::power_series<T> catalan_series(int order) {
    return series_by_steps(order, T(1), [](const T& before, int n) { return T(before * (4 * n - 2) / (n + 1)); });
}

/// K in powers of the parameter m = k^2: (pi/2) sum ((1/2)_n/n!)^2 m^n [DLMF 19.5.1]. O(N).
template <rounding_scalar T>
series::power_series<T> parameter_series_of_k(int order) {
    return series_by_steps(order, T(pi<T>() / 2), [](const T& before, int n) {
        const T ratio = T(2 * n - 1) / (2 * n);
        return T(before * ratio * ratio);
    });
}

/// J0(t): a_n = -a_{n-2}/n^2 [DLMF 10.2.2]. O(N).
template <rounding_scalar T>
series::power_series<T> bessel_series(int order) {
    auto a = series::power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 2; n <= order; n += 2) {
        a[n] = -a[n - 2] / n / n;
    }
    return a;
}

/// cos t: a_n = -a_{n-2}/(n (n - 1)) [DLMF 4.19.2]. O(N).
template <rounding_scalar T>
series::power_series<T> cosine_series(int order) {
    auto a = series::power_series<T>::zero(order);
    a[0] = T(1);
    for (int n = 2; n <= order; n += 2) {
        a[n] = -a[n - 2] / n / (n - 1);
    }
    return a;
}

/// Ai(t): y'' = t y, Ai(0) = 3^(-2/3)/Gamma(2/3), Ai'(0) = -3^(-1/3)/Gamma(1/3) [DLMF 9.2.3, 9.2.4]. O(N).
template <rounding_scalar T>
series::power_series<T> airy_series(int order) {
    const auto start = [](int thirds) {  // 3^(-p)/Gamma(p), p = thirds/3
        return computed_by_mpfr<T>([&](mpfr_ptr value) {
            const mpfr p = mpfr(thirds) / 3;
            mpfr_gamma(value, handle(p), MPFR_RNDN);
            const mpfr power = pow(mpfr(3), p);
            mpfr_mul(value, value, handle(power), MPFR_RNDN);
            mpfr_ui_div(value, 1, value, MPFR_RNDN);
        });
    };
    auto a = series::power_series<T>::zero(order);
    a[0] = start(2);
    for (int n = 1; n <= order; ++n) {
        a[n] = n == 1 ? T(-start(1)) : n == 2 ? T(0) : T(a[n - 3] / n / (n - 1));
    }
    return a;
}

/// psi(1 + t) = -gamma + sum_{n >= 1} (-1)^(n+1) zeta(n + 1) t^n [DLMF 5.7.4]. O(N) zeta values.
template <rounding_scalar T>
series::power_series<T> digamma_series(int order) {
    auto a = series::power_series<T>::zero(order);
    a[0] = -computed_by_mpfr<T>([](mpfr_ptr value) { mpfr_const_euler(value, MPFR_RNDN); });
    for (int n = 1; n <= order; ++n) {
        const T zeta = computed_by_mpfr<T>(
            [&](mpfr_ptr value) { mpfr_zeta_ui(value, static_cast<unsigned long>(n) + 1, MPFR_RNDN); });
        a[n] = n % 2 == 1 ? zeta : T(-zeta);
    }
    return a;
}

/// The inverse y of the Langevin function, t = coth y - 1/y: y' (y (1 - t^2) - 2 t) = y, from the derivative
/// 1 - t^2 - 2 t/y of t. With s = y^2, odd n >= 3 and s' without a_n in it,
///     2 (n + 2) a_n = (n - 1) s_{n-1} - (n + 1) s'_{n+1},   a_1 = 3, a_3 = 9/5, ... [Itskov2012]. O(N^2).
template <rounding_scalar T>
series::power_series<T> inverse_langevin_series(int order) {
    auto a = series::power_series<T>::zero(order);
    T square(0);
    for (int n = 1; n <= order; n += 2) {
        const T products = square_coefficient(a, n + 1, series::parity::odd);  // a_n is still 0
        a[n] = n == 1 ? T(3) : T((square * (n - 1) - products * (n + 1)) / (2 * (n + 2)));
        square = products + a[1] * a[n] * (n == 1 ? 1 : 2);
    }
    return a;
}

/// The singularity of that inverse in the first quadrant, one of four at the distance 0.9046436794574...: square root
/// branch points, where the derivative 1/y^2 - 1/sinh^2 y of t is 0, first at sinh y = -y, y = 2.25 + 4.21 i
/// [Rickaby2018]; there t = -(1 + cosh y)/y. By Newton's iteration, which starts with eight correct bits and doubles
/// them in each step. To a few eps.
template <rounding_scalar T>
complex_number<T> inverse_langevin_singularity() {
    using std::cos;
    using std::cosh;
    using std::sin;
    using std::sinh;
    complex_number<T> y{T(9) / 4, T(421) / 100};
    const complex_number<T> one{T(1), T(0)};
    const auto cosh_of = [](const complex_number<T>& z) {
        return complex_number<T>{T(cosh(z.re) * cos(z.im)), T(sinh(z.re) * sin(z.im))};
    };
    for (int bits = 8; bits < 4 * digits<T>(); bits *= 2) {
        const complex_number<T> sinh_of_y{T(sinh(y.re) * cos(y.im)), T(cosh(y.re) * sin(y.im))};
        y = y - (sinh_of_y + y) / (cosh_of(y) + one);
    }
    const complex_number<T> t = (one + cosh_of(y)) / y;
    return {t.re < 0 ? T(-t.re) : t.re, t.im < 0 ? T(-t.im) : t.im};
}

}  // namespace libration::convergence
