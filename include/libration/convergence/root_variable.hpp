// Conversion of the result of a radius test for a series in powers of a root of the variable to the variable itself.
#pragma once

#include <algorithm>
#include <string>

#include "libration/convergence/radius_estimate.hpp"
#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::convergence {

/// The result for a list in powers of s = t^(1/q), q >= 1, as one in t: the radius and the position are raised to the
/// power q, the uncertainty u becomes (R + u)^q - R^q; exponents are unchanged, since t - t0 is linear in s - s0 if s0
/// is nonzero. Several singularities in s may have the same t, on
/// different sheets: the note of a verdict gives their position in s. Rounding error of a power.
template <rounding_scalar T>
radius_estimate<T> in_powers_of_root(radius_estimate<T> of, int q) {
    const auto raised = [q](const T& x) {
        T power(1);
        for (int i = 0; i < q; ++i) {
            power *= x;
        }
        return power;
    };
    if (q == 1 || !of.radius) {
        return of;
    }
    const T radius = raised(*of.radius);
    of.uncertainty = T(raised(T(*of.radius + of.uncertainty)) - radius);
    of.nearer = T(radius - raised(T(std::max(T(0), T(*of.radius - of.nearer)))));
    std::string note = "in powers of t^(1/" + std::to_string(q) + ")";
    if (of.position) {
        const complex_number<T> root = *of.position;
        note += ", where the singularity is at " + to_decimal(root.re, 4) +
                (root.im == 0 ? "" : " + " + to_decimal(root.im, 4) + "i");
        for (int i = 1; i < q; ++i) {
            of.position = *of.position * root;
        }
    }
    of.radius = radius;
    if (of.method == "verdict") {
        of.note += (of.note.empty() ? "" : "; ") + note;
    }
    return of;
}

}  // namespace libration::convergence
