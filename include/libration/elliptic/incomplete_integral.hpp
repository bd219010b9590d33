// The incomplete elliptic integral of the first kind, F(phi, k) = int_0^phi dx / sqrt(1 - k^2 sin^2 x).
#pragma once

#include <algorithm>
#include <utility>

#include "libration/elliptic/complete_integral.hpp"
#include "libration/scalar/compiled.hpp"

namespace libration::elliptic {

/// The angle of the point (cosine, sine) on the branch closest to `near`; on balls they must be proved to differ by
/// less than pi (precision_exhausted).
template <scalar T>
T angle_next_to(const T& sine, const T& cosine, const T& near) {
    using std::atan2;
    T principal = atan2(sine, cosine);
    const T half_turn = pi<T>();
    if constexpr (proved_scalar<T>) {
        if (certainly_less(abs(T(near - principal)), half_turn)) {
            return principal;
        }
    }
    const integer turns = nearest_integer(widen(T((near - principal) / (half_turn * 2))));
    T angle = principal + from_rational<T>(rational(turns)) * half_turn * 2;
    require_below(T(near - angle), half_turn, "a branch of the arc tangent");
    return angle;
}

/// angle_next_to(), on balls to a few digits more than this number of doublings requires before the point.
template <scalar T>
T branch_angle(const T& sine, const T& cosine, const T& near, int doublings) {
    if constexpr (proved_scalar<T>) {
        const precision_scope few(10 + decimal_digits(doublings));
        return angle_next_to(sine, cosine, near);
    } else {
        return angle_next_to(sine, cosine, near);
    }
}

/// F of the angle in [-pi/2, pi/2] with this sine and this cosine >= 0, which need not be normalised.
///
/// Descending Landen [DLMF 19.8(ii)]: phi_{n+1} = phi_n + delta_n, tan delta_n = (b_n/a_n) tan phi_n, and
/// F = phi_N / (2^N a_N). Sine and cosine are carried as a pair, so that an angle near pi/2 keeps the digits of its
/// cosine, where F is steepest; the increments all have the sign of phi, so their sum does not cancel. The branch of
/// delta_n is the one closest to phi_n: they differ by less than pi/2, and the other branches by more than 3 pi/2; on
/// balls a difference below pi must be proved (precision_exhausted). At the last level the integrand is in [1, 1/k_N'],
/// and 1/k_N' - 1 = k_N^2/(k_N' (1 + k_N')): so the truncation error is at most that fraction of phi_N, k_N' = b_N/a_N.
///
/// On balls the angle of a level only selects a branch, for which a few digits suffice; the last one, which is the
/// result, is recomputed from its sine and cosine, on the branch within pi of it.
template <scalar T>
T incomplete_integral(const T& sine, const T& cosine, const landen_chain<T>& chain) {
    using std::atan2;
    using std::sqrt;
    T s = sine;
    T c = cosine;
    T angle = branch_angle(s, c, T(0), chain.levels());
    for (int n = 0; n < chain.levels(); ++n) {
        const T bs = chain.b(n) * s;
        const T ac = chain.a(n) * c;
        angle += branch_angle(bs, ac, angle, chain.levels());
        T next_s = s * c * (chain.a(n) + chain.b(n));
        T next_c = c * ac - s * bs;
        if constexpr (!proved_scalar<T>) {  // the exponent range of balls admits the doubling at every level
            const T scale = 1 / sqrt((bs * bs + ac * ac) * (s * s + c * c));
            next_s *= scale;
            next_c *= scale;
        }
        s = std::move(next_s);
        c = std::move(next_c);
    }
    if constexpr (proved_scalar<T>) {
        angle = angle_next_to(s, c, angle);
    }
    const int last = chain.levels();
    T doubled = chain.a(last);
    for (int n = 0; n < last; ++n) {
        doubled *= 2;
    }
    const T value = angle / doubled;
    const T ratio = chain.b(last) / chain.a(last);
    return enclose(value, T(value * chain.last_parameter() / (ratio * (1 + ratio))));
}

/// F(phi, k) for any real phi, unwrapped: F(phi + pi) = F(phi) + 2K. A few units in the last place, with phi and the
/// modulus taken as exact: sine and cosine are computed with twice the digits, since near odd multiples of pi/2 with k
/// near 1 the cosine carries all of them. Throws error at k = 1.
template <scalar T>
T incomplete_integral(const T& phi, const modulus<T>& m) {
    using std::cos;
    using std::sin;
    using W = wide_t<T>;
    integer halves;
    W sine;
    W cosine;
    {
        const long before_point = std::max(0L, binary_exponent(phi));
        const precision_scope scope(decimal_digits(2 * (digits<T>() + before_point) + 64));
        halves = nearest_integer(widen(phi) / pi<W>());
        const W rest = widen(phi) - from_rational<W>(rational(halves)) * pi<W>();
        sine = sin(rest);
        cosine = cos(rest);
    }
    const landen_chain<T> chain(m);
    const T part = incomplete_integral(narrow<T>(sine), narrow<T>(cosine), chain);
    return part + from_rational<T>(rational(halves)) * 2 * complete_integral(chain);
}

// Compiled once, in libration::libration.
#ifdef LIBRATION_COMPILED
#define LIBRATION_DECLARE(T) extern template T incomplete_integral(const T&, const T&, const landen_chain<T>&);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DECLARE)
#undef LIBRATION_DECLARE
#endif

}  // namespace libration::elliptic
