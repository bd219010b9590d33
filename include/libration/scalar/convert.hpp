// Direct conversions between scalars, not through double: exact to wide, correctly rounded to narrow.
#pragma once

#include <cmath>

#include "libration/scalar/constants.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

/// x in the wide arithmetic of its type, exactly, and in no less than the working precision: Boost computes
/// `widen(x) - y` in the precision of the temporary.
template <has_scalar_traits T>
wide_t<T> widen(const T& x) {
    return scalar_traits<T>::widen(x);
}

/// x rounded to nearest in T; to mpfr of the working precision if T is mpfr. Below the normal range of quad it is
/// rounded twice. A ball is rounded to the working precision, its radius enlarged by the rounding error of its
/// midpoint.
template <has_scalar_traits T>
T narrow(const wide_t<T>& x) {
    return scalar_traits<T>::narrow(x);
}

/// x in another scalar, rounded to nearest.
template <rounding_scalar To, rounding_scalar From>
To convert(const From& x) {
    if constexpr (std::same_as<To, From> && fixed_scalar<To>) {
        return x;
    } else {
        return narrow<To>(widen(x));
    }
}

/// The fraction q in T, within half a unit in the last place and 2^-64 of it; on balls an enclosure.
template <has_scalar_traits T>
T from_rational(const rational& q) {
    return scalar_traits<T>::from_rational(q);
}

/// The integer nearest to q, ties to even.
integer nearest_integer(const rational& q);

/// The integer nearest to x, ties to even.
inline integer nearest_integer(const mpfr& x) {
    integer result;
    mpfr_get_z(result.backend().data(), handle(x), MPFR_RNDN);
    return result;
}

/// The sign of a wide value on which a branch depends: -1, 0 or 1. A rounding scalar's value is treated as exact.
inline int decided_sign(const mpfr& x) { return mpfr_sgn(handle(x)); }

/// An exact number close to x: x itself for a rounding scalar, the midpoint of a ball. For a free choice (a scale, a
/// point), so that the following computation has one uncertainty less.
template <has_scalar_traits T>
T midpoint(const T& x) {
    return scalar_traits<T>::midpoint(x);
}

/// Whether a < b is certain: for balls, whether every number of a is below every number of b; computed values of a
/// rounding scalar are treated as exact.
template <has_scalar_traits T>
bool certainly_less(const T& a, const T& b) {
    return scalar_traits<T>::certainly_less(a, b);
}

/// An assumption of a formula, |x| < limit: on a rounding scalar it holds within rounding; on a ball it has to be
/// proved, or precision_exhausted is thrown, because the formula would enclose a different value.
template <has_scalar_traits T>
void require_below(const T& x, const T& limit, const char* what) {
    if constexpr (proved_scalar<T>) {
        if (!certainly_less(T(abs(x)), limit)) {
            throw precision_exhausted(what);
        }
    }
}

}  // namespace libration
