// Templates that libration::libration compiles once for the rounding scalars, so that no other source has to. The
// target defines LIBRATION_COMPILED; without it, in a header-only program, each source instantiates what it uses.
#pragma once

#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/quad.hpp"

/// FOR_SCALAR(T) for each rounding scalar.
#define LIBRATION_FOR_ROUNDING_SCALARS(FOR_SCALAR) \
    FOR_SCALAR(double)                             \
    FOR_SCALAR(long double)                        \
    FOR_SCALAR(libration::quad)                    \
    FOR_SCALAR(libration::mpfr)
