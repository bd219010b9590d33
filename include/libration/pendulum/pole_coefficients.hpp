// The Taylor coefficients from the top as sums over the singularities: beyond the first few hundred each costs the same.
#pragma once

#include <algorithm>
#include <vector>

#include "libration/pendulum/resummation.hpp"
#include "libration/pendulum/singularities.hpp"

namespace libration {

/// The poles of the first quadrant nearest to the top, in units of T*: (2p+1) + i (2q+1) K~'/T*, each with the sign of
/// its part of n a_n T*^n/8.
template <rounding_scalar T>
struct nearest_poles {
    struct pole {
        T re;
        T im;
        int sign;
    };
    std::vector<pole> kept;
    T next;  ///< no pole that is left out is nearer than this
    T sum;   ///< bound of S4, the sum of |z|^-4 over all poles

    /// Those that a_n needs for n >= first, to a rounding of T in 8/(n R^n): by theorem A1 the others add at most
    /// (2/n) next^(4-n) S4, S4 <= pi^4/(64 (K~'/T*)^2).
    static nearest_poles of(const descent<T>& d, int first) {
        using std::pow;
        using std::sqrt;
        const T height = singularity_height(d.o) / d.effective_period;
        const T half_turn_squared = pi<T>() * pi<T>();
        const T fourth = half_turn_squared * half_turn_squared / (height * height * 64);
        const T square = 1 + height * height;
        const mpfr beyond = widen(T(square * square * fourth / epsilon<T>()));
        const mpfr reach = sqrt(widen(square)) * pow(beyond, mpfr(mpfr(1) / (first - 4)));
        nearest_poles result{{}, narrow<T>(reach), fourth};
        const bool rotates = d.o.regime == regime::rotation;
        for (int p = 0; 2 * p + 1 <= reach; ++p) {
            for (int q = 0; widen(T(height * (2 * q + 1))) <= reach; ++q) {
                const int sign = rotates ? (q % 2 == 0 ? -1 : 1) : ((p + q) % 2 == 0 ? 1 : -1);
                result.kept.push_back({T(2 * p + 1), T(height * (2 * q + 1)), sign});
            }
        }
        return result;
    }
};

/// a_n T*^n, n = 0 .. N, about the top: the first four a digit of T by descent_series(), the others as
///     a_n = +-(8/n) sum_{p,q>=0} (-1)^.. Im z_pq^-n
/// [theorem A, from the residues +-2i of omega], with the poles that nearest_poles keeps. Relative to 8/(n R^n) an error
/// of n epsilon. O(N) for the poles of a few columns. Not for balls: a step of a turning power widens rectangles of them, up
/// to sqrt 2 times.
template <rounding_scalar T>
power_series<T> descent_series_by_poles(const descent<T>& d, int order) {
    const int first = std::max(64, static_cast<int>(4 * decimal_digits(digits<T>())));
    power_series<T> a = descent_series(d, std::min(order, first));
    if (order <= first) {
        return a;
    }
    using std::pow;
    const int parity = d.o.regime == regime::rotation ? 1 : 0;
    const int start = first + 1 + ((first + 1) % 2 == parity ? 0 : 1);
    const auto poles = nearest_poles<T>::of(d, start);
    auto sums = power_series<T>::zero(order);
    for (const auto& pole : poles.kept) {
        // z^-start by squaring, then steps of z^-2.
        const T square = pole.re * pole.re + pole.im * pole.im;
        const T re = pole.re / square;
        const T im = -pole.im / square;
        const T step_re = re * re - im * im;
        const T step_im = re * im * 2;
        T power_re(1);
        T power_im(0);
        const auto multiply = [&](const T& by_re, const T& by_im) {
            const T next_re = power_re * by_re - power_im * by_im;
            power_im = power_re * by_im + power_im * by_re;
            power_re = next_re;
        };
        if (parity == 1) {
            multiply(re, im);
        }
        for (int n = parity; n < start; n += 2) {
            multiply(step_re, step_im);
        }
        for (int n = start; n <= order; n += 2) {
            sums[n] += power_im * pole.sign;
            multiply(step_re, step_im);
        }
    }
    const T shrink = 1 / (poles.next * poles.next);
    T left_out = pow(poles.next, 4 - start) * poles.sum * 2;
    for (int n = first + 1; n <= order; ++n) {
        const bool present = n % 2 == parity;
        a.push_back(present ? enclose(T(sums[n] * 8 / n), T(left_out / n)) : T(0));
        left_out = present ? T(left_out * shrink) : left_out;
    }
    return a;
}

}  // namespace libration
