// The traits of the scalar `mpfr`, whose precision is that of the current precision_scope.
#pragma once

#include "libration/scalar/precision_scope.hpp"
#include "libration/scalar/traits.hpp"

namespace libration {

template <>
struct scalar_traits<mpfr> : default_scalar_traits<mpfr> {
    /// Those that Boost assigns to a number of working_digits(), recomputed when these change: a new number allocates
    /// memory.
    static int digits() {
        struct known_digits {
            unsigned decimal = 0;
            int binary = 0;
        };
        thread_local known_digits last;
        if (const unsigned decimal = mpfr::thread_default_precision(); decimal != last.decimal) {
            last = {decimal, static_cast<int>(mpfr_get_prec(handle(mpfr())))};
        }
        return last.binary;
    }

    static mpfr pi() {
        mpfr value;
        mpfr_const_pi(handle(value), MPFR_RNDN);
        return value;
    }

    static mpfr from_rational(const rational& q) {
        mpfr result;
        mpfr_set_q(handle(result), q.backend().data(), MPFR_RNDN);
        return result;
    }

    static long binary_exponent(const mpfr& x) {
        return mpfr_zero_p(handle(x)) != 0 ? exponent_of_zero : static_cast<long>(mpfr_get_exp(handle(x)));
    }

    /// Exactly, and in no less than the working precision.
    static mpfr widen(const mpfr& x) {
        mpfr result;
        if (mpfr_get_prec(handle(x)) >= mpfr_get_prec(handle(result))) {
            return x;
        }
        mpfr_set(handle(result), handle(x), MPFR_RNDN);
        return result;
    }

    /// Rounded to the working precision.
    static mpfr narrow(const mpfr& x) {
        mpfr result;
        mpfr_set(handle(result), handle(x), MPFR_RNDN);
        return result;
    }

    static void add_product(mpfr& sum, const mpfr& a, const mpfr& b) {
        mpfr_fma(handle(sum), handle(a), handle(b), handle(sum), MPFR_RNDN);
    }

    /// sum_i x[i x_step] y[i y_step], i < count, in fixed point and rounded once, to the working precision p: the error
    /// is at most half a unit in the last place and 2^(-p-30) of the largest product. O(count). Compiled once: a program
    /// of the headers alone adds the products one after the other (inner_product.hpp).
#ifdef LIBRATION_COMPILED
    static mpfr sum_of_products(const mpfr* x, int x_step, const mpfr* y, int y_step, int count);
#endif

    /// At the precision of the sum, without the two temporaries of the operators: a third of their time at 50 digits.
    static void horner_step(mpfr& sum, const mpfr& x, const mpfr& next) {
        mpfr_mul(handle(sum), handle(sum), handle(x), MPFR_RNDN);
        mpfr_add(handle(sum), handle(sum), handle(next), MPFR_RNDN);
    }
};

}  // namespace libration
