// The scalar `mpfr`: MPFR numbers of run-time precision through Boost.Multiprecision [MPFR, Boost.Multiprecision].
//
// Precision rules, as in Boost: a new value takes the thread's working precision, a copy keeps the precision of its
// source, and an operation works at the largest of the working precision and the precisions of its operands; but one
// with a temporary operand computes into that temporary, in its precision. A value computed in a narrow scope and
// stored is therefore never more precise than that scope, and nothing here caches a constant; and a function that
// returns an mpfr returns it in at least the working precision of its caller, as widen() and narrow() do.
#pragma once

#include <mpfr.h>

#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace libration {

/// Binary floating point of run-time precision; expression templates are off, so `auto` is safe.
using mpfr = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;
/// Exact integers.
using integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
/// Exact fractions, always in lowest terms.
using rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// The underlying MPFR handle, for calls that Boost does not wrap.
inline mpfr_srcptr handle(const mpfr& x) { return x.backend().data(); }
inline mpfr_ptr handle(mpfr& x) { return x.backend().data(); }

}  // namespace libration
