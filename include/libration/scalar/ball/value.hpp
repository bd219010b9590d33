// The class `ball`: a midpoint and a radius of FLINT/Arb [Arb], closed under arithmetic. FLINT is included here and,
// for whole sequences, in ball_polynomial.hpp.
#pragma once

#include <gmp.h>
#include <mpfr.h>  // before FLINT 3, which declares conversions to mpfr only if this is included first

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

#include <concepts>

#include "libration/scalar/precision.hpp"

namespace libration {

/// All numbers from midpoint - radius to midpoint + radius. An operation on balls contains every result of that
/// operation on numbers of them, its midpoint rounded to the working precision of the thread (precision_scope, as for
/// mpfr). An undefined one (1/0, the root of a possibly negative number) is unbounded. Balls have no order and no
/// equality: use certainly_less(), contains_zero(), decided_sign(). A ball may be read by several threads and moved
/// between them.
class ball {
public:
    ball() { arb_init(value_); }
    /// An integer, exactly.
    template <std::signed_integral I>
    explicit ball(I n) : ball() {
        arb_set_si(value_, n);
    }
    /// A floating-point number taken as exact.
    explicit ball(const mpfr& x) : ball() { arf_set_mpfr(arb_midref(value_), libration::handle(x)); }
    /// There is no conversion from double, which represents a typed number only to 53 bits.
    explicit ball(double) = delete;
    ball(const ball& other) : ball() { arb_set(value_, other.value_); }
    ball(ball&& other) noexcept : ball() { arb_swap(value_, other.value_); }
    ball& operator=(const ball& other) {
        arb_set(value_, other.value_);
        return *this;
    }
    ball& operator=(ball&& other) noexcept {
        arb_swap(value_, other.value_);
        return *this;
    }
    ~ball() { arb_clear(value_); }

    /// The underlying FLINT handle, for calls that are not wrapped here.
    arb_srcptr handle() const { return value_; }
    arb_ptr handle() { return value_; }

    /// Bits that an operation rounds its midpoint to: those of an mpfr of the working precision.
    static slong working_bits() {
        // FLINT stores memory and constants per thread: they are freed with the thread.
        thread_local const thread_cleanup at_end;
        static_cast<void>(at_end);
        return static_cast<slong>(boost::multiprecision::detail::digits10_2_2(mpfr::thread_default_precision()));
    }

    ball operator-() const {
        ball result;
        arb_neg(result.value_, value_);
        return result;
    }
    ball& operator+=(const ball& b) {
        arb_add(value_, value_, b.value_, working_bits());
        return *this;
    }
    ball& operator-=(const ball& b) {
        arb_sub(value_, value_, b.value_, working_bits());
        return *this;
    }
    ball& operator*=(const ball& b) {
        arb_mul(value_, value_, b.value_, working_bits());
        return *this;
    }
    ball& operator/=(const ball& b) {
        arb_div(value_, value_, b.value_, working_bits());
        return *this;
    }
    template <std::signed_integral I>
    ball& operator+=(I n) {
        return *this = *this + n;
    }
    template <std::signed_integral I>
    ball& operator-=(I n) {
        return *this = *this - n;
    }
    template <std::signed_integral I>
    ball& operator*=(I n) {
        return *this = *this * n;
    }
    template <std::signed_integral I>
    ball& operator/=(I n) {
        return *this = *this / n;
    }
    friend ball operator+(const ball& a, const ball& b) { return from(arb_add, a, b); }
    friend ball operator-(const ball& a, const ball& b) { return from(arb_sub, a, b); }
    friend ball operator*(const ball& a, const ball& b) { return from(arb_mul, a, b); }
    friend ball operator/(const ball& a, const ball& b) { return from(arb_div, a, b); }

    // With an integer, which is an exact operand.
    template <std::signed_integral I>
    friend ball operator+(const ball& a, I n) {
        return with_integer(arb_add_si, a, n);
    }
    template <std::signed_integral I>
    friend ball operator+(I n, const ball& a) {
        return with_integer(arb_add_si, a, n);
    }
    template <std::signed_integral I>
    friend ball operator-(const ball& a, I n) {
        return with_integer(arb_sub_si, a, n);
    }
    template <std::signed_integral I>
    friend ball operator-(I n, const ball& a) {
        return ball(n) - a;
    }
    template <std::signed_integral I>
    friend ball operator*(const ball& a, I n) {
        return with_integer(arb_mul_si, a, n);
    }
    template <std::signed_integral I>
    friend ball operator*(I n, const ball& a) {
        return with_integer(arb_mul_si, a, n);
    }
    template <std::signed_integral I>
    friend ball operator/(const ball& a, I n) {
        return with_integer(arb_div_si, a, n);
    }
    template <std::signed_integral I>
    friend ball operator/(I n, const ball& a) {
        return ball(n) / a;
    }

private:
    struct thread_cleanup {
        thread_cleanup() = default;
        thread_cleanup(const thread_cleanup&) = delete;
        thread_cleanup& operator=(const thread_cleanup&) = delete;
        ~thread_cleanup() { flint_cleanup(); }
    };

    template <class Operation>
    static ball from(const Operation& operation, const ball& a, const ball& b) {
        ball result;
        operation(result.value_, a.value_, b.value_, working_bits());
        return result;
    }
    template <class Operation>
    static ball with_integer(const Operation& operation, const ball& a, slong n) {
        ball result;
        operation(result.value_, a.value_, n, working_bits());
        return result;
    }

    arb_t value_;
};

}  // namespace libration
