// Blasius' boundary layer f''' + f f''/2 = 0, f(0) = f'(0) = 0, f'(infinity) = 1: a series whose singularities are no
// fractional powers.
#pragma once

#include "libration/scalar/exact.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration::convergence {

/// f''(0) and the radius of convergence, to 100 digits by tests/reference/blasius.py; neither has a closed form. The
/// first 63 digits of f''(0) are those of OEIS A256522, 5.6900380545 is Boyd's radius [Boyd1999].
inline constexpr const char* blasius_curvature =
    "0.3320573362151962989371800620105829665470935614126798181004475640198724174018064405070490731855146369";
inline constexpr const char* blasius_radius =
    "5.690038054522639997479095712414787877240800361151316761657276209931428433581121614660836232099035461";

/// f = sum c_k t^(3k+2), c_0 = f''(0)/2, 2 (3k+2)(3k+1) 3k c_k = -sum_{i<k} (3i+2)(3i+1) c_i c_{k-1-i} [Blasius]; right
/// to the digits of f''(0), 100. O(N^2).
///
/// Nearest are three singularities, R e^(+-i pi/3) and -R. Near each f = 6/u + a u^(1+i sqrt 2) + b u^(1-i sqrt 2) +
/// ... with the distance u: a simple pole with branch points upon it, as p^2 - 2p + 3 = 0 for a power u^p that disturbs
/// it.
template <rounding_scalar T>
series::power_series<T> blasius_series(int order) {
    auto a = series::power_series<T>::zero(order);
    series::power_series<T> c(std::vector<T>{T(from_exact<T>(read_exact(blasius_curvature)) / 2)});
    series::power_series<T> second(std::vector<T>{T(c[0] * 2)});
    for (int k = 0; 3 * k + 2 <= order; ++k) {
        const int n = 3 * k + 2;
        if (k > 0) {
            c.push_back(-product_coefficient(second, c, k - 1) / 2 / n / (n - 1) / (n - 2));
            second.push_back(c[k] * n * (n - 1));
        }
        a[n] = c[k];
    }
    return a;
}

}  // namespace libration::convergence
