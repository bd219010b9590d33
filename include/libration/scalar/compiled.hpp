// Templates that libration::libration compiles once for the scalars that round, so that no other source has to. The
// target defines LIBRATION_COMPILED; without it, in a program of headers alone, each source instantiates what it uses.
#pragma once

#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/quad.hpp"

/// FOR_SCALAR(T) for each scalar that rounds.
#define LIBRATION_FOR_ROUNDING_SCALARS(FOR_SCALAR) \
    FOR_SCALAR(double)                             \
    FOR_SCALAR(long double)                        \
    FOR_SCALAR(libration::quad)                    \
    FOR_SCALAR(libration::mpfr)
