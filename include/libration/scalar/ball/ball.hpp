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

#include "libration/scalar/scalar.hpp"

static_assert(libration::scalar<libration::ball>);

#include "libration/scalar/ball/complex_values.hpp"
