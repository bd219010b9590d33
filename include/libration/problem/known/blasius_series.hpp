// Blasius' boundary layer f''' + f f''/2 = 0, f(0) = f'(0) = 0, f'(infinity) = 1: a series whose singularities are not
// fractional powers.
#pragma once

#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/number/exact.hpp"

namespace libration::convergence {

/// f''(0) and the radius of convergence, to 100 digits by tests/reference/blasius.py; neither has a closed form. The
/// first 63 digits of f''(0) are those of OEIS A256522, 5.6900380545 is Boyd's radius [Boyd1999].
inline constexpr const char* blasius_curvature =
    "0.3320573362151962989371800620105829665470935614126798181004475640198724174018064405070490731855146369";
inline constexpr const char* blasius_radius =
    "5.690038054522639997479095712414787877240800361151316761657276209931428433581121614660836232099035461";

/// f of [Blasius], with powers 2, 5, 8, ... only; correct to the digits of f''(0), 100. O(N^2).
///
/// There are three nearest singularities, R e^(+-i pi/3) and -R. Near each f = 6/u + a u^(1+i sqrt 2) + b u^(1-i sqrt
/// 2) + ... with the distance u: a simple pole with superposed branch points, from p^2 - 2p + 3 = 0 for a perturbation
/// u^p.
template <rounding_scalar T>
series::power_series<T> blasius_series(int order) {
    const ode::explicit_system layer(
        ode::parse("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = " + std::string(blasius_curvature)));
    const ode::tape made = ode::tape::about_start(layer);
    ode::taylor_expansion<T> expansion(made, order);
    expansion.about_start();
    return expansion.series_of(0);
}

}  // namespace libration::convergence
