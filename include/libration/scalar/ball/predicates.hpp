// Predicates of balls and decisions based on them: a proved result, or none.
#pragma once

#include <algorithm>

#include "libration/scalar/ball/value.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

inline bool is_finite(const ball& x) { return arb_is_finite(x.handle()) != 0; }
inline bool contains_zero(const ball& x) { return arb_contains_zero(x.handle()) != 0; }
/// Whether it is a single number, with radius 0.
inline bool is_exact(const ball& x) { return arb_is_exact(x.handle()) != 0; }
/// Whether every number of `inside` is one of `outside`.
inline bool contains(const ball& outside, const ball& inside) {
    return arb_contains(outside.handle(), inside.handle()) != 0;
}
inline bool overlaps(const ball& a, const ball& b) { return arb_overlaps(a.handle(), b.handle()) != 0; }

/// The midpoint as an mpfr, exactly. Throws error of the kind range beyond the exponents of MPFR.
inline mpfr midpoint_of(const ball& x) {
    const slong bits = std::max(arb_bits(x.handle()), ball::working_bits());
    const precision_scope enough(decimal_digits(static_cast<long>(bits)));
    mpfr result;
    if (arf_get_mpfr(handle(result), arb_midref(x.handle()), MPFR_RNDN) != 0) {
        throw error(error_kind::range, "the midpoint of a ball", "", "is outside the range of mpfr");
    }
    return result;
}

/// An upper bound on the radius, as an exact ball.
inline ball radius_of(const ball& x) {
    ball result;
    arf_set_mag(arb_midref(result.handle()), arb_radref(x.handle()));
    return result;
}

/// The lower end of the ball, rounded down, as an exact ball; minus infinity if there is none.
inline ball lower_bound(const ball& x) {
    ball result;
    arb_get_lbound_arf(arb_midref(result.handle()), x.handle(), ball::working_bits());
    return result;
}

/// The upper end of the ball, rounded up, as an exact ball.
inline ball upper_bound(const ball& x) {
    ball result;
    arb_get_ubound_arf(arb_midref(result.handle()), x.handle(), ball::working_bits());
    return result;
}

/// A ball that contains both.
inline ball hull(const ball& a, const ball& b) {
    ball result;
    arb_union(result.handle(), a.handle(), b.handle(), ball::working_bits());
    return result;
}

/// The sign common to all numbers of a ball; 0 only for the number 0. Throws precision_exhausted if they differ.
inline int decided_sign(const ball& x) {
    if (arb_is_zero(x.handle()) != 0) {
        return 0;
    }
    if (arb_is_positive(x.handle()) == 0 && arb_is_negative(x.handle()) == 0) {
        throw precision_exhausted("a sign");
    }
    return arb_is_positive(x.handle()) != 0 ? 1 : -1;
}

/// The integer nearest to the midpoint, ties to even: a choice between neighbours on which no proof depends. Throws
/// precision_exhausted for an unbounded ball.
inline integer nearest_integer(const ball& x) {
    if (!is_finite(x)) {
        throw precision_exhausted("a nearest integer");
    }
    integer result;
    fmpz_t nearest;
    fmpz_init(nearest);
    arf_get_fmpz(nearest, arb_midref(x.handle()), ARF_RND_NEAR);
    fmpz_get_mpz(result.backend().data(), nearest);
    fmpz_clear(nearest);
    return result;
}

}  // namespace libration
