// The elementary functions of balls, found by unqualified calls as for every scalar: each result contains all values on
// its arguments, or is unbounded if an argument may be outside the domain.
#pragma once

#include "libration/scalar/ball/relative_functions.hpp"
#include "libration/scalar/ball/value.hpp"

#if __has_include(<flint/arb_hypgeom.h>)
#include <flint/arb_hypgeom.h>
#else
#include <arb_hypgeom.h>
#endif

namespace libration {

/// F(arguments) for a function of function/NAME.hpp that FLINT provides.
template <class F, class... Balls>
requires(std::same_as<Balls, ball>&&...) ball function_at(F /*of*/, const Balls&... arguments) {
    ball result;
    F::real_ball(result.handle(), arguments.handle()..., ball::working_bits());
    return result;
}

/// An Arb function of one argument at the working precision.
template <class Function>
ball apply(const Function& function, const ball& x) {
    ball result;
    function(result.handle(), x.handle(), ball::working_bits());
    return result;
}

inline ball sqrt(const ball& x) { return apply(arb_sqrt, x); }
inline ball exp(const ball& x) { return apply(arb_exp, x); }
inline ball log(const ball& x) { return apply(arb_log, x); }
inline ball sin(const ball& x) { return apply(arb_sin, x); }
inline ball cos(const ball& x) { return apply(arb_cos, x); }
inline ball tan(const ball& x) { return apply(arb_tan, x); }
inline ball asin(const ball& x) { return apply(arb_asin, x); }
inline ball acos(const ball& x) { return apply(arb_acos, x); }
inline ball atan(const ball& x) { return apply(arb_atan, x); }
inline ball sinh(const ball& x) { return apply(arb_sinh, x); }
inline ball cosh(const ball& x) { return apply(arb_cosh, x); }
inline ball tanh(const ball& x) { return apply(arb_tanh, x); }
inline ball asinh(const ball& x) { return apply(arb_asinh, x); }
inline ball acosh(const ball& x) { return apply(arb_acosh, x); }
inline ball atanh(const ball& x) { return apply(arb_atanh, x); }
inline ball log1p(const ball& x) { return apply(arb_log1p, x); }
inline ball expm1(const ball& x) { return apply(arb_expm1, x); }

/// |x|: |midpoint| with the radius of x.
inline ball abs(const ball& x) {
    ball result;
    arb_abs(result.handle(), x.handle());
    return result;
}

/// The angle of the point (x, y) in (-pi, pi]; all of [-pi, pi] if the arguments meet the negative x axis from below.
inline ball atan2(const ball& y, const ball& x) {
    ball result;
    arb_atan2(result.handle(), y.handle(), x.handle(), ball::working_bits());
    return result;
}

/// x^n, n of any sign.
template <std::signed_integral I>
ball pow(const ball& x, I n) {
    ball result;
    fmpz_t exponent;
    fmpz_init(exponent);
    fmpz_set_si(exponent, n);
    arb_pow_fmpz(result.handle(), x.handle(), exponent, ball::working_bits());
    fmpz_clear(exponent);
    return result;
}

/// x^y, x > 0.
inline ball pow(const ball& x, const ball& y) {
    ball result;
    arb_pow(result.handle(), x.handle(), y.handle(), ball::working_bits());
    return result;
}

/// x 2^n, exactly.
template <std::signed_integral I>
ball ldexp(const ball& x, I n) {
    ball result;
    arb_mul_2exp_si(result.handle(), x.handle(), n);
    return result;
}

}  // namespace libration
