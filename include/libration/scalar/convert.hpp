// Conversions between scalars without a detour through double: exact to wide, correctly rounded to narrow.
#pragma once

#include <algorithm>
#include <cmath>

#include "libration/scalar/constants.hpp"
#include "libration/scalar/precision.hpp"

namespace libration {

/// The arithmetic of run-time precision that serves T where T itself has too few digits (a huge time, say).
template <class T>
struct wide_scalar;
template <rounding_scalar T>
struct wide_scalar<T> {
    using type = mpfr;
};
template <proved_scalar T>
struct wide_scalar<T> {
    using type = T;
};
template <class T>
using wide_t = typename wide_scalar<T>::type;

/// x in the wide arithmetic of its type, exactly, and in no less than the working precision: Boost computes
/// `widen(x) - y` in the precision of the temporary.
template <rounding_scalar T>
mpfr widen(const T& x) {
    if constexpr (std::same_as<T, mpfr>) {
        mpfr result;
        if (mpfr_get_prec(handle(x)) >= mpfr_get_prec(handle(result))) {
            return x;
        }
        mpfr_set(handle(result), handle(x), MPFR_RNDN);
        return result;
    } else if constexpr (std::same_as<T, quad>) {
        if (!(boost::multiprecision::isfinite)(x)) {
            return mpfr(static_cast<double>(x));
        }
        const precision_scope enough(
            std::max(working_digits(), decimal_digits(3 * std::numeric_limits<double>::digits)));
        int exponent = 0;
        quad rest = frexp(x, &exponent);
        mpfr sum(0);
        for (int piece = 0; piece < 3; ++piece) {
            const auto head = static_cast<double>(rest);
            rest -= head;
            sum += head;
        }
        return ldexp(sum, exponent);
    } else {
        const precision_scope enough(std::max(working_digits(), decimal_digits(std::numeric_limits<T>::digits)));
        return mpfr(x);
    }
}

/// x rounded to nearest in T; to mpfr of the working precision where T is mpfr. Below the normal range of quad it is
/// rounded twice.
template <rounding_scalar T>
T narrow(const mpfr& x) {
    if constexpr (std::same_as<T, mpfr>) {
        mpfr result;
        mpfr_set(handle(result), handle(x), MPFR_RNDN);
        return result;
    } else if constexpr (std::same_as<T, quad>) {
        if (mpfr_regular_p(handle(x)) == 0) {
            return quad(mpfr_get_d(handle(x), MPFR_RNDN));
        }
        mpfr rest = x;
        mpfr_prec_round(handle(rest), digits<quad>(), MPFR_RNDN);
        const auto exponent = mpfr_get_exp(handle(rest));
        mpfr_set_exp(handle(rest), 0);
        quad sum = 0;
        for (int piece = 0; piece < 3; ++piece) {
            const double head = mpfr_get_d(handle(rest), MPFR_RNDN);
            mpfr_sub_d(handle(rest), handle(rest), head, MPFR_RNDN);
            sum += head;
        }
        return ldexp(sum, static_cast<int>(exponent));
    } else if constexpr (std::same_as<T, long double>) {
        return mpfr_get_ld(handle(x), MPFR_RNDN);
    } else {
        return mpfr_get_d(handle(x), MPFR_RNDN);
    }
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

/// The fraction q in T, within half a unit in the last place and 2^-64 of it.
template <rounding_scalar T>
T from_rational(const rational& q) {
    if constexpr (std::same_as<T, mpfr>) {
        mpfr result;
        mpfr_set_q(handle(result), q.backend().data(), MPFR_RNDN);
        return result;
    } else {
        const precision_scope guard(decimal_digits(digits<T>() + 64));
        return narrow<T>(from_rational<mpfr>(q));
    }
}

/// The integer nearest to x, ties to even.
inline integer nearest_integer(const mpfr& x) {
    integer result;
    mpfr_get_z(result.backend().data(), handle(x), MPFR_RNDN);
    return result;
}

/// The sign of a wide value that decides a branch: -1, 0 or 1. A rounding scalar takes its value at its word.
inline int decided_sign(const mpfr& x) { return mpfr_sgn(handle(x)); }

/// A number next to x that is exact: x itself for a rounding scalar, the midpoint of a ball. For a choice that is free
/// (a scale, a point), so that what follows has one uncertainty less.
template <rounding_scalar T>
T midpoint(const T& x) {
    return x;
}

/// Whether a < b is certain: a rounding scalar takes its values at their word.
template <rounding_scalar T>
bool certainly_less(const T& a, const T& b) {
    return a < b;
}

/// What a formula takes for granted, |x| < limit: on a rounding scalar it holds within rounding; on a ball it has to be
/// certain, or precision_exhausted is thrown, because the formula would enclose something else.
template <class T>
requires rounding_scalar<T> || proved_scalar<T>
void require_below(const T& x, const T& limit, const char* what) {
    if constexpr (proved_scalar<T>) {
        if (!certainly_less(T(abs(x)), limit)) {
            throw precision_exhausted(what);
        }
    }
}

}  // namespace libration
