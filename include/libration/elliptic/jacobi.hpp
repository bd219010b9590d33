// The Jacobi elliptic functions sn, cn, dn and the amplitude am of real argument, by descending Landen.
//
// The functions are carried as the pair t = sn/cn and d = dn. From level n+1 to level n of the chain [DLMF 22.7.2 -
// 22.7.4 with k_1 = (a_n - b_n)/(a_n + b_n), and 1 = c^2 + s^2 substituted where the usual forms subtract]:
//     t_n = (a_n/a_{n+1}) t/d,   d_n = (a_{n+1} + b_n t^2) / (a_{n+1} + a_n t^2),
// and at the end cn = 1/sqrt(1 + t^2), sn = t cn. Between -K/2 and K/2 nothing is subtracted, so sn, cn and dn keep
// their relative precision (up to their condition |u f'/f|) from k = 0 to k' = 1e-100 and below; other arguments are
// moved there by quarter periods. Carrying sn and cn separately doubles the error of sn^2 + cn^2 at every level.
#pragma once

#include <algorithm>

#include "libration/elliptic/complete_integral.hpp"
#include "libration/scalar/compiled.hpp"

namespace libration::elliptic {

/// The three functions at one argument.
template <scalar T>
struct jacobi_values {
    T sn;
    T cn;
    T dn;
};

/// d_n from the t^2 of level n+1. On balls with b_n close to a_n it is 1 minus a small term, whose radius is small: the
/// quotient ignores the dependence between its parts, and widens balls threefold per level.
template <scalar T>
T next_dn(const T& square, int n, const landen_chain<T>& chain) {
    const T below = chain.a(n + 1) + chain.a(n) * square;
    if constexpr (proved_scalar<T>) {
        if (certainly_less(chain.a(n), T(chain.b(n) * 2))) {
            return 1 - (chain.a(n) - chain.b(n)) * square / below;
        }
    }
    return (chain.a(n + 1) + chain.b(n) * square) / below;
}

/// sn, cn, dn at |u| <= K/2, from an existing chain; on balls at |u| < K, which must be proved (precision_exhausted).
/// Two divisions per level.
///
/// At the last level, am' = dn is in [k_N', 1] and 1 - k_N' = k_N^2/(1 + k_N'): so |am(v, k_N) - v| <= k_N^2 |v| and 1
/// - dn <= k_N^2 for every v. There v = a_N u, and |v| < pi/2 proves |u| < K, since a_N >= agm(1, k') = pi/(2K); then
/// cos am > 0 at every level, which determines the signs of t and cn.
template <scalar T>
jacobi_values<T> jacobi_at(const T& u, const landen_chain<T>& chain) {
    using std::sqrt;
    using std::tan;
    const int last = chain.levels();
    const T angle = u * chain.a(last);
    if constexpr (proved_scalar<T>) {
        require_below(angle, T(pi<T>() / 2), "the quarter of an argument");
    }
    const T left_out = chain.last_parameter();
    T t = tan(enclose(angle, T(left_out * angle)));
    T d = enclose(T(1), left_out);
    for (int n = last - 1; n >= 0; --n) {
        const T square = t * t;
        t *= chain.a(n) / (chain.a(n + 1) * d);
        d = next_dn(square, n, chain);
    }
    const T cn = 1 / sqrt(1 + t * t);
    return {t * cn, cn, d};
}

/// The functions at u + quarters * K from those at u [DLMF 22.4.1]; quarters in 0 .. 3.
template <scalar T>
jacobi_values<T> advance_quarters(const jacobi_values<T>& at, int quarters, const T& complement) {
    const jacobi_values<T> near =
        quarters % 2 == 0 ? at : jacobi_values<T>{at.cn / at.dn, -complement * at.sn / at.dn, complement / at.dn};
    return quarters < 2 ? near : jacobi_values<T>{-near.sn, -near.cn, near.dn};
}

/// A real argument as quarter * K + offset with |offset| <= K/2 (within rounding).
template <class T>
struct reduced_argument {
    integer quarter;
    T offset;
};

/// quarter mod 4, in 0 .. 3.
inline int quarter_of_four(const integer& quarter) {
    const int remainder = static_cast<int>(quarter % 4);
    return remainder < 0 ? remainder + 4 : remainder;
}

/// Reduces u modulo K, with K to as many more digits as u has before its point: u and the given one of k, k' are taken
/// as exact numbers of any size.
template <scalar T>
reduced_argument<T> reduce_argument(const T& u, const modulus<T>& m) {
    const long before_point = std::max(0L, binary_exponent(u));
    reduced_argument<wide_t<T>> wide;
    {
        const precision_scope scope(decimal_digits(digits<T>() + 2 * before_point + 64));
        const auto quarter_period = complete_integral(wide_modulus(m));
        wide.quarter = nearest_integer(widen(u) / quarter_period);
        wide.offset = widen(u) - from_rational<wide_t<T>>(rational(wide.quarter)) * quarter_period;
    }
    return {wide.quarter, narrow<T>(wide.offset)};
}

/// sn, cn, dn at any real u, with u and the modulus taken as exact: a few units in the last place each, times the
/// condition |offset f'/f| <= K of cn and dn, because the offset from the nearest quarter is rounded to T once (at k' =
/// 1e-100, K is 232). Throws error at k = 1.
template <scalar T>
jacobi_values<T> jacobi(const T& u, const modulus<T>& m) {
    const auto reduced = reduce_argument(u, m);
    const auto near = jacobi_at(reduced.offset, landen_chain<T>(m));
    return advance_quarters(near, quarter_of_four(reduced.quarter), m.complement);
}

/// am(u, k), unwrapped and odd: am(u + 2K) = am(u) + pi. For u = quarter K + offset, quarter >= 0 and h = quarter div 2
/// it is h pi + atan2(sn, cn) at the remainder, without cancellation. A few units in the last place.
template <scalar T>
T amplitude(const T& u, const modulus<T>& m) {
    using std::atan2;
    const auto reduced = reduce_argument(u, m);
    const int sign = reduced.quarter < 0 ? -1 : 1;
    const integer quarter = abs(reduced.quarter);
    const int odd = quarter_of_four(quarter) % 2;
    const auto near = jacobi_at(T(reduced.offset * sign), landen_chain<T>(m));
    const auto rest = advance_quarters(near, odd, m.complement);
    const integer halves = (quarter - odd) / 2;
    return (from_rational<T>(rational(halves)) * pi<T>() + atan2(rest.sn, rest.cn)) * sign;
}

// Compiled once, in libration::libration.
#ifdef LIBRATION_COMPILED
#define LIBRATION_DECLARE(T) extern template jacobi_values<T> jacobi_at(const T&, const landen_chain<T>&);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DECLARE)
#undef LIBRATION_DECLARE
#endif

}  // namespace libration::elliptic
