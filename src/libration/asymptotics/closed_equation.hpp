// The equation that an unknown, or a function whose derivative or primitive it is, satisfies by itself.
#pragma once

#include <cstddef>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

struct closed_equation {
    explicit_system system;
    /// The quantity is the derivative of this order of `shown`; -1: a primitive of it.
    int shift = 0;
    /// The unknown or lower derivative that the shift refers to, among all of the system.
    std::size_t shown = 0;
};

/// For a derivative of an unknown: its equations alone, if they are one equation with a chart; otherwise of f = y or f = y', a function of the
/// unknowns of their polynomial form z' = g(z), one of
///     f' = C f^2 + B f + A,    f'' = a3 f^3 + a2 f^2 + b f + c
/// with rational A, B, C, a3, a2, c and a first integral b, if that holds identically in z:
///     f' - C f^2 - B f - A = 0,    f f''' - f' f'' - 2 a3 f^3 f' - a2 f^2 f' + c f' = 0,
/// the second of which means that (f'' - a3 f^3 - a2 f^2 - c)/f is constant. So f = th' = w of th'' = -sin(th) has w'' = b w - w^3/2. The
/// equations themselves if none of this is found.
closed_equation closed_equation_of(const explicit_system& system, std::size_t unknown, int derivative);

}  // namespace libration::ode
