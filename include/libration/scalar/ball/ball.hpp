// The scalar `ball`: rigorous enclosures of any precision through FLINT/Arb [Arb], FLINT 2.9 with Arb 2.23 or FLINT 3.
// A program that includes this header links the CMake target libration::ball; no header outside scalar/ball*.hpp
// includes it.
//
// Every result contains the exact one, assuming that GMP, MPFR, FLINT/Arb and the compiler are correct, and that
// truncated loops end in enclose(value, bound) with a bound proved in their header. The precision only determines how
// narrow a result is: if it does not suffice (for a sign, a branch, the requested digits), precision_exhausted is
// thrown, and the caller repeats with more digits.
#pragma once

#include "libration/scalar/ball/traits.hpp"
#include "libration/scalar/enclose.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/exact.hpp"

namespace libration {

/// An enclosure of the exact number. Throws error for multiples of the period, which is defined only for a motion.
template <proved_scalar T>
T from_exact(const exact& number) {
    switch (number.measure) {
        case unit::one: return from_rational<T>(number.coefficient);
        case unit::period:
            throw error(error_kind::argument, "number", number.text, "is a multiple of a period, not a number");
        case unit::expression: break;
        case unit::pi:
        case unit::degree: return from_rational<T>(number.in_pi()) * pi<T>();
    }
    if (number.has_periods()) {
        throw error(error_kind::argument, "number", number.text, "is a multiple of a period, not a number");
    }
    const number_bounds within = number.formula->narrowed(T::working_bits() + 8);
    T result;
    arb_set_interval_mpfr(result.handle(), handle(within.lower), handle(within.upper), T::working_bits());
    return result;
}

}  // namespace libration

#include "libration/scalar/scalar.hpp"

static_assert(libration::scalar<libration::ball>);

#include "libration/scalar/ball/complex_values.hpp"
